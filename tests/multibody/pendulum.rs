//! Pendulums of multibody joints: their period and their energy.

use super::stage::{energy, hang};
use crate::dim::{hinge, vec};
use crate::suite::joints::pendulum::exact_period;
use crate::suite::joints::stage::{bob, falls_through_zero, period, swing};
use crate::suite::physics::stage::{G, RATES, run, steps, world};
use crate::suite::physics::table::Table;
use rapier::prelude::*;

#[test]
fn pendulums_take_the_time_that_the_formula_says() {
    let columns = ["rate", "angle", "period (s)", "formula", "error (%)"];
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
            // The substep is of second order in h ω: by (h ω)²/24 too fast. Crossings are interpolated between steps.
            let substep = world.integration_parameters.substep();
            table.check("the error", error, 0.0, 0.2 * substep * substep * G + 2.0e-4);
        }
    }
}

/// Two bobs on rods, let go sideways: chaos, but its energy stays.
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
        // Bounded: of second order in the angle of a substep, at the 20 rad/s that the second bob reaches.
        let angle = 20.0 * world.integration_parameters.substep();
        table.check("the error", largest, 0.0, 0.15 * angle * angle + 1.0e-3);
    }
}

/// A rod with a very heavy bob below a very light one: the mass ratio that stretches chains of impulse joints. Nothing stretches here.
#[test]
fn heavy_ends_do_not_stretch_chains() {
    let mut world = world(60);
    let (mut last, _) = hang(&mut world, 1.0, 0.1, 0.3);
    for k in 1..10 {
        let at = world.bodies[last].translation() + vec(0.3, -0.95);
        let mass = if k == 9 { 1.0e4 } else { 1.0 };
        let body = world.insert_body(bob(mass, 0.1).translation(at));
        let joint = hinge().local_anchor2(vec(0.0, 1.0));
        world.multibody_joints.insert(last, body, joint, true).expect("the joint fits");
        last = body;
    }
    for _ in 0..20 {
        run(&mut world, 0.25);
        let (distance, _) = farthest(&world);
        assert!((distance - 1.0).abs() < 1.0e-4, "bobs are {distance} apart");
    }
}

/// The distance of neighbours that is farthest from 1, and the body where it is.
fn farthest(world: &PhysicsWorld) -> (Real, RigidBodyHandle) {
    let joints = world.multibody_joints.iter().map(|(_, _, multibody, link)| {
        let parent = &multibody.link(link.parent_id().expect("it has a parent")).expect("a link");
        let [at, from] =
            [link, parent].map(|link| world.bodies[link.rigid_body_handle()].translation());
        ((at - from).length(), link.rigid_body_handle())
    });
    joints.max_by(|a, b| (a.0 - 1.0).abs().total_cmp(&(b.0 - 1.0).abs())).expect("there are joints")
}
