//! A pyramid of medium size, which must settle and fall asleep.
//!
//! After 20 steps no overlap is deeper than 0.01. No body is below 0.1, farther out than 12.0 or faster than
//! 0.15. The top is above 18.88.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add_pyramid, square, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "pyramid20",
    description: "A pyramid of 20 rows settles and falls asleep.",
    category: Category::Stress,
    steps: 300,
    law: Law {
        overlap_max: 0.01,
        height_min: 0.1,
        reach_max: 12.0,
        speed_max: 0.15,
        top_min: 18.88,
        ..Law::after(20)
    },
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    build_sized(20)
}

/// Builds a pyramid with this many rows.
pub fn build_sized(rows: usize) -> Scene {
    let mut world = world_with_floor(100.0);
    add_pyramid(&mut world, Vector::ZERO, rows, &square(0.5).friction(0.6), 0.5);
    Scene::new(world, View::flat())
}
