//! A block crashes into a crowd: a shock that spreads, with thousands of new pairs.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add, square};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "smash",
    description: "A heavy block flies into 9,600 weightless boxes.",
    category: Category::Stress,
    steps: 180,
    law: Law { overlap_max: 0.01, ..Law::NONE },
    source: file!(),
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    build_sized(80)
}

/// Builds this many rows of boxes, each with 1.5 times as many boxes.
pub fn build_sized(rows: usize) -> Scene {
    let mut world = PhysicsWorld::new();
    world.gravity = Vector::ZERO;
    let block =
        RigidBodyBuilder::dynamic().translation(Vector::new(-20.0, 0.0)).linvel(Vector::X * 40.0);
    world.insert(block, square(4.0).density(8.0));
    let (size, columns) = (0.4, rows + rows / 2);
    let shape = square(0.5 * size);
    for column in 0..columns {
        for row in 0..rows {
            let x = size * column as Real - 12.0;
            let y = size * (row as Real - (rows - 1) as Real / 2.0);
            add(&mut world, Vector::new(x, y), shape.clone());
        }
    }
    Scene::new(world, View::flat())
}
