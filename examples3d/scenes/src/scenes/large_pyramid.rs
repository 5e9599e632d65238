//! One large pyramid: a single island, with its load on 100 layers.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add_pyramid, cube, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "large_pyramid",
    description: "A pyramid of 5,050 boxes, 100 at its base.",
    category: Category::Stress,
    steps: 200,
    law: Law {
        overlap_max: 0.02,
        height_min: 0.0,
        top_loss_max: 1.0,
        reach_max: 55.0,
        ..Law::NONE
    },
    source: file!(),
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    build_sized(100)
}

/// Builds a pyramid with this many boxes at its base.
pub fn build_sized(base: usize) -> Scene {
    let mut world = world_with_floor(200.0);
    add_pyramid(&mut world, Vector::ZERO, base, &cube(0.5).friction(0.6), 0.5);
    Scene::new(world, View::orbit(25.0, 10.0))
}
