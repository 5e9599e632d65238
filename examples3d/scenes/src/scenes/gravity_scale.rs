//! Gravity scales: more, less and inverted gravity.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add_fixed, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "gravity_scale",
    description: "Balls with a gravity scale from -1 to 2 between floor and ceiling.",
    category: Category::Basics,
    steps: 55,
    law: Law { overlap_max: 0.1, height_min: 0.0, reach_max: 10.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(50.0);
    add_fixed(&mut world, Vector::Y * 10.2, ColliderBuilder::cuboid(10.0, 0.2, 1.5));
    for i in 0..=12 {
        let scale = -1.0 + 0.25 * i as Real;
        let place = Vector::new(1.4 * (i as Real - 6.0), 5.0, 0.0);
        let body = RigidBodyBuilder::dynamic().translation(place).gravity_scale(scale);
        world.insert(body, ColliderBuilder::ball(0.5));
    }
    Scene::new(world, View::orbit(12.0, 8.0))
}
