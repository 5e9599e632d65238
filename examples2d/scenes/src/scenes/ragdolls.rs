//! A thousand ragdolls fall on uneven ground.

use super::ragdoll_stairs::add_ragdoll;
use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add_fixed, add_walls, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "ragdolls",
    description: "1,000 ragdolls of ten bodies each fall on uneven ground: 9,000 hinges with limits.",
    category: Category::Joints,
    steps: 300,
    law: Law { overlap_max: 0.2, height_min: 0.0, reach_max: 46.0, gap_max: 0.5, ..Law::NONE },
    source: file!(),
    build,
};

/// Number of ragdolls per row, and their distance.
const COLUMNS: usize = 50;
const SPACING: Real = 1.6;

/// Builds the scene.
pub fn build() -> Scene {
    build_sized(1000)
}

/// Builds the scene with this many ragdolls.
pub fn build_sized(people: usize) -> Scene {
    let mut world = world_with_floor(100.0);
    let width = COLUMNS as Real * SPACING;
    add_walls(&mut world, 0.5 * width + 1.0, 60.0);
    for i in 0..COLUMNS {
        let place = Vector::new((i as Real + 0.5) * SPACING - 0.5 * width, 0.0);
        add_fixed(&mut world, place, ColliderBuilder::ball(0.5));
    }
    for i in 0..people {
        let [column, row] = [i % COLUMNS, i / COLUMNS].map(|n| n as Real);
        let aside = if (i / COLUMNS).is_multiple_of(2) { 0.3 } else { 0.0 };
        let x = (column + 0.5) * SPACING + aside - 0.5 * width;
        add_ragdoll(&mut world, Vector::new(x, 2.5 + 2.4 * row), None);
    }
    Scene::new(world, View::flat())
}
