//! Forces, impulses and torques.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::world_with_floor;
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "forces",
    description: "Drones hold their height by forces, hoppers jump by impulses, a top is spun up by a torque.",
    category: Category::Basics,
    steps: 300,
    law: Law { overlap_max: 0.01, height_min: 0.0, reach_max: 6.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(50.0);
    let mut place = |x: Real, y: Real, z: Real, shape: ColliderBuilder| {
        let body = RigidBodyBuilder::dynamic().translation(Vector::new(x, y, z)).can_sleep(false);
        world.insert(body, shape).0
    };
    let drones: Vec<_> = (0..5)
        .map(|i| place(-4.0 + 2.0 * i as Real, 0.3, -2.5, ColliderBuilder::cuboid(0.6, 0.12, 0.6)))
        .collect();
    let hoppers: Vec<_> = (0..5)
        .map(|i| place(-4.0 + 2.0 * i as Real, 0.4, 0.5, ColliderBuilder::ball(0.4)))
        .collect();
    let top =
        place(0.0, 0.65, 3.5, ColliderBuilder::cylinder(0.12, 1.3).translation(Vector::Y * 0.1));
    Scene::new(world, View::orbit(25.0, 22.0)).script(move |world, step| {
        for (i, &drone) in drones.iter().enumerate() {
            let Some(drone) = world.bodies.get_mut(drone) else { continue };
            let goal = 2.0 + 0.7 * i as Real;
            hover(drone, goal, world.gravity);
        }
        for (i, &hopper) in hoppers.iter().enumerate() {
            let Some(hopper) = world.bodies.get_mut(hopper) else { continue };
            if step % 70 == 14 * i {
                hopper.apply_impulse(Vector::Y * (hopper.mass() * 6.0), true);
            }
        }
        if let Some(top) = world.bodies.get_mut(top) {
            top.reset_torques(false);
            if step < 120 {
                top.add_torque(Vector::Y * 12.0, true);
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
