//! Inverse kinematics: an arm whose tip follows a target.

use crate::common::{Controls, Law, Scene, SceneInfo};
use crate::kit::{HALF_TURN, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "robot_arm",
    description: "An arm of six joints reaches: inverse kinematics finds the angles, motors turn the joints there.",
    category: Category::Joints,
    steps: 300,
    law: Law { overlap_max: 0.01, height_min: 0.0, reach_max: 3.0, ..Law::NONE },
    source: file!(),
    build,
};

/// By joint: the axis, the length of its link, and half the link's thickness. The arm is upright at first.
const LINKS: [(Vector, Real, Real); 6] = [
    (Vector::Y, 0.6, 0.32),
    (Vector::Z, 1.4, 0.20),
    (Vector::Z, 1.2, 0.17),
    (Vector::Y, 0.4, 0.15),
    (Vector::Z, 0.5, 0.13),
    (Vector::Y, 0.4, 0.10),
];
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
    let mark = ColliderBuilder::ball(0.12).sensor(true);
    let target = RigidBodyBuilder::kinematic_position_based().translation(place_of_target(0));
    let (target, _) = world.insert(target, mark);
    let controls = Controls::new("Arrow keys move the target.");
    let (keys, mut place) = (controls.clone(), place_of_target(0));
    Scene::new(world, View::orbit(62.0, 12.0))
        .focusing(Vector::new(0.0, 0.2, -1.9), Vector::new(0.6, 2.7, 0.9))
        .showing_joints(0.5)
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
    Vector::new(0.0, 1.5 * up, -1.5 * right)
}

/// Returns a point on a figure of eight around the arm.
fn place_of_target(step: usize) -> Vector {
    let angle = 2.0 * HALF_TURN * step as Real / ROUND;
    let about = 0.5 * HALF_TURN * angle.sin();
    Vector::new(2.0 * about.cos(), 1.3 + 0.5 * (2.0 * angle).sin(), 2.0 * about.sin())
}

/// Adds links on a base, each with its body's origin at its far end. Returns the joint of the last link.
fn add_arm(world: &mut PhysicsWorld) -> MultibodyJointHandle {
    let base = RigidBodyBuilder::fixed().translation(Vector::Y * 0.15);
    let (mut parent, _) = world.insert(base, ColliderBuilder::cylinder(0.15, 0.5));
    let (mut place, mut anchor) = (Vector::Y * 0.3, Vector::Y * 0.15);
    let mut tip = MultibodyJointHandle::invalid();
    for (axis, length, half) in LINKS {
        let along = Vector::Y * length;
        place += along;
        let body = RigidBodyBuilder::dynamic().translation(place).can_sleep(false);
        let shape =
            ColliderBuilder::cuboid(half, 0.5 * length - 0.02, half).translation(along * -0.5);
        let (body, _) = world.insert(body, shape);
        let joint = RevoluteJointBuilder::new(axis)
            .local_anchor1(anchor)
            .local_anchor2(-along)
            .limits([-REACH, REACH]);
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
    // The tip points down.
    let pose = Pose::from_parts(place, Rotation::from_rotation_z(HALF_TURN));
    let options = InverseKinematicsOption {
        damping: 0.2,
        max_iters: 20,
        // The angle of the last joint is free.
        constrained_axes: JointAxesMask::all() - JointAxesMask::ANG_Y,
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
