//! Stones of random shape.

use crate::common::{Dice, Law, Scene, SceneInfo};
use crate::kit::{add, add_walls, stone, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "convex_polygons",
    description: "Stones of 3 to 8 corners and all sizes fall into a box.",
    category: Category::Shapes,
    steps: 300,
    law: Law { overlap_max: 0.05, height_min: 0.0, reach_max: 9.0, speed_max: 0.1, ..Law::NONE },
    source: file!(),
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(50.0);
    add_walls(&mut world, 8.0, 8.0);
    let mut dice = Dice::new(7);
    for layer in 0..14 {
        for column in 0..9 {
            let corners = 3 + dice.below(6);
            let radius = dice.between(0.4, 0.8);
            let place = Vector::new(1.7 * (column as Real - 4.0), 1.0 + 1.7 * layer as Real);
            let stone = stone(&mut dice, radius, corners);
            let hull =
                ColliderBuilder::convex_hull(&stone).expect("corners on a circle have a hull");
            add(&mut world, place, hull);
        }
    }
    Scene::new(world, View::flat())
}
