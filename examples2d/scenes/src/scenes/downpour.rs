//! Simple shapes rain into a basin.

use crate::common::{Dice, Law, Scene, SceneInfo};
use crate::kit::{add, add_walls, stone, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "downpour",
    description: "4,000 balls, boxes, capsules and stones rain into a basin.",
    category: Category::Basics,
    steps: 300,
    law: Law { overlap_max: 0.1, height_min: 0.0, reach_max: 36.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Bodies in a row.
const COLUMNS: usize = 50;

/// Builds the scene.
pub fn build() -> Scene {
    build_sized(4000)
}

/// Builds the scene with this many bodies.
pub fn build_sized(count: usize) -> Scene {
    let mut world = world_with_floor(200.0);
    add_walls(&mut world, 32.0, 40.0);
    let mut dice = Dice::new(23);
    let stone = ColliderBuilder::convex_hull(&stone(&mut dice, 0.45, 6));
    let shapes = [
        ColliderBuilder::ball(0.38),
        ColliderBuilder::cuboid(0.45, 0.3),
        ColliderBuilder::capsule_y(0.3, 0.25),
        stone.expect("corners on a circle have a hull"),
    ];
    for i in 0..count {
        let [column, row] = [i % COLUMNS, i / COLUMNS].map(|n| n as Real);
        let x = 1.2 * (column - (COLUMNS - 1) as Real / 2.0) + dice.between(-0.1, 0.1);
        add(&mut world, Vector::new(x, 1.0 + 1.15 * row), shapes[i % 4].clone());
    }
    Scene::new(world, View::flat())
}
