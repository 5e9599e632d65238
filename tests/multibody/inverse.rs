//! Inverse kinematics: an arm reaches for targets.

use crate::dim::{about_z, hinge, vec};
use crate::suite::joints::stage::bob;
use crate::suite::physics::stage::{run, weightless};
use rapier::prelude::*;

/// Adds an arm of five links of length 1 along x, on a fixed base at the origin. The origin of each body is
/// at the far end of its link.
fn arm(world: &mut PhysicsWorld) -> MultibodyJointHandle {
    let mut parent = world.insert_body(RigidBodyBuilder::fixed());
    let mut last = MultibodyJointHandle::invalid();
    for k in 0..5 {
        let body = world.insert_body(bob(0.5, 0.1).translation(vec(k as Real + 1.0, 0.0)));
        let joint = hinge().local_anchor2(vec(-1.0, 0.0)).limits([-2.0, 2.0]);
        last = world.multibody_joints.insert(parent, body, joint, true).expect("it fits");
        parent = body;
    }
    last
}

/// Returns the translation axes of a tip in the plane of the picture.
fn plane() -> JointAxesMask {
    JointAxesMask::LIN_X | JointAxesMask::LIN_Y
}

#[test]
fn an_arm_reaches_targets_in_its_workspace() {
    let targets = [vec(3.0, 2.0), vec(-1.0, 3.0), vec(0.5, -1.5), vec(2.0, 0.0), vec(0.0, 4.5)];
    for target in targets {
        let mut world = weightless(60);
        let joint = arm(&mut world);
        let (multibody, tip) = world.multibody_joints.get_mut(joint).expect("it is there");
        multibody.forward_kinematics(&world.bodies, true);
        // A stretched arm is singular and has no preferred direction of folding. These displacements give it
        // one.
        let mut displacements = vec![0.2, 0.3, 0.3, 0.3, 0.3];
        let options = InverseKinematicsOption {
            damping: 0.1,
            max_iters: 100,
            constrained_axes: plane(),
            ..Default::default()
        };
        let pose = Pose::from_parts(target, Rotation::IDENTITY);
        multibody.inverse_kinematics(
            &world.bodies,
            tip,
            &options,
            &pose,
            |_| true,
            &mut displacements,
        );
        multibody.apply_displacements(&displacements);
        for link in multibody.links().skip(1) {
            let angle = link.joint().coords()[JointAxis::AngX as usize];
            assert!(angle.abs() <= 2.0 + 1.0e-5, "within the limits: {angle}");
        }
        multibody.update_rigid_bodies(&mut world.bodies, true);
        let tip = multibody.link(tip).expect("the tip").rigid_body_handle();
        let error = (world.bodies[tip].translation() - target).length();
        println!("{target}: off by {error:e}");
        assert!(error < 1.1e-3, "{error} from {target}");
        // The step keeps the new poses of the bodies.
        run(&mut world, 0.1);
        let error = (world.bodies[tip].translation() - target).length();
        assert!(error < 1.5e-3, "{error} from {target}, after steps");
    }
}

/// The target includes a direction of the tip: three numbers for five joints.
#[test]
fn an_arm_reaches_a_pose() {
    let mut world = weightless(60);
    let joint = arm(&mut world);
    let (multibody, tip) = world.multibody_joints.get_mut(joint).expect("it is there");
    multibody.forward_kinematics(&world.bodies, true);
    let turned = *RigidBodyBuilder::dynamic().rotation(about_z(1.2)).build().rotation();
    let target = Pose::from_parts(vec(2.5, 2.0), turned);
    let options = InverseKinematicsOption { damping: 0.1, max_iters: 100, ..Default::default() };
    let mut displacements = vec![0.2; 5];
    multibody.inverse_kinematics(
        &world.bodies,
        tip,
        &options,
        &target,
        |_| true,
        &mut displacements,
    );
    multibody.apply_displacements(&displacements);
    let reached = multibody.link(tip).expect("the tip").local_to_world();
    let error = (reached.translation - target.translation).length();
    let turn = crate::dim::angle(&(reached.rotation * target.rotation.inverse()));
    assert!(error < 1.1e-3 && turn.abs() < 1.1e-3, "{error} and {turn} off");
}

/// For a target out of reach, the arm stretches towards it, and all numbers stay bounded. Links with locked
/// coordinates do not move.
#[test]
fn an_arm_stretches_towards_targets_out_of_reach() {
    let mut world = weightless(60);
    let joint = arm(&mut world);
    let (multibody, tip) = world.multibody_joints.get_mut(joint).expect("it is there");
    multibody.forward_kinematics(&world.bodies, true);
    let target = Pose::from_parts(vec(6.0, 6.0), Rotation::IDENTITY);
    let options = InverseKinematicsOption {
        damping: 0.5,
        max_iters: 300,
        constrained_axes: plane(),
        ..Default::default()
    };
    let mut displacements = vec![0.3; 5];
    displacements[4] = 0.0;
    let can_move = |link: &MultibodyLink| link.link_id() != 5;
    multibody.inverse_kinematics(
        &world.bodies,
        tip,
        &options,
        &target,
        can_move,
        &mut displacements,
    );
    assert_eq!(displacements[4], 0.0, "the last joint must not move");
    multibody.apply_displacements(&displacements);
    let reached = multibody.link(tip).expect("the tip").local_to_world().translation;
    let along = target.translation.normalize();
    assert!(
        (reached - along * 5.0).length() < 0.05,
        "stretched towards the target, not to {reached}"
    );
}
