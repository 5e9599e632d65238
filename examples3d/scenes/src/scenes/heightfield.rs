//! Bodies on a landscape.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add, cube};
use crate::rapier::parry::utils::Array2;
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "heightfield",
    description: "Boxes, balls and cylinders tumble down the hills of a height field.",
    category: Category::Shapes,
    steps: 300,
    law: Law { overlap_max: 0.01, height_min: -1.0, reach_max: 10.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Cells along each side.
const CELLS: usize = 40;
/// Length of a side.
const SIDE: Real = 24.0;

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = PhysicsWorld::new();
    let mut heights = Array2::zeros(CELLS + 1, CELLS + 1);
    for i in 0..=CELLS {
        for j in 0..=CELLS {
            let [z, x] = [i, j].map(|n| n as Real / CELLS as Real - 0.5);
            let hills = (x * 11.0).sin() * (z * 9.0).cos();
            // The rim is higher, so that no body leaves.
            heights[(i, j)] = hills + 14.0 * (x * x + z * z);
        }
    }
    let field = ColliderBuilder::heightfield(heights, Vector::new(SIDE, 1.0, SIDE));
    world.insert(RigidBodyBuilder::fixed(), field);
    for i in 0..144 {
        let [x, z] = [i % 12, i / 12].map(|n| 1.3 * (n as Real - 5.5));
        let shape = match i % 3 {
            0 => ColliderBuilder::ball(0.4),
            1 => cube(0.35),
            _ => ColliderBuilder::cylinder(0.35, 0.3),
        };
        add(&mut world, Vector::new(x, 5.0 + 0.1 * (i % 7) as Real, z), shape);
    }
    Scene::new(world, View::orbit(30.0, 38.0))
        .focusing(Vector::new(-9.0, 0.0, -7.0), Vector::new(9.0, 3.0, 7.0))
}
