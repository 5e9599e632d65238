//! One large pyramid: a single island, with its load on 100 layers.
//!
//! After 20 steps no overlap is deeper than 0.036. No body is below 0.1 or farther out than 58.0. The top is
//! above 96.01.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add_pyramid, square, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "large_pyramid",
    description: "A pyramid of 5,050 boxes, 100 at its base.",
    category: Category::Stress,
    steps: 200,
    law: Law {
        overlap_max: 0.036,
        height_min: 0.1,
        reach_max: 58.0,
        top_min: 96.01,
        ..Law::after(20)
    },
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    build_sized(100)
}

/// Builds a pyramid with this many boxes at its base.
pub fn build_sized(base: usize) -> Scene {
    let mut world = world_with_floor(200.0);
    add_pyramid(&mut world, Vector::ZERO, base, &square(0.5).friction(0.6), 0.5);
    Scene::new(world, View::flat())
}
