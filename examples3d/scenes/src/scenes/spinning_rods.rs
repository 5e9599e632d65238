//! Long thin rods hit the ground while they rotate.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{HALF_TURN, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "spinning_rods",
    description: "Rods that spin at up to 40 rad/s hit the ground: they clatter without a gain of energy.",
    category: Category::PastBugs,
    steps: 240,
    law: Law { overlap_max: 0.01, height_min: 0.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(60.0);
    for i in 0..15 {
        let [column, row] = [i % 5, i / 5].map(|n| n as Real);
        let body = RigidBodyBuilder::dynamic()
            .translation(Vector::new(3.0 * (column - 2.0), 2.5, 3.0 * (row - 1.0)))
            .rotation(Vector::Z * (0.1 * HALF_TURN * column))
            .angvel(Vector::new(3.0, 2.0 * row, 10.0 * column));
        let rod = if row == 1.0 {
            ColliderBuilder::capsule_y(1.0, 0.05)
        } else {
            ColliderBuilder::cuboid(0.05, 1.0, 0.05)
        };
        world.insert(body, rod.restitution(0.2));
    }
    Scene::new(world, View::orbit(25.0, 30.0))
        .focusing(Vector::new(-5.5, 0.0, -3.5), Vector::new(5.5, 1.5, 3.5))
}
