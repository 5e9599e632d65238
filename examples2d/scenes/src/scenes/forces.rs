//! Forces, impulses and torques.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::world_with_floor;
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "forces",
    description: "Drones hold their height by forces, hoppers jump by impulses, wheels are spun up by torques.",
    category: Category::Basics,
    steps: 300,
    law: Law { overlap_max: 0.01, height_min: 0.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(50.0);
    let mut place = |x: Real, y: Real, shape: ColliderBuilder| {
        let body = RigidBodyBuilder::dynamic().translation(Vector::new(x, y)).can_sleep(false);
        world.insert(body, shape).0
    };
    let drones: Vec<_> = (0..5)
        .map(|i| place(-12.0 + 2.0 * i as Real, 0.3, ColliderBuilder::cuboid(0.7, 0.15)))
        .collect();
    let hoppers: Vec<_> =
        (0..5).map(|i| place(-1.0 + 1.5 * i as Real, 0.4, ColliderBuilder::ball(0.4))).collect();
    let wheels: Vec<_> = (0..3)
        .map(|i| place(9.0 + 2.5 * i as Real, 0.8, ColliderBuilder::ball(0.8).friction(1.0)))
        .collect();
    Scene::new(world, View::flat()).script(move |world, step| {
        for (i, &drone) in drones.iter().enumerate() {
            if let Some(drone) = world.bodies.get_mut(drone) {
                hover(drone, 2.0 + 0.8 * i as Real, world.gravity);
            }
        }
        for (i, &hopper) in hoppers.iter().enumerate() {
            let Some(hopper) = world.bodies.get_mut(hopper) else { continue };
            if step % 70 == 14 * i {
                hopper.apply_impulse(Vector::Y * (hopper.mass() * 6.0), true);
            }
        }
        for (i, &wheel) in wheels.iter().enumerate() {
            let Some(wheel) = world.bodies.get_mut(wheel) else { continue };
            wheel.reset_torques(false);
            if step < 60 {
                wheel.add_torque(-1.0 - i as Real, true);
            }
        }
    })
}

/// Sets the force that moves a drone to a height and keeps it there: a spring and a damper, plus its weight.
fn hover(drone: &mut RigidBody, goal: Real, gravity: Vector) {
    let error = goal - drone.translation().y;
    let acceleration = Vector::Y * (6.0 * error - 4.0 * drone.linvel().y) - gravity;
    let force = acceleration * drone.mass();
    drone.reset_forces(false);
    drone.add_force(force, true);
}
