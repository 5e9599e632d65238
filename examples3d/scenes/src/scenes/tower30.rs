//! A tower, which accumulates errors of the solver from the bottom to the top.
//!
//! After 20 steps no overlap is deeper than 0.026. No body is below 0.1, farther out than 0.51 or faster than
//! 0.11. The top is above 28.42.

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
        overlap_max: 0.026,
        height_min: 0.1,
        reach_max: 0.51,
        speed_max: 0.11,
        top_min: 28.42,
        ..Law::after(20)
    },
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
