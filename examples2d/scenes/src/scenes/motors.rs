//! Joint motors: they reach velocities and positions within their force limits.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add, add_fixed, add_post, hinge, square};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "motors",
    description: "Motors: a fan, servos stiff and soft, one that is too weak for its load, a lift, a shaker.",
    category: Category::Joints,
    steps: 200,
    law: Law { overlap_max: 0.02, height_min: -7.0, reach_max: 11.0, gap_max: 0.005, ..Law::NONE },
    source: file!(),
    build,
};

/// Distance of neighbouring motors.
const ACROSS: Real = 4.2;
/// Number of steps per target.
const HOLD: usize = 100;
/// Half extents of an arm, and the distance from its hinge to its middle.
const HALF: Vector = Vector::new(0.7, 0.15);
const ARM: Vector = Vector::new(0.8, 0.0);

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = PhysicsWorld::new();
    let place =
        |column: usize, row: usize| Vector::new(ACROSS * column as Real, -4.0 * row as Real);
    let places = [(0, 0), (1, 0), (2, 0), (0, 1), (1, 1), (2, 1)].map(|(x, y)| place(x, y));
    let labels = ["velocity", "stiff servo", "soft servo", "too weak", "lift", "shaker"];
    let (fan, _) = arm(&mut world, places[0]);
    let (stiff, _) = arm(&mut world, places[1]);
    let (soft, _) = arm(&mut world, places[2]);
    let (weak, loaded) = arm(&mut world, places[3]);
    hang_weight(&mut world, loaded);
    let lift = add_lift(&mut world, places[4]);
    let shaker = add_shaker(&mut world, places[5]);
    drive(&mut world, fan, |joint| {
        joint.set_motor_velocity(JointAxis::AngX, 6.0, 5.0);
    });
    drive(&mut world, weak, |joint| {
        joint.set_motor_position(JointAxis::AngX, 1.0, 900.0, 60.0);
        joint.set_motor_max_force(JointAxis::AngX, 5.0);
    });
    let scene = Scene::new(world, View::flat())
        .showing_joints(0.5)
        .focusing(Vector::new(-2.0, -6.2), Vector::new(2.0 * ACROSS + 2.0, 2.2));
    let labelled = labels.into_iter().zip(places);
    let scene = labelled.fold(scene, |scene, (text, at)| scene.label(at + Vector::Y * 1.5, text));
    scene.script(move |world, step| {
        let side = if (step / HOLD).is_multiple_of(2) { 1.0 } else { -1.0 };
        // Frequency √stiffness, critical damping 2 √stiffness.
        drive(world, stiff, |joint| {
            joint.set_motor_position(JointAxis::AngX, side, 900.0, 60.0);
        });
        drive(world, soft, |joint| {
            joint.set_motor_position(JointAxis::AngX, side, 60.0, 3.0);
        });
        drive(world, lift, |joint| {
            joint.set_motor_position(JointAxis::LinX, 0.8 * side, 200.0, 28.0);
        });
        let wave = (0.5 * step as Real).sin();
        drive(world, shaker, |joint| {
            joint.set_motor_velocity(JointAxis::LinX, 4.0 * wave, 50.0);
        });
    })
}

/// Changes the motor of a joint.
fn drive(world: &mut PhysicsWorld, joint: ImpulseJointHandle, change: impl Fn(&mut GenericJoint)) {
    if let Some(joint) = world.impulse_joints.get_mut(joint) {
        change(&mut joint.data);
    }
}

/// Adds an arm on a post.
fn arm(world: &mut PhysicsWorld, place: Vector) -> (ImpulseJointHandle, RigidBodyHandle) {
    let post = add_post(world, place);
    let body = add(world, place + ARM, ColliderBuilder::cuboid(HALF.x, HALF.y));
    let joint = world.impulse_joints.insert(post, body, hinge().local_anchor2(-ARM), true);
    (joint, body)
}

/// Hangs a weight on a rope from the end of an arm.
fn hang_weight(world: &mut PhysicsWorld, arm: RigidBodyHandle) {
    let end = world.bodies[arm].translation() + ARM;
    let weight = add(world, end - Vector::Y * 0.8, square(0.3).density(2.0));
    let rope = RopeJointBuilder::new(0.5).local_anchor1(ARM).local_anchor2(Vector::Y * 0.3);
    world.insert_impulse_joint(arm, weight, rope);
}

/// Adds a platform that a motor moves up and down, with a box on it.
fn add_lift(world: &mut PhysicsWorld, place: Vector) -> ImpulseJointHandle {
    let shaft = ColliderBuilder::cuboid(0.1, 1.2);
    let post = add_fixed(world, place, shaft.collision_groups(InteractionGroups::none()));
    let platform = add(world, place, ColliderBuilder::cuboid(0.9, 0.1));
    add(world, place + Vector::Y * 0.5, square(0.4));
    let joint = PrismaticJointBuilder::new(Vector::Y).limits([-1.0, 1.0]);
    world.insert_impulse_joint(post, platform, joint)
}

/// Adds a tray that a motor shakes, with balls in it.
fn add_shaker(world: &mut PhysicsWorld, place: Vector) -> ImpulseJointHandle {
    let post = add_post(world, place);
    let tray = add(world, place, ColliderBuilder::cuboid(1.0, 0.1).density(5.0));
    for side in [-1.0, 1.0] {
        let rim = ColliderBuilder::cuboid(0.1, 0.3).translation(Vector::new(side, 0.4));
        world.insert_collider(rim.density(5.0), Some(tray));
    }
    for i in 0..6 {
        let ball = Vector::new(0.28 * (i % 3) as Real - 0.3, 0.3 + 0.3 * (i / 3) as Real);
        add(world, place + ball, ColliderBuilder::ball(0.12));
    }
    let joint = PrismaticJointBuilder::new(Vector::X).limits([-0.6, 0.6]);
    world.insert_impulse_joint(post, tray, joint)
}
