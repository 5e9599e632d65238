//! Sleeping islands take no time until a contact wakes them.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add_pyramid, cube, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "sleeping",
    description: "Five pyramids fall asleep (darker); balls wake the ones they hit and no others.",
    category: Category::Basics,
    steps: 285,
    law: Law { overlap_max: 0.01, height_min: 0.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Step of the shot. The pyramids sleep long before.
const SHOT: usize = 240;

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(60.0);
    let places: Vec<Vector> = (0..5).map(|i| Vector::Z * (4.0 * (i as Real - 2.0))).collect();
    for &place in &places {
        add_pyramid(&mut world, place, 8, &cube(0.5), 0.5);
    }
    Scene::new(world, View::orbit(40.0, 25.0)).script(move |world, step| {
        if step == SHOT {
            for place in [places[1], places[3]] {
                let ball = RigidBodyBuilder::dynamic()
                    .translation(place + Vector::new(-9.0, 3.0, 0.0))
                    .linvel(Vector::X * 20.0);
                world.insert(ball, ColliderBuilder::ball(0.7).density(3.0));
            }
        }
    })
}
