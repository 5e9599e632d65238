//! A car whose wheels, springs and steering are joints.

use crate::common::{Dice, Law, Scene, SceneInfo};
use crate::kit::{HALF_TURN, add, add_fixed, add_pyramid, cube, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "jointed_car",
    description: "A car on joints drives a curve over planks: hubs slide on springs and steer, motors turn the wheels.",
    category: Category::Controllers,
    steps: 300,
    // The car drives and throws boxes.
    law: Law { overlap_max: 0.01, height_min: 0.0, reach_max: 40.0, gap_max: 0.005, ..Law::NONE },
    source: file!(),
    build,
};

/// Half extents of the chassis, and the position of the front right wheel.
const HALF: Vector = Vector::new(2.0, 0.3, 0.8);
const WHEEL: Vector = Vector::new(1.4, -0.35, 1.1);
/// Radius and half width of a wheel.
const RADIUS: Real = 0.5;
const HALF_WIDTH: Real = 0.15;
/// Velocity of the motors (rad/s) and their torque, and the angle of the front wheels in the curve (rad).
const SPEED: Real = 14.0;
const TORQUE: Real = 9.0;
const STEERING: Real = 0.22;
/// Stiffness and damping of the steering: torque by angle, and by angular velocity.
const STIFFNESS: Real = 100.0;
const DAMPING: Real = 3.0;

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(60.0);
    add_planks(&mut world);
    add_pyramid(&mut world, Vector::new(14.0, 0.0, 13.0), 5, &cube(0.4).density(0.3), 0.4);
    let chassis = ColliderBuilder::cuboid(HALF.x, HALF.y, HALF.z).density(2.0);
    let chassis = add(&mut world, Vector::new(-13.0, 1.0, 0.0), chassis);
    let cabin = ColliderBuilder::cuboid(0.9, 0.3, 0.7).translation(Vector::new(-0.2, 0.6, 0.0));
    world.insert_collider(cabin.density(0.2), Some(chassis));
    let mut steered = Vec::new();
    for (x, z) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
        let place = Vector::new(x * WHEEL.x, WHEEL.y, z * WHEEL.z);
        let hub = add_wheel(&mut world, chassis, place);
        if x > 0.0 {
            steered.push(hub);
        }
    }
    let view = View::orbit(40.0, 22.0);
    Scene::new(world, view)
        .focusing(Vector::new(-14.0, 0.0, -3.0), Vector::new(15.0, 3.0, 15.0))
        .script(move |world, step| {
            let target = if step > 110 { -STEERING } else { 0.0 };
            for &hub in &steered {
                let joint = &mut world.impulse_joints[hub].data;
                joint.set_motor_position(JointAxis::AngY, target, STIFFNESS, DAMPING);
            }
        })
}

/// Adds planks across the road, and some stones.
fn add_planks(world: &mut PhysicsWorld) {
    for i in 0..6 {
        let plank = ColliderBuilder::cuboid(0.15, 0.1, 2.5);
        add_fixed(world, Vector::new(-9.0 + 1.7 * i as Real, 0.05, 0.0), plank);
    }
    let mut dice = Dice::new(7);
    for _ in 0..40 {
        let place = Vector::new(dice.between(3.0, 13.0), 0.15, dice.between(-1.0, 12.0));
        add(world, place, cube(dice.between(0.05, 0.12)));
    }
}

/// Adds a hub that slides vertically and steers about the vertical, and a wheel on it. Returns the hub's
/// joint.
fn add_wheel(
    world: &mut PhysicsWorld,
    chassis: RigidBodyHandle,
    place: Vector,
) -> ImpulseJointHandle {
    let at = world.bodies[chassis].translation() + place;
    let hub = cube(0.12).density(20.0).collision_groups(InteractionGroups::none());
    let hub = add(world, at, hub);
    let free = JointAxesMask::LIN_Y | JointAxesMask::ANG_Y;
    let suspension = GenericJointBuilder::new(JointAxesMask::LOCKED_FIXED_AXES - free)
        .local_anchor1(place)
        .limits(JointAxis::LinY, [-0.2, 0.25])
        // With a quarter of the car's mass: 2 Hz, and half of critical damping.
        .motor_model(JointAxis::LinY, MotorModel::ForceBased)
        .motor_position(JointAxis::LinY, -0.05, 400.0, 30.0)
        .motor_model(JointAxis::AngY, MotorModel::ForceBased)
        .motor_position(JointAxis::AngY, 0.0, STIFFNESS, DAMPING);
    let suspension = world.insert_impulse_joint(chassis, hub, suspension);

    // The axis of a cylinder is Y, that of a wheel is Z.
    let wheel = ColliderBuilder::cylinder(HALF_WIDTH, RADIUS)
        .rotation(Vector::X * (0.5 * HALF_TURN))
        .friction(1.2);
    let wheel = add(world, at, wheel);
    let axle = RevoluteJointBuilder::new(Vector::Z)
        .motor_model(MotorModel::ForceBased)
        .motor_velocity(-SPEED, 3.0)
        .motor_max_force(TORQUE)
        .contacts_enabled(false);
    world.insert_impulse_joint(hub, wheel, axle);
    suspension
}
