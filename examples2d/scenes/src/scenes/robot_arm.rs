//! Inverse kinematics: an arm whose tip follows a target.

use crate::common::{Controls, Law, Scene, SceneInfo};
use crate::kit::{HALF_TURN, hinge, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "robot_arm",
    description: "An arm of four joints reaches: inverse kinematics finds the angles, motors turn the joints there.",
    category: Category::Joints,
    steps: 300,
    law: Law { overlap_max: 0.01, height_min: 0.0, reach_max: 4.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Lengths of the links and half their thickness. The arm is upright at first.
const LINKS: [(Real, Real); 4] = [(1.4, 0.14), (1.2, 0.12), (0.9, 0.10), (0.6, 0.08)];
/// Limit of each joint's angle, to either side (rad).
const REACH: Real = 2.4;
/// Number of steps per revolution of the target.
const ROUND: Real = 400.0;
/// Stiffness and damping of the motors (1/s², 1/s): critically damped at 10 Hz.
const STIFFNESS: Real = 4000.0;
const DAMPING: Real = 126.0;

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(20.0);
    let tip = add_arm(&mut world);
    let mark = ColliderBuilder::ball(0.1).sensor(true);
    let target = RigidBodyBuilder::kinematic_position_based().translation(place_of_target(0));
    let (target, _) = world.insert(target, mark);
    let controls = Controls::new("Arrow keys move the target.");
    let (keys, mut place) = (controls.clone(), place_of_target(0));
    Scene::new(world, View::flat())
        .focusing(Vector::new(-4.0, -0.3), Vector::new(4.0, 4.5))
        .showing_joints(0.3)
        .controlled(controls)
        .script(move |world, step| {
            match keys.direction() {
                Some(direction) => {
                    place += velocity_by_keys(direction) * world.integration_parameters.dt
                }
                None => place = place_of_target(step),
            }
            world.bodies[target].set_next_kinematic_translation(place);
            reach(world, tip, place);
        })
}

/// Returns the velocity of the target: right and up, as the viewer sees the arm.
fn velocity_by_keys([right, up]: [Real; 2]) -> Vector {
    Vector::new(1.5 * right, 1.5 * up)
}

/// Returns a point on a figure of eight in front of the arm.
fn place_of_target(step: usize) -> Vector {
    let angle = 2.0 * HALF_TURN * step as Real / ROUND;
    Vector::new(2.4 * angle.sin(), 2.2 + 0.8 * (2.0 * angle).sin())
}

/// Adds links on a base, each with its body's origin at its far end. Returns the joint of the last link.
fn add_arm(world: &mut PhysicsWorld) -> MultibodyJointHandle {
    let base = RigidBodyBuilder::fixed().translation(Vector::Y * 0.15);
    let (mut parent, _) = world.insert(base, ColliderBuilder::cuboid(0.4, 0.15));
    let (mut place, mut anchor) = (Vector::Y * 0.3, Vector::Y * 0.15);
    let mut tip = MultibodyJointHandle::invalid();
    for (length, half) in LINKS {
        let along = Vector::Y * length;
        place += along;
        let body = RigidBodyBuilder::dynamic().translation(place).can_sleep(false);
        let shape = ColliderBuilder::cuboid(half, 0.5 * length - 0.02).translation(along * -0.5);
        let (body, _) = world.insert(body, shape);
        let joint = hinge().local_anchor1(anchor).local_anchor2(-along).limits([-REACH, REACH]);
        tip = world.insert_multibody_joint(parent, body, joint).expect("links form a tree");
        (parent, anchor) = (body, Vector::ZERO);
    }
    if let Some((arm, _)) = world.multibody_joints.get_mut(tip) {
        arm.set_self_contacts_enabled(false);
    }
    tip
}

/// Sets the motors' targets to joint angles with the tip at a place.
fn reach(world: &mut PhysicsWorld, tip: MultibodyJointHandle, place: Vector) {
    let PhysicsWorld { multibody_joints, bodies, .. } = world;
    let Some((arm, link)) = multibody_joints.get_mut(tip) else { return };
    let pose = Pose::from_translation(place);
    let options = InverseKinematicsOption {
        damping: 0.2,
        max_iters: 20,
        // The orientation of the tip is free.
        constrained_axes: JointAxesMask::LIN_AXES,
        ..InverseKinematicsOption::default()
    };
    let mut turns = Vec::new();
    arm.inverse_kinematics(bodies, link, &options, &pose, |_| true, &mut turns);
    for link in arm.links_mut().skip(1) {
        let turn = turns.get(link.assembly_id()).copied().unwrap_or(0.0);
        let target = link.joint().coords()[JointAxis::AngX as usize] + turn;
        link.joint.data.set_motor_position(JointAxis::AngX, target, STIFFNESS, DAMPING);
    }
}
