//! Dominoes: one push topples all.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add_fixed, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "dominoes",
    description: "Rows of dominoes on shelves fall, one after the other.",
    category: Category::Basics,
    steps: 420,
    law: Law { overlap_max: 0.01, height_min: 0.0, reach_max: 13.0, speed_max: 0.1, ..Law::NONE },
    source: file!(),
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(50.0);
    for shelf in 0..4 {
        let y = 3.0 * shelf as Real;
        if shelf > 0 {
            add_fixed(&mut world, Vector::new(0.0, y - 0.1), ColliderBuilder::cuboid(11.0, 0.1));
        }
        for i in 0..30 {
            let mut body = RigidBodyBuilder::dynamic()
                .translation(Vector::new(0.7 * (i as Real - 14.5), y + 0.7));
            if i == 0 {
                body = body.linvel(Vector::X * 0.8).angvel(-1.5);
            }
            world.insert(body, ColliderBuilder::cuboid(0.08, 0.7));
        }
    }
    Scene::new(world, View::flat())
}
