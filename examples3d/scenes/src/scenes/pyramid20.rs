//! A pyramid of medium size, which must settle and fall asleep.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add_pyramid, cube, world_with_floor};
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "pyramid20",
    description: "A pyramid of 20 rows settles and falls asleep.",
    category: Category::Stress,
    steps: 300,
    law: Law {
        overlap_max: 0.01,
        height_min: 0.0,
        top_loss_max: 0.2,
        reach_max: 11.0,
        speed_max: 0.1,
        ..Law::NONE
    },
    source: file!(),
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    build_sized(20)
}

/// Builds a pyramid with this many rows.
pub fn build_sized(rows: usize) -> Scene {
    let mut world = world_with_floor(100.0);
    add_pyramid(
        &mut world,
        crate::rapier::prelude::Vector::ZERO,
        rows,
        &cube(0.5).friction(0.6),
        0.5,
    );
    Scene::new(world, View::orbit(25.0, 14.0))
}
