//! A car whose wheels and springs are joints.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add, add_fixed, add_pyramid, hinge, square, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "jointed_car",
    description: "A car drives over bumps and a seesaw: each wheel slides on a spring and is turned by a motor, all in one joint.",
    category: Category::Controllers,
    steps: 260,
    law: Law { overlap_max: 0.01, height_min: 0.0, gap_max: 0.005, ..Law::NONE },
    source: file!(),
    build,
};

/// Half extents of the chassis, and the position of the front wheel.
const HALF: Vector = Vector::new(1.4, 0.25);
const WHEEL: Vector = Vector::new(0.95, -0.45);
const RADIUS: Real = 0.42;
/// Velocity of the motors (rad/s), and their largest torque.
const SPEED: Real = 16.0;
const TORQUE: Real = 6.0;

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(200.0);
    for i in 0..6 {
        let bump = ColliderBuilder::ball(0.6);
        add_fixed(&mut world, Vector::new(-6.0 + 1.6 * i as Real, -0.45), bump);
    }
    add_seesaw(&mut world, Vector::new(7.5, 0.0));
    add_pyramid(&mut world, Vector::new(15.0, 0.0), 5, &square(0.3).density(0.2), 0.3);

    let chassis = ColliderBuilder::cuboid(HALF.x, HALF.y).density(2.0);
    let chassis = add(&mut world, Vector::new(-10.0, 1.1), chassis);
    let cabin = ColliderBuilder::cuboid(0.6, 0.2).translation(Vector::new(-0.1, 0.45));
    world.insert_collider(cabin.density(0.3), Some(chassis));
    for x in [-WHEEL.x, WHEEL.x] {
        add_wheel(&mut world, chassis, Vector::new(x, WHEEL.y));
    }
    Scene::new(world, View::flat()).focusing(Vector::new(-11.0, -0.5), Vector::new(18.0, 8.0))
}

/// Adds a driven wheel that slides vertically on a spring.
fn add_wheel(world: &mut PhysicsWorld, chassis: RigidBodyHandle, place: Vector) {
    let at = world.bodies[chassis].translation() + place;
    let wheel = add(world, at, ColliderBuilder::ball(RADIUS).friction(1.2));
    let joint = GenericJointBuilder::new(JointAxesMask::LIN_X)
        .local_anchor1(place)
        .limits(JointAxis::LinY, [-0.25, 0.3])
        // With half of the car's mass: 2 Hz, and half of critical damping.
        .motor_model(JointAxis::LinY, MotorModel::ForceBased)
        .motor_position(JointAxis::LinY, -0.05, 280.0, 22.0)
        .motor_model(JointAxis::AngX, MotorModel::ForceBased)
        .motor_velocity(JointAxis::AngX, -SPEED, 4.0)
        .motor_max_force(JointAxis::AngX, TORQUE)
        .contacts_enabled(false);
    world.insert_impulse_joint(chassis, wheel, joint);
}

/// Adds a board that rotates on a post.
fn add_seesaw(world: &mut PhysicsWorld, foot: Vector) {
    let pivot = foot + Vector::Y * 0.7;
    let post = add_fixed(world, foot + Vector::Y * 0.35, ColliderBuilder::cuboid(0.15, 0.35));
    let board = RigidBodyBuilder::dynamic().translation(pivot).rotation(0.25);
    let (board, _) = world.insert(board, ColliderBuilder::cuboid(2.6, 0.08));
    let joint = hinge().local_anchor1(Vector::Y * 0.35).limits([-0.26, 0.26]);
    world.insert_impulse_joint(post, board, joint.contacts_enabled(false));
}
