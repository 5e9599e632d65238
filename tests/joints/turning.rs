//! Fast rotation and swinging: joints conserve angular momentum and energy.

use super::momentum::momenta;
use super::pendulum::exact_period;
use super::stage::{bob, hang, inertia, largest, post, swing};
use crate::dim::{about_z, hinge, vec, z_of};
use crate::suite::physics::stage::{G, RATES, run, steps, weightless, world};
use crate::suite::physics::table::Table;
use rapier::prelude::*;

/// Half the distance of two joined bodies.
const HALF: Real = 0.3;

/// Returns the kinetic energy of all bodies.
fn kinetic_energy(world: &PhysicsWorld) -> Real {
    world.bodies.iter().map(|(_, body)| body.kinetic_energy()).sum()
}

/// Adds bodies in a row that rotates about its middle at this rate (rad/s).
fn spin(world: &mut PhysicsWorld, count: usize, rate: Real, joint: &GenericJoint) {
    let mut last = None;
    for k in 0..count {
        let x = (2 * k + 1) as Real * HALF - count as Real * HALF;
        let body = bob(1.0, 0.25).translation(vec(x, 0.0)).linvel(vec(0.0, rate * x));
        let body = world.insert_body(body.angvel(about_z(rate)));
        if let Some(last) = last {
            world.insert_impulse_joint(last, body, *joint);
        }
        last = Some(body);
    }
}

/// A row of joined bodies spins freely. The joints dissipate nothing: the difference is rounding.
#[test]
fn spinning_joined_bodies_conserve_momentum_and_energy() {
    let columns = ["rate", "joint", "bodies", "spin (rad/s)", "momentum left", "energy left"];
    let mut table = Table::new("bodies in a row that turn for 5 s", &columns);
    let (ahead, behind) = (vec(HALF, 0.0), vec(-HALF, 0.0));
    let joints: [(&str, GenericJoint); 2] = [
        ("hinge", hinge().local_anchor1(ahead).local_anchor2(behind).into()),
        ("fixed", FixedJointBuilder::new().local_anchor1(ahead).local_anchor2(behind).into()),
    ];
    for rate in RATES {
        for (name, joint) in &joints {
            for (count, speed) in [(2, 10.0), (2, 20.0), (3, 30.0), (2, 60.0)] {
                let mut world = weightless(rate);
                spin(&mut world, count, speed, joint);
                let (before, energy) = (z_of(momenta(&world).1), kinetic_energy(&world));
                run(&mut world, 5.0);
                let left = z_of(momenta(&world).1) / before;
                let energy_left = kinetic_energy(&world) / energy;
                table.row([
                    rate.to_string(),
                    name.to_string(),
                    count.to_string(),
                    speed.to_string(),
                    format!("{left:.5}"),
                    format!("{energy_left:.5}"),
                ]);
                table.check("the angular momentum", left, 1.0, 1.0e-3);
                table.check("the energy", energy_left, 1.0, 2.0e-3);
            }
        }
    }
}

/// A motor of the torque `τ` accelerates a hub with two blades: `ω = τ t / I`.
#[test]
fn motors_accelerate_rotors_by_their_torque() {
    const ARM: Real = 0.5;
    let mut table = Table::new(
        "hub with two blades under 20 N·m",
        &["rate", "time (s)", "spin (rad/s)", "τ t/I"],
    );
    for (rate, fastest) in [(60, 200.0), (120, 230.0)] {
        let (mut world, torque) = (weightless(rate), 20.0);
        let post = post(&mut world, Vector::ZERO);
        let hub = world.insert_body(bob(1.0, 0.1));
        let motor = hinge().motor_model(MotorModel::ForceBased).motor_velocity(1000.0, 1000.0);
        world.insert_impulse_joint(post, hub, motor.motor_max_force(torque));
        for x in [-ARM, ARM] {
            let blade = world.insert_body(bob(0.5, 0.1).translation(vec(x, 0.0)));
            world.insert_impulse_joint(
                hub,
                blade,
                FixedJointBuilder::new().local_anchor1(vec(x, 0.0)),
            );
        }
        let moment = inertia(1.0, 0.1) + 2.0 * (inertia(0.5, 0.1) + 0.5 * ARM * ARM);
        let dt = world.integration_parameters.dt;
        for step in 1..=steps(&world, fastest * moment / torque) {
            world.step();
            if step % 30 == 0 {
                let time = step as Real * dt;
                let (found, exact) = (z_of(world.bodies[hub].angvel()), torque * time / moment);
                table.row([
                    rate.to_string(),
                    format!("{time:.2}"),
                    format!("{found:.2}"),
                    format!("{exact:.2}"),
                ]);
                table.check("the rate", found / exact, 1.0, 0.01);
            }
        }
    }
}

/// Pendulums keep their amplitude, even short ones, whose rods carry three times the weight at the
/// lowest point.
#[test]
fn short_pendulums_keep_their_swing() {
    let mut table =
        Table::new("pendulums after 30 s", &["rate", "length (m)", "swing (°)", "swing left (°)"]);
    for rate in RATES {
        for length in [0.1, 0.3, 1.0] {
            for degrees in [30.0, 90.0] {
                let angle = Real::to_radians(degrees);
                let mut world = world(rate);
                let bob = hang(&mut world, length, 0.1 * length, angle);
                run(&mut world, 30.0 - 1.25 * exact_period(length, 0.1 * length, angle));
                let seconds = 1.25 * exact_period(length, 0.1 * length, angle);
                let left = largest(&mut world, seconds, |world| {
                    swing(world.bodies[bob].translation()).abs()
                });
                table.row([
                    rate.to_string(),
                    length.to_string(),
                    degrees.to_string(),
                    format!("{:.2}", left.to_degrees()),
                ]);
                // The amplitude is read at the ends of steps only: at 30 Hz, the maximum of the shortest
                // pendulum may fall between two.
                table.check("the amplitude", left / angle, 1.0, 0.05);
            }
        }
    }
}

/// Returns the kinetic and potential energy of all bodies.
fn energy(world: &PhysicsWorld) -> Real {
    let heights = world.bodies.iter().map(|(_, body)| body.mass() * body.center_of_mass().y * G);
    kinetic_energy(world) + heights.sum::<Real>()
}

/// A double pendulum is released at level. Its energy oscillates with an amplitude of second order in
/// `h ω`, and does not drift.
#[test]
fn double_pendulums_keep_their_energy() {
    let mut table = Table::new("double pendulums over 30 s", &["rate", "m", "least", "most"]);
    for (rate, length) in [(30, 0.5), (60, 0.5), (60, 0.25), (120, 0.5), (120, 0.25)] {
        let mut world = world(rate);
        let (mut last, mut anchor) = (post(&mut world, Vector::ZERO), Vector::ZERO);
        let half = vec(0.5 * length, 0.0);
        for k in 0..2_u8 {
            let rod = bob(1.0, 0.3 * length).translation(half * Real::from(2 * k + 1));
            let rod = world.insert_body(rod);
            world.insert_impulse_joint(
                last,
                rod,
                hinge().local_anchor1(anchor).local_anchor2(-half),
            );
            (last, anchor) = (rod, half);
        }
        // The reference is the lowest position: the middles are 1/2 and 3/2 lengths below the post.
        let scale = 2.0 * length * G;
        let start = energy(&world);
        let (mut least, mut most) = (Real::INFINITY, 0.0 as Real);
        for _ in 0..steps(&world, 30.0) {
            world.step();
            let share = 1.0 + (energy(&world) - start) / scale;
            (least, most) = (least.min(share), most.max(share));
        }
        table.row([
            rate.to_string(),
            length.to_string(),
            format!("{least:.4}"),
            format!("{most:.4}"),
        ]);
        let allowed = if rate == 30 { 0.05 } else { 0.03 };
        table.check("the least energy", least, 1.0, allowed);
        table.check("the largest energy", most, 1.0, allowed);
    }
}
