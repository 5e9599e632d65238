//! Bodies are inserted and removed in every step.

use crate::common::{Dice, Law, Scene, SceneInfo};
use crate::kit::{cube, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};
use std::collections::VecDeque;

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "rain",
    description: "Two bodies are added every step and the oldest removed: 400 stay.",
    category: Category::Basics,
    steps: 400,
    law: Law { overlap_max: 0.2, height_min: 0.0, reach_max: 12.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Largest number of bodies.
const CROWD: usize = 400;

/// Builds the scene.
pub fn build() -> Scene {
    let world = world_with_floor(50.0);
    let mut dice = Dice::new(11);
    let mut crowd = VecDeque::new();
    Scene::new(world, View::orbit(30.0, 20.0)).script(move |world, step| {
        for i in [2 * step, 2 * step + 1] {
            // A cell is reused after its last body has fallen out of it.
            let cell = (7 * i) % 25;
            let mut across = |n: usize| 1.3 * (n as Real - 2.0) + dice.between(-0.2, 0.2);
            let place = Vector::new(across(cell % 5), 9.0, across(cell / 5));
            let shape = match dice.below(3) {
                0 => ColliderBuilder::ball(0.35),
                1 => cube(0.3),
                _ => ColliderBuilder::capsule_y(0.25, 0.25),
            };
            let drop = RigidBodyBuilder::dynamic().translation(place).linvel(Vector::Y * -6.0);
            crowd.push_back(world.insert(drop, shape).0);
        }
        while crowd.len() > CROWD {
            if let Some(oldest) = crowd.pop_front() {
                world.remove_body(oldest);
            }
        }
    })
}
