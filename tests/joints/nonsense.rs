//! Invalid input is rejected with an error that names it, or ignored; other bodies are unaffected.

use super::stage::{bob, post};
use crate::dim::{hinge, vec};
use crate::suite::physics::stage::{run, world};
use rapier::prelude::*;

#[test]
fn invalid_values_are_named() {
    let mut joint = GenericJoint::new(JointAxesMask::LOCKED_REVOLUTE_AXES);
    let old = joint;
    let nan = vec(Real::NAN, 0.0);
    assert!(matches!(joint.try_set_local_anchor1(nan), Err(InvalidJoint::Anchor { .. })));
    assert!(matches!(joint.try_set_local_anchor2(nan), Err(InvalidJoint::Anchor { .. })));
    assert_eq!(
        joint.try_set_local_axis1(Vector::ZERO),
        Err(InvalidJoint::Axis { axis: Vector::ZERO })
    );
    assert!(matches!(joint.try_set_local_axis2(nan), Err(InvalidJoint::Axis { .. })));
    assert_eq!(
        joint.try_set_limits(JointAxis::AngX, [1.0, -1.0]),
        Err(InvalidJoint::Limits { axis: JointAxis::AngX, min: 1.0, max: -1.0 })
    );
    let motor = JointMotor { stiffness: -1.0, ..Default::default() };
    let error = joint.try_set_motor(JointAxis::AngX, motor).unwrap_err();
    assert!(error.to_string().contains("stiffness") && error.to_string().contains("-1"));
    joint.set_limits(JointAxis::AngX, [Real::NAN, 1.0]).set_local_anchor1(nan);
    joint.set_softness(Some(SpringCoefficients::new(Real::NAN, 1.0)));
    joint.set_break_thresholds(-1.0, 1.0);
    assert_eq!(joint, old);
}

#[test]
fn joints_of_missing_bodies_are_removed_and_self_joints_do_nothing() {
    let mut world = world(60);
    let body = world.insert_body(bob(1.0, 0.1));
    let set = &mut world.impulse_joints;
    assert_eq!(set.try_insert(body, body, hinge(), true), Err(InvalidJoint::SameBody { body }));
    let own = set.insert(body, body, hinge(), true);
    let joint_of_missing_body = set.insert(body, RigidBodyHandle::invalid(), hinge(), true);
    let stale = RigidBodyHandle::from_raw_parts(3, 9);
    set.insert(stale, body, hinge(), true);
    run(&mut world, 0.5);
    assert!(!world.impulse_joints.contains(joint_of_missing_body));
    assert!(world.impulse_joints.contains(own) && world.impulse_joints.len() == 1);
    assert!(!world.impulse_joints[own].data.is_enabled());
    assert!(world.bodies[body].translation().y < -1.0, "it falls as if there were no joints");
}

#[test]
fn invalid_public_fields_disable_a_joint_until_repaired() {
    let mut world = world(60);
    let post = post(&mut world, Vector::ZERO);
    let load = world.insert_body(bob(1.0, 0.1));
    let other = world.insert_body(bob(1.0, 0.1).translation(vec(3.0, 0.0)));
    let joint = world.insert_impulse_joint(post, load, FixedJoint::new());
    let good = world.impulse_joints[joint].data;
    for spoil in [
        |joint: &mut GenericJoint| joint.local_frame1.translation.x = Real::NAN,
        |joint: &mut GenericJoint| joint.limit_axes = JointAxesMask::all(),
        |joint: &mut GenericJoint| joint.motors[0].damping = Real::INFINITY,
        |joint: &mut GenericJoint| joint.break_force = Real::NAN,
    ] {
        let data = &mut world.impulse_joints[joint].data;
        spoil(data);
        for limits in &mut data.limits {
            (limits.min, limits.max) = (2.0, 1.0);
        }
        data.motor_axes = JointAxesMask::all();
        world.step();
        assert!(world.bodies[load].linvel().is_finite());
        world.impulse_joints[joint].data = good;
        world.impulse_joints[joint].impulses = [Real::NAN; SPATIAL_DIM];
        run(&mut world, 0.2);
        assert!(world.bodies[load].translation().length() < 0.05);
    }
    assert!(world.bodies[other].translation().is_finite());
}

#[test]
fn extreme_joints_leave_finite_worlds() {
    for stiffness in [1.0e-20, 1.0, 1.0e30] {
        for damping in [0.0, 1.0e30] {
            for reach in [0.0, 1.0, 1.0e12] {
                let mut world = world(60);
                let post = post(&mut world, Vector::ZERO);
                let load = world.insert_body(bob(1.0, 0.1).translation(vec(0.3, 0.1)));
                let mut joint = GenericJoint::new(JointAxesMask::empty());
                joint.set_local_anchor2(vec(reach, -reach));
                for axis in JointAxis::ALL {
                    joint.set_motor(axis, 1.0, -1.0, stiffness, damping);
                    joint.set_limits(axis, [-0.5, 0.5]);
                }
                world.insert_impulse_joint(post, load, joint);
                run(&mut world, 0.5);
                let body = &world.bodies[load];
                assert!(body.translation().is_finite() && body.linvel().is_finite());
            }
        }
    }
}

#[test]
fn joints_between_bodies_without_mass_hold_still() {
    let mut world = world(60);
    let posts = [0.0, 1.0].map(|x| post(&mut world, vec(x, 0.0)));
    let ghost = world.insert_body(RigidBodyBuilder::dynamic().translation(vec(0.5, 0.0)));
    world.insert_impulse_joint(posts[0], posts[1], hinge());
    world.insert_impulse_joint(posts[0], ghost, hinge());
    world.insert_impulse_joint(ghost, posts[1], hinge());
    run(&mut world, 1.0);
    assert!(world.bodies[ghost].translation().is_finite());
}
