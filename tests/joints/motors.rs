//! Motors accelerate by their torque, and reach their targets.

use super::stage::{bob, falls_through_zero, inertia, period, post};
use crate::dim::{about_z, angle, hinge, vec, z_of};
use crate::suite::physics::stage::{RATES, run, steps, weightless, world};
use rapier::prelude::*;

/// Adds a wheel of mass 2 on a post, with this joint.
fn wheel(world: &mut PhysicsWorld, joint: RevoluteJointBuilder) -> RigidBodyHandle {
    let post = post(world, Vector::ZERO);
    let wheel = world.insert_body(bob(2.0, 0.5));
    world.insert_impulse_joint(post, wheel, joint);
    wheel
}

#[test]
fn motors_accelerate_by_torque_over_inertia() {
    for rate in RATES {
        for model in [MotorModel::AccelerationBased, MotorModel::ForceBased] {
            let mut world = weightless(rate);
            let torque = 0.7;
            let joint =
                hinge().motor_velocity(1000.0, 1000.0).motor_max_force(torque).motor_model(model);
            let wheel = wheel(&mut world, joint);
            let exact = torque / inertia(2.0, 0.5);
            run(&mut world, 1.0);
            let found = z_of(world.bodies[wheel].angvel());
            // The angular velocity is α t, except for rounding.
            assert!((found / exact - 1.0).abs() < 1.0e-4, "{found} instead of {exact}");
        }
    }
}

#[test]
fn motors_reach_their_velocity_and_keep_it() {
    for rate in RATES {
        let mut world = weightless(rate);
        let wheel = wheel(&mut world, hinge().motor_velocity(-3.0, 50.0));
        run(&mut world, 2.0);
        let found = z_of(world.bodies[wheel].angvel());
        assert!((found + 3.0).abs() < 1.0e-3, "{found} at {rate} Hz");
    }
}

#[test]
fn motors_reach_their_position() {
    for rate in RATES {
        for target in [0.5, -2.8, 7.0] {
            for model in [MotorModel::AccelerationBased, MotorModel::ForceBased] {
                let mut world = weightless(rate);
                let joint = hinge().motor_position(target, 100.0, 20.0).motor_model(model);
                let wheel = wheel(&mut world, joint);
                run(&mut world, 4.0);
                let turn = 2.0 * core::f64::consts::PI as Real;
                let found = angle(world.bodies[wheel].rotation());
                let off = (found - target) / turn;
                let off = (off - off.round()) * turn;
                assert!(off.abs() < 1.0e-2, "{target} missed by {off} at {rate} Hz");
            }
        }
    }
}

#[test]
fn acceleration_motors_are_independent_of_the_mass() {
    let swing = |mass: Real| {
        let mut world = weightless(60);
        let post = post(&mut world, Vector::ZERO);
        let wheel = world.insert_body(bob(mass, 0.5));
        world.insert_impulse_joint(post, wheel, hinge().motor_position(1.0, 30.0, 1.0));
        run(&mut world, 0.5);
        angle(world.bodies[wheel].rotation())
    };
    assert!((swing(0.1) - swing(50.0)).abs() < 1.0e-3);
}

/// The mass of an acceleration-based motor is that of its own two bodies. With a second wheel of the same
/// inertia welded to the first, `ω² = k / 2`.
#[test]
fn acceleration_motors_use_their_own_bodies() {
    let (stiffness, start): (Real, Real) = (30.0, 0.3);
    for welded in [0, 1, 3] {
        let mut world = weightless(240);
        let wheel = wheel(&mut world, hinge().motor_position(start, stiffness, 0.0));
        for _ in 0..welded {
            let other = world.insert_body(bob(2.0, 0.5));
            world.insert_impulse_joint(wheel, other, FixedJointBuilder::new());
        }
        let exact = (stiffness / (1 + welded) as Real).sqrt();
        let turn = |world: &PhysicsWorld| start - angle(world.bodies[wheel].rotation());
        let found =
            core::f64::consts::TAU as Real / period(&falls_through_zero(&mut world, 4, turn));
        // Welds transmit the effect of the motor one iteration later.
        assert!((found / exact - 1.0).abs() < 0.02, "{found} instead of {exact}");
    }
}

#[test]
fn sliding_motors_lift_loads_up_to_their_force() {
    for (force, lifts) in [(18.0, false), (22.0, true)] {
        let mut world = world(60);
        let post = post(&mut world, Vector::ZERO);
        let load = world.insert_body(bob(2.0, 0.2));
        let joint = PrismaticJointBuilder::new(Vector::Y).motor_velocity(1.0, 1000.0);
        world.insert_impulse_joint(post, load, joint.motor_max_force(force));
        run(&mut world, 1.0);
        // The weight of 2 kg is 19.6 N.
        let speed = world.bodies[load].linvel().y;
        assert_eq!(speed > 0.0, lifts, "{force} N: {speed} m/s");
        let exact = if lifts { 1.0 } else { force / 2.0 - 9.81 };
        assert!((speed - exact).abs() < 2.0e-2, "{force} N: {speed} instead of {exact} m/s");
    }
}

#[test]
fn a_motor_turns_both_bodies_against_each_other() {
    let mut world = weightless(60);
    let one = world.insert_body(bob(2.0, 0.5));
    let two = world.insert_body(bob(2.0, 0.5));
    world.insert_impulse_joint(one, two, hinge().motor_velocity(4.0, 100.0));
    run(&mut world, 2.0);
    let [w1, w2] = [one, two].map(|body| z_of(world.bodies[body].angvel()));
    assert!((w1 + 2.0).abs() < 1.0e-3 && (w2 - 2.0).abs() < 1.0e-3, "{w1} and {w2}");
}

#[test]
fn kinematic_bodies_carry_joined_bodies() {
    let mut world = world(60);
    let crane = RigidBodyBuilder::kinematic_velocity_based().linvel(vec(1.0, 0.5));
    let crane = world.insert_body(crane);
    let load = world.insert_body(bob(1.0, 0.1).translation(vec(0.0, -1.0)));
    world.insert_impulse_joint(crane, load, RopeJointBuilder::new(1.0));
    for _ in 0..steps(&world, 3.0) {
        world.step();
        let [from, to] = [crane, load].map(|body| world.bodies[body].translation());
        assert!((to - from).length() < 1.01, "the rope stretched to {}", (to - from).length());
    }
    assert!(world.bodies[load].translation().x > 1.5);
    world.bodies[crane].set_angvel(about_z(0.0), true);
}
