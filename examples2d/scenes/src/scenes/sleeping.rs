//! Sleeping islands take no time until a contact wakes them.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add_pyramid, square, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "sleeping",
    description: "Five pyramids fall asleep (darker); balls wake the ones they hit and no others.",
    category: Category::Basics,
    steps: 280,
    law: Law { overlap_max: 0.01, height_min: 0.0, reach_max: 36.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Step of the shot. The pyramids sleep long before.
const SHOT: usize = 240;

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(80.0);
    let places: Vec<Vector> = (0..5).map(|i| Vector::X * (13.0 * (i as Real - 2.0))).collect();
    for &place in &places {
        add_pyramid(&mut world, place, 10, &square(0.5), 0.5);
    }
    Scene::new(world, View::flat()).script(move |world, step| {
        if step == SHOT {
            for place in [places[1], places[3]] {
                let ball = RigidBodyBuilder::dynamic()
                    .translation(place + Vector::new(-2.0, 16.0))
                    .linvel(Vector::new(2.0, -18.0));
                world.insert(ball, ColliderBuilder::ball(0.9).density(4.0));
            }
        }
    })
}
