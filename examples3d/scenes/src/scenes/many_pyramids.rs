//! Many small pyramids: many islands that could fall asleep independently.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add_pyramid, cube, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "many_pyramids",
    description: "196 pyramids of 55 boxes each, in 14 rows: 10,780 boxes.",
    category: Category::Stress,
    steps: 120,
    law: Law {
        overlap_max: 0.01,
        height_min: 0.0,
        top_loss_max: 0.1,
        reach_max: 93.0,
        speed_max: 0.1,
        ..Law::NONE
    },
    source: file!(),
    build,
};

/// Boxes at the base of each pyramid.
const BASE: usize = 10;

/// Builds the scene.
pub fn build() -> Scene {
    build_sized(14)
}

/// Builds the scene with this many rows of as many pyramids.
pub fn build_sized(rows: usize) -> Scene {
    let half = 0.5;
    let spacing = 2.0 * half * (BASE + 1) as Real;
    let extent = 0.5 * spacing * rows as Real + spacing;
    let mut world = world_with_floor(2.0 * extent);
    let shape = cube(half).friction(0.6);
    let center = (rows - 1) as Real / 2.0;
    for row in 0..rows {
        for column in 0..rows {
            let x = spacing * (column as Real - center);
            let z = 0.5 * spacing * (row as Real - center);
            add_pyramid(&mut world, Vector::new(x, 0.0, z), BASE, &shape, half);
        }
    }
    Scene::new(world, View::orbit(32.0, 22.0))
}
