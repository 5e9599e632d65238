//! Restitution: heights of bouncing bodies.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "restitution",
    description: "Balls with a restitution from 0 to 1 fall from the same height.",
    category: Category::Basics,
    steps: 130,
    law: Law { overlap_max: 0.05, height_min: 0.0, reach_max: 9.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(50.0);
    for i in 0..=20 {
        let restitution = i as Real / 20.0;
        // The floor's own restitution of 0 must not damp the bounce.
        let shape = ColliderBuilder::ball(0.35)
            .restitution(restitution)
            .restitution_combine_rule(CoefficientCombineRule::Max);
        add(&mut world, Vector::new(0.8 * (i as Real - 10.0), 6.0), shape);
    }
    Scene::new(world, View::flat())
}
