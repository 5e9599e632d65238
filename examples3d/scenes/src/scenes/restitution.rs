//! Restitution: heights of bouncing bodies.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add, cube, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "restitution",
    description: "Balls and boxes with a restitution from 0 to 1 fall from the same height.",
    category: Category::Basics,
    steps: 130,
    law: Law { overlap_max: 0.05, height_min: 0.0, reach_max: 9.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(50.0);
    for i in 0..=10 {
        let restitution = i as Real / 10.0;
        let x = 1.5 * (i as Real - 5.0);
        for (z, shape) in [(0.0, ColliderBuilder::ball(0.4)), (2.0, cube(0.35))] {
            // The floor's own restitution of 0 must not damp the bounce.
            let shape = shape
                .restitution(restitution)
                .restitution_combine_rule(CoefficientCombineRule::Max);
            add(&mut world, Vector::new(x, 6.0, z), shape);
        }
    }
    Scene::new(world, View::orbit(15.0, 12.0))
}
