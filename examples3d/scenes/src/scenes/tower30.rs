//! A tower, which accumulates errors of the solver from the bottom to the top.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add, cube, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "tower30",
    description: "A tower of 30 boxes stays up and falls asleep.",
    category: Category::Stress,
    steps: 300,
    law: Law {
        overlap_max: 0.02,
        height_min: 0.0,
        top_loss_max: 0.3,
        reach_max: 1.0,
        speed_max: 0.1,
        ..Law::NONE
    },
    source: file!(),
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    build_sized(30)
}

/// Builds a tower of this many boxes.
pub fn build_sized(boxes: usize) -> Scene {
    let mut world = world_with_floor(100.0);
    for i in 0..boxes {
        add(&mut world, Vector::Y * (0.5 + i as Real), cube(0.5).friction(0.6));
    }
    Scene::new(world, View::orbit(30.0, 10.0))
}
