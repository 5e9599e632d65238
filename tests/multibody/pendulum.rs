//! Pendulums of multibody joints: period and energy.

use super::stage::{energy, hang};
use crate::dim::{hinge, vec};
use crate::suite::joints::pendulum::exact_period;
use crate::suite::joints::stage::{bob, falls_through_zero, period, swing};
use crate::suite::physics::stage::{G, RATES, steps, world};
use crate::suite::physics::table::Table;
use rapier::prelude::*;

/// The period of a pendulum of the length `L` and the amplitude `θ₀` is `2π √(L/g) / agm(1,
/// cos(θ₀/2))`.
#[test]
fn pendulums_have_the_period_of_the_formula() {
    let columns = ["rate", "angle (°)", "period (s)", "formula", "error (%)"];
    let mut table = Table::new("period of a pendulum of 1 m", &columns);
    for rate in RATES {
        for degrees in [10.0, 90.0] {
            let angle = Real::to_radians(degrees);
            let mut world = world(rate);
            let (bob, _) = hang(&mut world, 1.0, 0.1, angle);
            let crossings =
                falls_through_zero(&mut world, 6, |world| swing(world.bodies[bob].translation()));
            let (found, exact) = (period(&crossings), exact_period(1.0, 0.1, angle));
            let error = found / exact - 1.0;
            table.row([
                rate.to_string(),
                format!("{degrees}°"),
                format!("{found:.5}"),
                format!("{exact:.5}"),
                format!("{:+.4}", error * 100.0),
            ]);
            // The substep is of second order in h ω: too fast by (h ω)²/24. Crossings are interpolated
            // between steps.
            let substep = world.integration_parameters.substep();
            table.check("the error", error, 0.0, 0.2 * substep * substep * G + 2.0e-4);
        }
    }
}

/// Two bobs on rods are released sideways. The motion is chaotic, and the energy is constant.
#[test]
fn a_double_pendulum_keeps_its_energy() {
    let columns = ["rate", "largest error of E (% of 2 m g L)", "after 30 s (%)"];
    let mut table = Table::new("double pendulum, 30 s", &columns);
    for rate in RATES {
        let mut world = world(rate);
        let (first, _) = hang(&mut world, 1.0, 0.1, Real::to_radians(90.0));
        let at = world.bodies[first].translation() + vec(1.0, 0.0);
        let second = world.insert_body(bob(1.0, 0.1).translation(at));
        let joint = hinge().local_anchor2(vec(-1.0, 0.0));
        world.multibody_joints.insert(first, second, joint, true).expect("the joint fits");
        let bodies = [first, second];
        let (mut largest, mut error): (Real, Real) = (0.0, 0.0);
        for _ in 0..steps(&world, 30.0) {
            world.step();
            error = energy(&world, &bodies) / (2.0 * G);
            largest = largest.max(error.abs());
        }
        let row =
            [rate.to_string(), format!("{:.4}", largest * 100.0), format!("{:+.4}", error * 100.0)];
        table.row(row);
        // The error is bounded, and of second order in the angle of a substep at the second bob's 20 rad/s.
        let angle = 20.0 * world.integration_parameters.substep();
        table.check("the error", largest, 0.0, 0.15 * angle * angle + 1.0e-3);
    }
}

/// Chains of light links with an end of up to ten thousand times their mass are released at level;
/// iterated joints fail at such ratios. The energy never exceeds the initial energy.
#[test]
fn heavy_ends_give_chains_no_energy() {
    let columns = ["links", "mass ratio", "largest gain (% of m g L)"];
    let mut table = Table::new("chains with a heavy end, 3 s", &columns);
    for (count, mass) in [(3, 1.0e4), (10, 100.0), (10, 1.0e4), (30, 1.0e3)] {
        let mut world = world(60);
        let post = world.insert_body(RigidBodyBuilder::fixed());
        let (mut parent, mut bodies) = (post, Vec::new());
        for k in 0..count {
            let mass = if k + 1 == count { mass } else { 1.0 };
            let body = world.insert_body(bob(mass, 0.1).translation(vec(k as Real + 1.0, 0.0)));
            let joint = hinge().local_anchor2(vec(-1.0, 0.0));
            world.multibody_joints.insert(parent, body, joint, true).expect("the joint fits");
            (parent, bodies) = (body, [bodies, vec![body]].concat());
        }
        let start = energy(&world, &bodies);
        let mut gain: Real = 0.0;
        for _ in 0..steps(&world, 3.0) {
            world.step();
            gain = gain.max(energy(&world, &bodies) - start);
        }
        let scale = (mass * count as Real + 0.5 * (count * count) as Real) * G;
        table.row([count.to_string(), format!("{mass}"), format!("{:.4}", gain / scale * 100.0)]);
        table.require(gain < 0.01 * scale, "energy came from nowhere");
    }
}
