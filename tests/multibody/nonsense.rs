//! Invalid input does not make a multibody panic, and does not affect other bodies.

use super::stage::{chain, hang};
use crate::dim::{hinge, loose_joint, vec};
use crate::suite::physics::stage::{Dice, run, world};
use rapier::prelude::*;

/// A world returns the reason as a value, with the bodies in it.
#[test]
fn a_world_returns_the_reason_of_a_rejected_joint() {
    let mut world = world(60);
    let [a, b, c] = [0.0, 1.0, 2.0].map(|x| world.insert_body(super::stage::slab(vec(x, 0.0))));
    let [post, wall] = [0, 1].map(|_| world.insert_body(RigidBodyBuilder::fixed()));
    let gone = world.insert_body(super::stage::slab(vec(9.0, 0.0)));
    world.remove_body(gone);
    let cases = [
        (a, a, InvalidJoint::SameBody { body: a }),
        (post, wall, InvalidJoint::NoDynamicBody { body1: post, body2: wall }),
        (a, gone, InvalidJoint::MissingBody { body: gone }),
        (gone, a, InvalidJoint::MissingBody { body: gone }),
    ];
    for (body1, body2, reason) in cases {
        assert_eq!(world.try_insert_impulse_joint(body1, body2, hinge()), Err(reason));
        assert_eq!(world.try_insert_multibody_joint(body1, body2, hinge()), Err(reason));
    }
    assert!(world.try_insert_multibody_joint(a, b, hinge()).is_ok());
    assert!(world.try_insert_multibody_joint(b, c, hinge()).is_ok());
    let refused = world.try_insert_multibody_joint(a, c, hinge());
    assert_eq!(refused, Err(InvalidJoint::SecondParent { body: c }));
    let refused = world.try_insert_multibody_joint(c, a, hinge());
    assert_eq!(refused, Err(InvalidJoint::Loop { parent: c, child: a }));
    assert!(world.try_insert_impulse_joint(a, c, hinge()).is_ok(), "impulse joints close loops");

    let spring = SpringJoint::new(vec(0.0, 0.0), vec(0.0, 0.0), 1.0, 100.0);
    let ropes: [GenericJoint; 2] = [RopeJointBuilder::new(1.0).into(), spring.into()];
    for rope in ropes {
        let refused = world.try_insert_multibody_joint(post, a, rope);
        let axes = JointAxesMask::LIN_AXES;
        assert_eq!(refused, Err(InvalidJoint::DistanceInMultibody { axes }), "no coordinate");
    }
}

#[test]
fn invalid_joints_are_rejected() {
    let mut world = world(60);
    let [a, b, c] = [0.0, 1.0, 2.0].map(|x| world.insert_body(super::stage::slab(vec(x, 0.0))));
    let joint = || hinge().local_anchor1(vec(0.5, 0.0)).local_anchor2(vec(-0.5, 0.0));
    let set = &mut world.multibody_joints;
    assert!(set.insert(a, a, joint(), true).is_none(), "a body with itself");
    assert!(set.insert(a, RigidBodyHandle::invalid(), joint(), true).is_none());
    assert!(set.insert(a, b, joint(), true).is_some());
    assert!(set.insert(c, b, joint(), true).is_none(), "a body has one parent");
    assert!(set.insert(b, a, joint(), true).is_none(), "no loops");
    assert!(set.insert(b, c, joint(), true).is_some());
    assert!(set.insert(c, a, joint(), true).is_none(), "no loops");
    let mut broken: GenericJoint = joint().into();
    broken.local_frame1.translation = vec(Real::NAN, 0.0);
    assert!(set.insert(a, b, broken, true).is_none());
    assert_eq!((set.len(), set.multibodies().count()), (2, 1));

    let stale = MultibodyJointHandle::invalid();
    assert!(
        set.get(stale).is_none() && set.get_mut(stale).is_none() && set.get_link(stale).is_none()
    );
    assert!(set.remove(stale, true).is_none());
    set.remove_multibody_articulations(stale, true);
    set.remove_joints_attached_to_rigid_body(RigidBodyHandle::invalid());
    assert_eq!(set.len(), 2);
    run(&mut world, 0.1);
}

/// Handles without a body: the next step removes the joint.
#[test]
fn joints_of_missing_bodies_are_removed() {
    let mut world = world(60);
    let body = world.insert_body(super::stage::slab(Vector::ZERO));
    let forged = RigidBodyHandle::from_raw_parts(4_000_000_000, 7);
    assert!(world.multibody_joints.insert(body, forged, hinge(), true).is_some());
    assert!(world.multibody_joints.insert(forged, body, hinge(), true).is_none());
    world.step();
    assert!(world.multibody_joints.is_empty());
}

/// A multibody with a link that is not dynamic does nothing until the link is dynamic.
#[test]
fn links_must_be_dynamic() {
    let mut world = world(60);
    let chain = chain(&mut world, None, 3);
    for kind in [RigidBodyType::Fixed, RigidBodyType::KinematicVelocityBased] {
        world.bodies[chain.bodies[1]].set_body_type(kind, true);
        run(&mut world, 0.1);
    }
    world.bodies[chain.bodies[1]].set_body_type(RigidBodyType::Dynamic, true);
    world.bodies[chain.bodies[1]].set_enabled(false);
    run(&mut world, 0.1);
    world.bodies[chain.bodies[1]].set_enabled(true);
    run(&mut world, 0.3);
    for pair in chain.bodies.windows(2) {
        let [one, two] = [0, 1].map(|k| *world.bodies[pair[k]].position());
        let gap = one * vec(0.5, 0.0) - two * vec(-0.5, 0.0);
        assert!(gap.length() < 1.0e-4, "joined again: {gap}");
    }
}

/// The numbers exceed any valid simulation.
#[test]
fn invalid_numbers_in_a_multibody_keep_the_world_finite() {
    for nonsense in [Real::NAN, Real::INFINITY, -1.0, 1.0e30, 0.0] {
        let mut world = world(60);
        let (body, joint) = hang(&mut world, 1.0, 0.1, 0.5);
        let other = world.insert_body(super::stage::slab(vec(5.0, 0.0)));
        run(&mut world, 0.1);
        let (multibody, link) = world.multibody_joints.get_mut(joint).expect("it is there");
        multibody.generalized_velocity_mut()[0] = nonsense;
        multibody.damping_mut()[0] = nonsense;
        multibody.armature_mut()[0] = nonsense;
        multibody.frictions_mut()[0] = nonsense;
        multibody.apply_displacements(&[nonsense, nonsense, 3.0]);
        let data = &mut multibody.link_mut(link).expect("a link").joint;
        data.set_spring(JointAxis::AngX, nonsense, nonsense);
        data.data.motors[0].stiffness = nonsense;
        data.data.limits[0].min = nonsense;
        data.data.set_motor_position(JointAxis::AngX, nonsense, nonsense, nonsense);
        let target = Pose::from_parts(vec(nonsense, 0.0), Rotation::IDENTITY);
        let mut displacements = vec![nonsense; 9];
        let options = InverseKinematicsOption { damping: nonsense, ..Default::default() };
        multibody.inverse_kinematics(
            &world.bodies,
            link,
            &options,
            &target,
            |_| true,
            &mut displacements,
        );
        multibody.inverse_kinematics(
            &world.bodies,
            99,
            &options,
            &target,
            |_| true,
            &mut displacements,
        );
        assert!(multibody.link(99).is_none() && multibody.body_jacobian(99).is_empty());
        assert!(
            multibody.kinematic_branch(99).is_empty() && multibody.joint_velocity(99).is_empty()
        );
        run(&mut world, 0.5);
        let at = world.bodies[body].translation();
        assert!(at.is_finite(), "{nonsense}: {at}");
        assert!((world.bodies[other].translation().x - 5.0).abs() < 1.0e-4);
    }
}

/// Links have no mass, and the user changes the axes of joints on the way.
#[test]
fn links_without_mass_and_other_axes() {
    let mut world = world(60);
    let mut parent = world.insert_body(RigidBodyBuilder::fixed());
    let mut dice = Dice(3);
    let mut joints = Vec::new();
    for k in 0..8 {
        let at = vec(k as Real + 0.5, 0.0);
        let body = if k % 2 == 0 {
            RigidBodyBuilder::dynamic().translation(at)
        } else {
            super::stage::slab(at)
        };
        let body = world.insert_body(body);
        let joint = loose_joint(k, vec(0.5, 0.0), vec(-0.5, 0.0));
        joints.push(world.multibody_joints.insert(parent, body, joint, true).expect("it fits"));
        parent = body;
    }
    for _ in 0..60 {
        let joint = joints[dice.within(0.0, 7.99) as usize];
        let (multibody, link) = world.multibody_joints.get_mut(joint).expect("it is there");
        let bits = dice.within(0.0, 63.9) as u8;
        multibody.link_mut(link).expect("a link").joint.data.locked_axes =
            JointAxesMask::from_bits_truncate(bits);
        let _ = (multibody.mass_matrix(), multibody.bias_forces());
        world.step();
        world.step();
    }
    assert!(world.bodies.iter().all(|(_, body)| body.translation().is_finite()));
}
