//! Limits, motors, springs, armature and friction of joints.

use super::stage::hang;
use crate::dim::{about_z_of, hinge, vec, z_of};
use crate::suite::joints::stage::{bob, inertia, swing};
use crate::suite::physics::stage::{G, RATES, run, steps, weightless, world};
use rapier::prelude::*;

/// The only degree of freedom of a pendulum about the axis that points out of the picture.
const AXIS: JointAxis = JointAxis::AngX;

fn joint(world: &mut PhysicsWorld, handle: MultibodyJointHandle) -> &mut MultibodyJoint {
    let (multibody, link) = world.multibody_joints.get_mut(handle).expect("it is there");
    &mut multibody.link_mut(link).expect("a link").joint
}

fn rate_of(world: &PhysicsWorld, handle: MultibodyJointHandle) -> Real {
    let (multibody, link) = world.multibody_joints.get(handle).expect("it is there");
    multibody.joint_velocity(link)[0]
}

/// A pendulum falls onto its limit, and onto the other one. It stops there within half a degree.
#[test]
fn limits_hold() {
    for rate in RATES {
        let mut world = world(rate);
        let (bob, handle) = hang(&mut world, 1.0, 0.1, Real::to_radians(80.0));
        let (low, high) = (Real::to_radians(-20.0), Real::to_radians(90.0));
        joint(&mut world, handle).data.set_limits(AXIS, [low, high]);
        let mut lowest: Real = 1.0;
        for _ in 0..steps(&world, 4.0) {
            world.step();
            lowest = lowest.min(swing(world.bodies[bob].translation()));
        }
        let over = (low - lowest).to_degrees();
        println!("{rate} Hz: {over}° beyond the limit");
        assert!(over < 0.5, "the pendulum passes its limit by {over}° at {rate} Hz");
        assert!(lowest < low + 0.01, "it gets there: {}", lowest.to_degrees());
    }
}

/// A weight that leans on a limit for ever: the joint carries `m g L sin φ`.
#[test]
fn a_limit_carries_a_weight() {
    let mut world = world(60);
    let (bob, handle) = hang(&mut world, 1.0, 0.1, Real::to_radians(60.0));
    let low = Real::to_radians(45.0);
    joint(&mut world, handle).data.set_limits(AXIS, [low, 3.0]);
    run(&mut world, 4.0);
    let (at, h) = (swing(world.bodies[bob].translation()), world.integration_parameters.substep());
    assert!((at - low).abs() < Real::to_radians(0.5), "{}", at.to_degrees());
    let torque = joint(&mut world, handle).data.limits(AXIS).expect("limits").impulse / h;
    let expected = G * low.sin();
    assert!((torque / expected - 1.0).abs() < 0.02, "{torque} N m instead of {expected}");
}

/// A motor's torque accelerates the link and its own rotor: `α = τ / (I + m L² + a)`, with the
/// armature `a`.
#[test]
fn motors_accelerate_links_and_armature() {
    let columns = ["rate", "armature", "α (rad/s²)", "formula"];
    let mut table = crate::suite::physics::table::Table::new("a motor of 2 N m", &columns);
    for rate in RATES {
        for armature in [0.0, 1.5] {
            let mut world = weightless(rate);
            let (_, handle) = hang(&mut world, 1.0, 0.1, 0.0);
            let (multibody, link) = world.multibody_joints.get_mut(handle).expect("it is there");
            multibody.armature_mut()[0] = armature;
            let joint = &mut multibody.link_mut(link).expect("a link").joint;
            // Far from the speed that it is to reach, it pushes as hard as it may.
            joint.data.set_motor_velocity(AXIS, 1.0e3, 1.0e3).set_motor_max_force(AXIS, 2.0);
            run(&mut world, 1.0);
            let found = rate_of(&world, handle);
            let expected = 2.0 / (inertia(1.0, 0.1) + 1.0 + armature);
            table.row([
                rate.to_string(),
                armature.to_string(),
                found.to_string(),
                expected.to_string(),
            ]);
            table.check("the acceleration", found, expected, 1.0e-3 * expected);
        }
    }
}

/// A strong motor spins a wheel up however fast it turns already: no guard against energy from nowhere takes
/// its work for that.
#[test]
fn strong_motors_spin_wheels_up() {
    for rate in RATES {
        let mut world = weightless(rate);
        let (_, handle) = hang(&mut world, 0.1, 0.1, 0.0);
        let inertia = inertia(1.0, 0.1) + 0.01;
        let acceleration = 2000.0;
        let joint = &mut joint(&mut world, handle).data;
        joint.set_motor_velocity(AXIS, 1.0e4, 1.0e4);
        joint.set_motor_max_force(AXIS, acceleration * inertia);
        let time = 0.2;
        run(&mut world, time);
        let (found, expected) = (rate_of(&world, handle), acceleration * time);
        assert!((found / expected - 1.0).abs() < 1.0e-3, "{found} rad/s at {rate} Hz");
    }
}

/// Motors without a largest force reach what they are told, and hold it.
#[test]
fn motors_reach_velocities_and_positions() {
    let mut world = world(60);
    let (_, handle) = hang(&mut world, 1.0, 0.1, 0.0);
    joint(&mut world, handle).data.set_motor_velocity(AXIS, 2.0, 1.0e4);
    run(&mut world, 2.0);
    assert!((rate_of(&world, handle) - 2.0).abs() < 0.01, "{}", rate_of(&world, handle));
    joint(&mut world, handle).data.set_motor_position(AXIS, 1.0, 1.0e4, 2.0e2);
    run(&mut world, 3.0);
    let at = joint(&mut world, handle).coords()[AXIS as usize];
    // It gives way by the load over the stiffness: g sin 1 / 10⁴.
    assert!((at - 1.0).abs() < 2.0e-3, "{at}");
}

/// A force-based spring of stiffness `k` swings with the period `2π √(I/k)`, and is stable at any stiffness.
#[test]
fn springs_swing_and_never_explode() {
    let total = inertia(1.0, 0.1) + 1.0;
    let mut world = weightless(240);
    let (bob, handle) = hang(&mut world, 1.0, 0.1, 0.3);
    joint(&mut world, handle).set_spring(AXIS, 20.0, 0.0);
    let crossings = crate::suite::joints::stage::falls_through_zero(&mut world, 4, |world| {
        swing(world.bodies[bob].translation())
    });
    let found = crate::suite::joints::stage::period(&crossings);
    let expected = 2.0 * core::f64::consts::PI as Real * (total / 20.0).sqrt();
    assert!((found / expected - 1.0).abs() < 2.0e-3, "{found} s instead of {expected} s");

    let mut world = weightless(60);
    let (bob, handle) = hang(&mut world, 1.0, 0.1, 0.3);
    joint(&mut world, handle).set_spring(AXIS, 1.0e9, 0.0);
    run(&mut world, 2.0);
    let at = swing(world.bodies[bob].translation());
    assert!(at.abs() < 0.01, "a rigid spring leaves {at} rad");
}

/// Damping takes `exp(-d t / I)` of the velocity; dry friction a constant part, and then it holds.
#[test]
fn damping_and_friction_slow_down() {
    let total = inertia(1.0, 0.1) + 1.0;
    let mut world = weightless(240);
    let (_, handle) = hang(&mut world, 1.0, 0.1, 0.0);
    let (multibody, _) = world.multibody_joints.get_mut(handle).expect("it is there");
    multibody.damping_mut()[0] = 0.5;
    multibody.generalized_velocity_mut()[0] = 3.0;
    run(&mut world, 2.0);
    let expected = 3.0 * (-0.5 * 2.0 / total).exp();
    let found = rate_of(&world, handle);
    assert!((found / expected - 1.0).abs() < 2.0e-3, "{found} instead of {expected}");

    let mut world = weightless(60);
    let (_, handle) = hang(&mut world, 1.0, 0.1, 0.0);
    let (multibody, _) = world.multibody_joints.get_mut(handle).expect("it is there");
    multibody.frictions_mut()[0] = 0.5;
    multibody.generalized_velocity_mut()[0] = 3.0;
    run(&mut world, 2.0);
    let (found, expected) = (rate_of(&world, handle), 3.0 - 0.5 * 2.0 / total);
    assert!((found / expected - 1.0).abs() < 2.0e-3, "{found} instead of {expected}");
    run(&mut world, 6.0);
    assert!(rate_of(&world, handle).abs() < 1.0e-4, "{}", rate_of(&world, handle));
}

/// A kinematic joint turns at the velocity that it is given, whatever hangs on it.
#[test]
fn kinematic_joints_move_as_they_are_told() {
    let mut world = world(60);
    let post = world.insert_body(RigidBodyBuilder::fixed());
    let arm = world.insert_body(bob(5.0, 0.1).translation(vec(1.0, 0.0)));
    let joint = hinge().local_anchor2(vec(-1.0, 0.0));
    let handle = world.multibody_joints.insert_kinematic(post, arm, joint, true).expect("it fits");
    let (multibody, _) = world.multibody_joints.get_mut(handle).expect("it is there");
    multibody.generalized_velocity_mut()[0] = 0.7;
    run(&mut world, 1.0);
    let angle = crate::dim::angle(world.bodies[arm].rotation());
    assert!((angle - 0.7).abs() < 1.0e-4, "{angle}");
    assert!((z_of(world.bodies[arm].angvel()) - 0.7).abs() < 1.0e-5);
}

/// A slider on an inclined rail: `a = g sin φ`, along the rail and nowhere else.
#[test]
fn sliders_slide() {
    let mut world = world(60);
    let post = world.insert_body(RigidBodyBuilder::fixed());
    let slider = world.insert_body(bob(2.0, 0.1));
    let along = vec(0.8, -0.6);
    let rail = PrismaticJointBuilder::new(along);
    let handle = world.multibody_joints.insert(post, slider, rail, true).expect("it fits");
    run(&mut world, 1.0);
    let expected = 0.6 * G;
    assert!((rate_of(&world, handle) / expected - 1.0).abs() < 1.0e-3);
    let at = world.bodies[slider].translation();
    assert!((at - along * at.dot(along)).length() < 1.0e-4, "it left its rail: {at}");
    let body = &world.bodies[slider];
    assert!(
        about_z_of(body.mass_properties().local_mprops()) > 0.0
            && z_of(body.angvel()).abs() < 1.0e-5
    );
}
