//! A thousand boxes on a mesh of two hundred thousand triangles.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add, hills, surface};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "fine_mesh",
    description: "1,000 boxes fall on hills of 200,000 triangles, each smaller than a box.",
    category: Category::Stress,
    steps: 300,
    law: Law { overlap_max: 0.01, height_min: -1.0, reach_max: 41.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Number of squares of two triangles along each side, and their length.
const SQUARES: u32 = 317;
const SIZE: Real = 0.3;
/// Boxes along each side of the crowd.
const BOXES: usize = 32;

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = PhysicsWorld::new();
    world.insert(RigidBodyBuilder::fixed(), surface(SQUARES, SIZE, height));
    for i in 0..1_000 {
        let [x, z] = [i % BOXES, i / BOXES].map(|n| 1.6 * (n as Real - 0.5 * BOXES as Real));
        let y = height(x, z) + 1.5 + 0.3 * (i % 5) as Real;
        add(&mut world, Vector::new(x, y, z), ColliderBuilder::cuboid(0.5, 0.3, 0.4));
    }
    Scene::new(world, View::orbit(28.0, 60.0))
        .focusing(Vector::new(-24.0, -2.0, -20.0), Vector::new(24.0, 4.0, 24.0))
}

/// Returns the height of the ground.
fn height(x: Real, z: Real) -> Real {
    hills(0.8, x, z)
}
