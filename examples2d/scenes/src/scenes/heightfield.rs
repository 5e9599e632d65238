//! Bodies on a landscape.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add, square};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "heightfield",
    description: "Boxes, balls and capsules tumble down the hills of a height field.",
    category: Category::Shapes,
    steps: 300,
    law: Law { overlap_max: 0.01, height_min: -2.0, reach_max: 16.0, speed_max: 0.1, ..Law::NONE },
    source: file!(),
    build,
};

/// Number of heights.
const SAMPLES: usize = 90;
/// Width of the landscape.
const WIDTH: Real = 40.0;

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = PhysicsWorld::new();
    let heights = (0..SAMPLES)
        .map(|i| {
            let x = i as Real / (SAMPLES - 1) as Real - 0.5;
            // The rim is higher, so that no body leaves.
            1.2 * (x * 25.0).sin() + 0.4 * (x * 61.0).cos() + 28.0 * x * x
        })
        .collect();
    let field = ColliderBuilder::heightfield(heights, Vector::new(WIDTH, 1.0));
    world.insert(RigidBodyBuilder::fixed(), field);
    for i in 0..120 {
        let place = Vector::new(1.1 * ((i % 24) as Real - 11.5), 8.0 + (i / 24) as Real);
        let shape = match i % 3 {
            0 => ColliderBuilder::ball(0.35),
            1 => square(0.32),
            _ => ColliderBuilder::capsule_x(0.3, 0.22),
        };
        add(&mut world, place, shape);
    }
    Scene::new(world, View::flat()).focusing(Vector::new(-19.0, -1.0), Vector::new(19.0, 9.0))
}
