//! Inverse kinematics: an arm whose tip follows a target.

use crate::common::{Scene, SceneInfo};
use crate::kit::{HALF_TURN, hinge, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// The scene's entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "robot_arm",
    description: "An arm of four joints reaches: inverse kinematics finds the angles, motors turn the joints there.",
    category: Category::Capability,
    steps: 300,
    build,
};

/// Lengths of the links and half their thickness. The arm stands upright at first.
const LINKS: [(Real, Real); 4] = [(1.4, 0.14), (1.2, 0.12), (0.9, 0.10), (0.6, 0.08)];
/// How far each joint turns to either side (rad).
const REACH: Real = 2.4;
/// Steps in which the target goes round.
const ROUND: Real = 240.0;
/// Stiffness and damping of the motors (1/s², 1/s): critically damped at 5 Hz.
const STIFFNESS: Real = 1000.0;
const DAMPING: Real = 63.0;

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(20.0);
    let tip = add_arm(&mut world);
    let mark = ColliderBuilder::ball(0.1).sensor(true);
    let target = RigidBodyBuilder::kinematic_position_based().translation(place_of_target(0));
    let (target, _) = world.insert(target, mark);
    Scene::new(world, View::flat())
        .focusing(Vector::new(-4.0, -0.3), Vector::new(4.0, 4.5))
        .showing_joints(0.3)
        .script(move |world, step| {
            let place = place_of_target(step);
            world.bodies[target].set_next_kinematic_translation(place);
            reach(world, tip, place);
        })
}

/// A figure of eight before the arm.
fn place_of_target(step: usize) -> Vector {
    let angle = 2.0 * HALF_TURN * step as Real / ROUND;
    Vector::new(2.2 * angle.sin(), 2.2 + 0.8 * (2.0 * angle).sin())
}

/// Links stacked on a base. Returns the joint of the last one.
fn add_arm(world: &mut PhysicsWorld) -> MultibodyJointHandle {
    let base = RigidBodyBuilder::fixed().translation(Vector::Y * 0.15);
    let (mut parent, _) = world.insert(base, ColliderBuilder::cuboid(0.4, 0.15));
    let (mut foot, mut end) = (0.3, 0.15);
    let mut tip = MultibodyJointHandle::invalid();
    for (length, half) in LINKS {
        let place = Vector::Y * (foot + 0.5 * length);
        let shape = ColliderBuilder::cuboid(half, 0.5 * length - 0.02);
        let body = RigidBodyBuilder::dynamic().translation(place).can_sleep(false);
        let (body, _) = world.insert(body, shape);
        let joint = hinge()
            .local_anchor1(Vector::Y * end)
            .local_anchor2(Vector::Y * (-0.5 * length))
            .limits([-REACH, REACH])
            .contacts_enabled(false);
        tip = world.insert_multibody_joint(parent, body, joint).expect("links form a tree");
        (parent, foot, end) = (body, foot + length, 0.5 * length);
    }
    tip
}

/// Lets the motors turn the joints to where the tip is at a place.
fn reach(world: &mut PhysicsWorld, tip: MultibodyJointHandle, place: Vector) {
    let PhysicsWorld { multibody_joints, bodies, .. } = world;
    let Some((arm, link)) = multibody_joints.get_mut(tip) else { return };
    // The tip is half the last link's length from its body's origin: aim the origin there, from above.
    let half = 0.5 * LINKS[3].0;
    let pose = Pose::from_parts(place + Vector::Y * half, Rotation::from_angle(HALF_TURN));
    let options = InverseKinematicsOption {
        damping: 0.2,
        max_iters: 20,
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
