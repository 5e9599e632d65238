//! Dominance groups: bodies of lower groups do not affect bodies of higher ones, whatever their mass.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{cube, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "dominance",
    description: "Balls shot at walls: those with a higher dominance group pass through as if the wall had no mass.",
    category: Category::Basics,
    steps: 110,
    law: Law { overlap_max: 0.01, height_min: 0.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(60.0);
    for (lane, dominance) in [-1, 0, 1].into_iter().enumerate() {
        let z = 6.0 * (lane as Real - 1.0);
        for layer in 0..6 {
            for column in 0..4 {
                let place = Vector::new(0.0, 0.5 + layer as Real, z - 1.5 + column as Real);
                world.insert(RigidBodyBuilder::dynamic().translation(place), cube(0.5));
            }
        }
        let ball = RigidBodyBuilder::dynamic()
            .translation(Vector::new(-10.0, 2.5, z))
            .linvel(Vector::new(12.0, 2.0, 0.0))
            .dominance_group(dominance);
        world.insert(ball, ColliderBuilder::ball(0.8));
    }
    Scene::new(world, View::orbit(40.0, 22.0))
}
