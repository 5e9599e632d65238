//! Pendulums keep their period and their energy.

use super::stage::{falls_through_zero, hang, inertia, largest, period, swing};
use crate::suite::physics::stage::{G, RATES, run, world};
use rapier::prelude::*;

/// Returns the arithmetic-geometric mean.
fn agm(mut a: f64, mut b: f64) -> f64 {
    for _ in 0..8 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    a
}

/// Returns the period `2π √(L/g) / agm(1, cos(θ/2))` of a pendulum that is released at the angle θ. For a
/// body the length is `I / (m L)` with the inertia about the hinge.
pub fn exact_period(length: Real, radius: Real, angle: Real) -> Real {
    let effective = f64::from((inertia(1.0, radius) + length * length) / length);
    let small = 2.0 * core::f64::consts::PI * (effective / f64::from(G)).sqrt();
    (small / agm(1.0, f64::from(0.5 * angle).cos())) as Real
}

#[test]
fn pendulums_have_the_period_of_the_formula() {
    for rate in RATES {
        for degrees in [10.0, 90.0] {
            let angle = Real::to_radians(degrees);
            let mut world = world(rate);
            let bob = hang(&mut world, 1.0, 0.1, angle);
            let crossings =
                falls_through_zero(&mut world, 6, |world| swing(world.bodies[bob].translation()));
            let (found, exact) = (period(&crossings), exact_period(1.0, 0.1, angle));
            let error = (found - exact).abs() / exact;
            println!("period at {degrees}°, {rate} Hz: {found} of {exact}, off by {error:e}");
            // The step is of second order in h ω: an eighth of its square, plus the error of the crossings.
            assert!(error < 2.0e-3, "{degrees}° at {rate} Hz: {found} instead of {exact}");
        }
    }
}

#[test]
fn pendulums_keep_their_swing() {
    for rate in RATES {
        let mut world = world(rate);
        let angle = Real::to_radians(90.0);
        let bob = hang(&mut world, 1.0, 0.1, angle);
        run(&mut world, 28.0);
        let left = largest(&mut world, 2.5, |world| swing(world.bodies[bob].translation()).abs());
        println!("90° after 30 s at {rate} Hz: {}", left.to_degrees());
        assert!(left > 0.95 * angle && left < 1.02 * angle, "{} at {rate} Hz", left.to_degrees());
    }
}
