//! A spinning top with one end of its axis fixed precesses and does not fall (3D).

use crate::suite::physics::stage::{G, RATES, run, steps, weightless, world};
use rapier::prelude::*;

/// Distance from the middle of the disc to the joint, which is also its radius, and its moment of inertia
/// about its axis (mass 1).
const RADIUS: Real = 0.5;
const ARM: Real = 0.2;
const INERTIA: Real = 0.5 * RADIUS * RADIUS;

/// Adds a disc of mass 1 that spins about the horizontal axis X, and precesses about a post at the origin.
fn top(world: &mut PhysicsWorld, spin: Real, round: Real, is_multibody: bool) -> RigidBodyHandle {
    let post = world.insert_body(RigidBodyBuilder::fixed());
    let inertia = Vector::new(INERTIA, 0.5 * INERTIA, 0.5 * INERTIA);
    let disc = RigidBodyBuilder::dynamic()
        .additional_mass_properties(MassProperties::new(Vector::ZERO, 1.0, inertia))
        .translation(Vector::X * ARM)
        .angvel(Vector::new(spin, round, 0.0))
        .linvel(Vector::Z * (-round * ARM))
        .gyroscopic_forces_enabled(true)
        .can_sleep(false);
    let disc = world.insert_body(disc);
    let joint = SphericalJointBuilder::new().local_anchor2(Vector::X * -ARM);
    if is_multibody {
        world.insert_multibody_joint(post, disc, joint).expect("it fits");
    } else {
        world.insert_impulse_joint(post, disc, joint);
    }
    disc
}

/// `Ω = m g r / (I ω)`, exact for a horizontal axis: the torque `m g r` rotates the angular momentum `I ω`.
#[test]
fn tops_precess_at_the_rate_of_the_formula() {
    for rate in RATES {
        for spin in [40.0, 30.0] {
            for is_multibody in [false, true] {
                let exact = G * ARM / (INERTIA * spin);
                let mut world = world(rate);
                let disc = top(&mut world, spin, exact, is_multibody);
                let (mut turned, mut last, mut sunk): (Real, Real, Real) = (0.0, 0.0, 0.0);
                for _ in 0..steps(&world, 5.0) {
                    world.step();
                    let place = world.bodies[disc].translation();
                    let angle = Real::atan2(-place.z, place.x);
                    let change = angle - last;
                    turned += change
                        - (change / core::f64::consts::TAU as Real).round()
                            * core::f64::consts::TAU as Real;
                    last = angle;
                    sunk = sunk.max(place.y.abs() / ARM);
                }
                let found = turned / 5.0;
                let error = found / exact - 1.0;
                println!(
                    "{rate} Hz, {spin} rad/s, multibody {is_multibody}: {found:.5} of {exact:.5}, {error:+.4}, sinks {sunk:.4}"
                );
                // The error is of second order in the angle of a substep, 0.33 rad at 30 Hz.
                let angle = spin * world.integration_parameters.substep();
                assert!(
                    error.abs() < 0.3 * angle * angle + 0.01,
                    "{found} instead of {exact} at {rate} Hz"
                );
                assert!(sunk < 0.2, "sinks by {sunk} of its arm");
            }
        }
    }
}

/// A wheel on an axle keeps its speed and its axle, at rotations of up to 2 rad per substep and 8 rad per
/// step. Its shape is rotated in the body, so that rounding excites a wobble. One wheel is on a post. Two
/// others are joined to each other with a total momentum of zero, so that the direction of their axle is
/// undetermined.
#[test]
fn fast_wheels_keep_their_speed_on_their_axles() {
    for (rate, speed) in [(60, 50.0), (60, 250.0), (60, 480.0), (30, 125.0), (30, 240.0)] {
        for is_free in [false, true] {
            let mut world = weightless(rate);
            let wheel = |spin: Real| {
                let body = RigidBodyBuilder::dynamic().angvel(Vector::X * spin).can_sleep(false);
                let turned = Vector::Z * (0.5 * std::f64::consts::PI as Real);
                (body, ColliderBuilder::cylinder(0.1, 0.5).rotation(turned))
            };
            let (body, shape) = wheel(speed);
            let (first, _) = world.insert(body, shape.collision_groups(InteractionGroups::none()));
            let (body, shape) = wheel(-speed);
            let second = match is_free {
                true => world.insert(body, shape.collision_groups(InteractionGroups::none())).0,
                false => world.insert_body(RigidBodyBuilder::fixed()),
            };
            world.insert_impulse_joint(second, first, RevoluteJointBuilder::new(Vector::X));
            run(&mut world, 10.0);
            let what = format!("{rate} Hz, {speed} rad/s, free: {is_free}");
            let [wheel, other] = [first, second].map(|body| &world.bodies[body]);
            let found = wheel.angvel().length();
            assert!((found / speed - 1.0).abs() < 1.0e-3, "{found} rad/s at {what}");
            let [axis, axle] = [wheel, other].map(|body| *body.rotation() * Vector::X);
            assert!((axis - axle).length() < 5.0e-3, "{axis} on {axle} at {what}");
            let apart = (wheel.translation() - other.translation()).length();
            assert!(apart < 1.0e-3, "{apart} m at {what}");
        }
    }
}
