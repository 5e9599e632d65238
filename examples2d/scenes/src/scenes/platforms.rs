//! Kinematic platforms with loads.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add, square, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "platforms",
    description: "Kinematic platforms, one driven by velocity and one by position, carry boxes; a third rocks.",
    category: Category::Basics,
    steps: 330,
    // Bodies still land: these overlap by up to a quarter of their size.
    law: Law { overlap_max: 0.2, height_min: 0.0, reach_max: 17.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(50.0);
    let plate = ColliderBuilder::cuboid(3.0, 0.2).friction(1.0);
    let mut platforms = Vec::new();
    for (x, body) in [
        (-8.0, RigidBodyBuilder::kinematic_velocity_based()),
        (0.0, RigidBodyBuilder::kinematic_position_based()),
        (8.0, RigidBodyBuilder::kinematic_velocity_based()),
    ] {
        platforms.push(world.insert(body.translation(Vector::new(x, 3.0)), plate.clone()).0);
        for i in 0..20 {
            let [column, row] = [i % 5, i / 5].map(|n| n as Real);
            add(&mut world, Vector::new(x - 1.8 + 0.9 * column, 3.7 + 0.85 * row), square(0.4));
        }
    }
    Scene::new(world, View::flat()).script(move |world, step| {
        let time = step as Real * world.integration_parameters.dt;
        let bodies = &mut world.bodies;
        if let Some(body) = bodies.get_mut(platforms[0]) {
            body.set_linvel(Vector::new(1.5 * time.cos(), (2.0 * time).sin()), true);
        }
        if let Some(body) = bodies.get_mut(platforms[1]) {
            body.set_next_kinematic_translation(Vector::new(1.5 * time.sin(), 4.0 - time.cos()));
        }
        if let Some(body) = bodies.get_mut(platforms[2]) {
            body.set_angvel(0.3 * (1.5 * time).cos(), true);
        }
    })
}
