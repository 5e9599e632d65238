//! Mass ratios in stacks: light boxes carry a heavy one.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add, square, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "heavy_on_light",
    description: "Stacks of light boxes carry a box 1, 10, 30 and 100 times as heavy as each of them.",
    category: Category::Robustness,
    steps: 300,
    law: Law {
        overlap_max: 0.02,
        height_min: 0.0,
        top_loss_max: 0.1,
        reach_max: 6.0,
        speed_max: 0.1,
        ..Law::NONE
    },
    source: file!(),
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(50.0);
    for (i, ratio) in [1.0, 10.0, 30.0, 100.0].into_iter().enumerate() {
        let foot = Vector::X * (3.0 * (i as Real - 1.5));
        for layer in 0..4 {
            add(&mut world, foot + Vector::Y * (0.5 + layer as Real), square(0.5));
        }
        add(&mut world, foot + Vector::Y * 4.5, square(0.5).density(ratio));
    }
    Scene::new(world, View::flat())
}
