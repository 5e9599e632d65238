//! Bodies are inserted and removed in every step.

use crate::common::{Dice, Law, Scene, SceneInfo};
use crate::kit::{square, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};
use std::collections::VecDeque;

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "rain",
    description: "Two bodies are added every step and the oldest removed: 500 stay.",
    category: Category::Basics,
    steps: 400,
    law: Law { overlap_max: 0.2, height_min: 0.0, reach_max: 31.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Largest number of bodies.
const CROWD: usize = 500;

/// Builds the scene.
pub fn build() -> Scene {
    let world = world_with_floor(80.0);
    let mut dice = Dice::new(11);
    let mut crowd = VecDeque::new();
    Scene::new(world, View::flat()).script(move |world, step| {
        for i in [2 * step, 2 * step + 1] {
            // A column is reused after its last body has fallen out of it.
            let column = (7 * i) % 15;
            let x = 1.3 * (column as Real - 7.0) + dice.between(-0.2, 0.2);
            let place = Vector::new(x, 12.0);
            let shape = match dice.below(3) {
                0 => ColliderBuilder::ball(0.35),
                1 => square(0.3),
                _ => ColliderBuilder::capsule_y(0.25, 0.25),
            };
            let drop = RigidBodyBuilder::dynamic().translation(place).linvel(Vector::Y * -9.0);
            crowd.push_back(world.insert(drop, shape).0);
        }
        while crowd.len() > CROWD {
            if let Some(oldest) = crowd.pop_front() {
                world.remove_body(oldest);
            }
        }
    })
}
