//! Rocks of random shape.

use crate::common::{Dice, Law, Scene, SceneInfo};
use crate::kit::{add, add_walls, rock, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "convex_hulls",
    description: "Rocks of 5 to 16 corners and all sizes fall into a box.",
    category: Category::Shapes,
    steps: 360,
    law: Law { overlap_max: 0.02, height_min: -1.0, reach_max: 15.0, speed_max: 0.1, ..Law::NONE },
    source: file!(),
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(50.0);
    add_walls(&mut world, 4.5, 2.0);
    let mut dice = Dice::new(7);
    for layer in 0..8 {
        for row in 0..5 {
            for column in 0..5 {
                let corners = 5 + dice.below(12);
                let radius = dice.between(0.45, 0.85);
                let [x, z] = [column, row].map(|i| 1.7 * (i as Real - 2.0));
                let place = Vector::new(x, 1.0 + 1.8 * layer as Real, z);
                // Coplanar points have no hull; the loop repeats until one exists.
                let hull = (0..)
                    .find_map(|_| ColliderBuilder::convex_hull(&rock(&mut dice, radius, corners)));
                add(&mut world, place, hull.expect("the search does not end without one"));
            }
        }
    }
    Scene::new(world, View::orbit(30.0, 28.0))
}
