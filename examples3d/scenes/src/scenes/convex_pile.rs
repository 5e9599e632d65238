//! Rocks in a heap: half of the time goes to contact computation.

use crate::common::{Dice, Law, Scene, SceneInfo};
use crate::kit::{add, rock, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "convex_pile",
    description: "5,120 convex rocks fall onto a heap.",
    category: Category::Stress,
    steps: 200,
    law: Law { overlap_max: 0.1, height_min: -1.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Rocks along each side of a layer.
const SIDE: usize = 16;
/// Number of different rocks.
const KINDS: usize = 16;

/// Builds the scene.
pub fn build() -> Scene {
    build_sized(20)
}

/// Builds the scene with this many layers of 256 rocks.
pub fn build_sized(layers: usize) -> Scene {
    let mut world = world_with_floor(100.0);
    let mut dice = Dice::new(5);
    let kinds: Vec<ColliderBuilder> = (0..KINDS)
        .filter_map(|_| ColliderBuilder::convex_hull(&rock(&mut dice, 0.6, 12)))
        .map(|hull| hull.friction(0.6))
        .collect();
    for layer in 0..layers {
        for row in 0..SIDE {
            for column in 0..SIDE {
                let center = (SIDE - 1) as Real / 2.0;
                let mut wobble = || dice.between(-0.15, 0.15);
                let place = Vector::new(
                    1.35 * (column as Real - center) + wobble(),
                    0.8 + 1.35 * layer as Real,
                    1.35 * (row as Real - center) + wobble(),
                );
                let kind = dice.below(kinds.len());
                add(&mut world, place, kinds[kind].clone());
            }
        }
    }
    Scene::new(world, View::orbit(30.0, 24.0))
}
