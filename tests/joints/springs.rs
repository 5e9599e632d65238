//! Springs oscillate with the period of their stiffness, and decay by their damping.

use super::stage::{bob, falls_through_zero, period, post};
use crate::dim::vec;
use crate::suite::physics::stage::{RATES, weightless};
use rapier::prelude::*;

const MASS: Real = 2.0;
const STIFFNESS: Real = 50.0;
const REST: Real = 1.5;
/// Initial elongation.
const PULL: Real = 0.4;

/// Adds a mass on an elongated spring along x.
fn pulled(world: &mut PhysicsWorld, damping: Real) -> RigidBodyHandle {
    let post = post(world, Vector::ZERO);
    let mass = world.insert_body(bob(MASS, 0.1).translation(vec(REST + PULL, 0.0)));
    let spring = SpringJointBuilder::new(Vector::ZERO, Vector::ZERO, REST, STIFFNESS);
    world.insert_impulse_joint(post, mass, spring.damping(damping));
    mass
}

/// Returns the elongation of the spring.
fn stretch(world: &PhysicsWorld, mass: RigidBodyHandle) -> Real {
    world.bodies[mass].translation().x - REST
}

#[test]
fn springs_swing_with_the_period_of_the_formula() {
    for rate in RATES {
        let mut world = weightless(rate);
        let mass = pulled(&mut world, 0.0);
        let found = period(&falls_through_zero(&mut world, 8, |world| stretch(world, mass)));
        let exact = 2.0 * core::f64::consts::PI as Real * (MASS / STIFFNESS).sqrt();
        let error = (found - exact).abs() / exact;
        println!("spring at {rate} Hz: {found} s of {exact}, off by {error:e}");
        // The period of the trapezoidal rule is too long by (h ω)²/12, 4e-4 of it at 30 Hz; crossings are
        // interpolated.
        assert!(error < 2.0e-3, "{found} instead of {exact} at {rate} Hz");
    }
}

#[test]
fn undamped_springs_do_not_die_down() {
    for rate in RATES {
        let mut world = weightless(rate);
        let mass = pulled(&mut world, 0.0);
        let early = maxima(&mut world, mass, 3);
        let late = maxima(&mut world, mass, 40);
        let (first, last) = (early[0], late[late.len() - 1]);
        assert!((last / first - 1.0).abs() < 0.02, "{first} became {last} at {rate} Hz");
    }
}

/// Returns the next maxima of the elongation, each from the parabola through the three highest points.
fn maxima(world: &mut PhysicsWorld, mass: RigidBodyHandle, count: usize) -> Vec<Real> {
    let (mut maxima, mut last) = (Vec::new(), [stretch(world, mass); 2]);
    while maxima.len() < count {
        world.step();
        let now = stretch(world, mass);
        let [before, middle] = last;
        if middle > before && middle >= now && middle > 0.0 {
            let (slope, bend) = (0.5 * (now - before), now - 2.0 * middle + before);
            maxima.push(middle - 0.5 * slope * slope / bend);
        }
        last = [middle, now];
    }
    maxima
}

#[test]
fn damped_springs_die_down_by_the_ratio_of_the_formula() {
    for rate in RATES {
        for ratio in [0.05, 0.2] {
            let mut world = weightless(rate);
            let damping = 2.0 * ratio * (MASS * STIFFNESS).sqrt();
            let mass = pulled(&mut world, damping);
            let maxima = maxima(&mut world, mass, 3);
            let found = maxima[1] / maxima[0];
            // Successive maxima have the ratio exp(-2π ζ / √(1 - ζ²)).
            let exact =
                (-2.0 * core::f64::consts::PI as Real * ratio / (1.0 - ratio * ratio).sqrt()).exp();
            println!("damped {ratio} at {rate} Hz: maxima by {found}, {exact} exactly");
            // The damper is implicit, of first order: it is too weak by the fraction h ω ζ.
            let h_omega = world.integration_parameters.substep() * (STIFFNESS / MASS).sqrt();
            let room = 2.0 * h_omega * ratio * exact.ln().abs() + 0.01;
            assert!((found / exact - 1.0).abs() < room, "{found} instead of {exact}");
        }
    }
}

#[test]
fn springs_hang_where_weight_and_pull_agree() {
    let mut world = crate::suite::physics::stage::world(60);
    let post = post(&mut world, Vector::ZERO);
    let mass = world.insert_body(bob(MASS, 0.1).translation(vec(0.0, -REST)));
    let spring = SpringJointBuilder::new(Vector::ZERO, Vector::ZERO, REST, STIFFNESS).damping(20.0);
    let spring = world.insert_impulse_joint(post, mass, spring);
    crate::suite::physics::stage::run(&mut world, 10.0);
    let weight = MASS * crate::suite::physics::stage::G;
    let found = -world.bodies[mass].translation().y - REST;
    assert!((found - weight / STIFFNESS).abs() < 1.0e-3, "{found}");
    let force = world.impulse_joints.get(spring).unwrap().force();
    assert!((force - vec(0.0, weight)).length() < 1.0e-2 * weight, "{force}");
}
