//! Kinematic platforms with loads.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add, cube, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "platforms",
    description: "Kinematic platforms, one driven by velocity and one by position, carry boxes; a third turns.",
    category: Category::Basics,
    steps: 330,
    law: Law { overlap_max: 0.1, height_min: 0.0, reach_max: 12.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(50.0);
    let plate = ColliderBuilder::cuboid(2.5, 0.2, 2.5).friction(1.0);
    let by_velocity =
        RigidBodyBuilder::kinematic_velocity_based().translation(Vector::new(-7.0, 1.0, 0.0));
    let (by_velocity, _) = world.insert(by_velocity, plate.clone());
    let by_position =
        RigidBodyBuilder::kinematic_position_based().translation(Vector::new(0.0, 1.0, 0.0));
    let (by_position, _) = world.insert(by_position, plate.clone());
    let turning = RigidBodyBuilder::kinematic_velocity_based()
        .translation(Vector::new(7.0, 1.0, 0.0))
        .angvel(Vector::Y * 0.8);
    world.insert(turning, plate);

    for center in [-7.0, 0.0, 7.0] {
        for i in 0..27 {
            let [x, y, z] = [i % 3, i / 9, i / 3 % 3].map(|n| n as Real);
            let place = Vector::new(center - 0.9 + 0.9 * x, 1.7 + 0.85 * y, -0.9 + 0.9 * z);
            add(&mut world, place, cube(0.4));
        }
    }
    Scene::new(world, View::orbit(20.0, 22.0)).script(move |world, step| {
        let time = step as Real * world.integration_parameters.dt;
        if let Some(body) = world.bodies.get_mut(by_velocity) {
            body.set_linvel(Vector::new(0.0, (2.0 * time).sin(), 1.5 * time.cos()), true);
        }
        if let Some(body) = world.bodies.get_mut(by_position) {
            let lift = 1.5 - 1.0 * (1.5 * time).cos();
            body.set_next_kinematic_translation(Vector::new(0.0, lift, 1.5 * time.sin()));
        }
    })
}
