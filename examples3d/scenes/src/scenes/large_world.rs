//! A large world at rest with few moving bodies: bodies at rest must take no time.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add, add_fixed, cube};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "large_world",
    description: "40,000 fixed blocks, and 99 bodies that move.",
    category: Category::Robustness,
    steps: 300,
    law: Law { overlap_max: 0.01, height_min: -1.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    build_sized(200)
}

/// Builds the scene with a square of this many fixed blocks along each side.
pub fn build_sized(side: usize) -> Scene {
    let mut world = PhysicsWorld::new();
    let center = side as Real / 2.0;
    for row in 0..side {
        for column in 0..side {
            let [x, z] = [column, row].map(|n| n as Real - center);
            let wave = (0.35 * x).sin() * (0.3 * z).cos();
            add_fixed(
                &mut world,
                Vector::new(x, wave - 1.0, z),
                ColliderBuilder::cuboid(0.5, 1.0, 0.5),
            );
        }
    }
    for i in 0..99 {
        let [x, y, z] = [i % 3, i / 9 % 11, i / 3 % 3].map(|n| n as Real);
        let place = Vector::new(1.2 * (x - 1.0), 3.0 + 1.2 * y, 1.2 * (z - 1.0));
        let shape = if i % 2 == 0 { ColliderBuilder::ball(0.4) } else { cube(0.4) };
        add(&mut world, place, shape);
    }
    Scene::new(world, View::orbit(30.0, 35.0))
        .focusing(Vector::new(-14.0, -1.0, -14.0), Vector::new(14.0, 3.0, 14.0))
}
