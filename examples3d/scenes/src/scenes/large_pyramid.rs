//! One large pyramid: all of it is one island, and its load is passed on through 100 layers.

use crate::common::{Scene, SceneInfo};
use crate::kit::{add_pyramid, cube, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// The scene's entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "large_pyramid",
    description: "A pyramid of 5,050 boxes, 100 at its base.",
    category: Category::Stress,
    steps: 200,
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
