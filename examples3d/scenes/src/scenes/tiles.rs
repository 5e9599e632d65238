//! A floor of ten thousand boxes.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add, cube};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "tiles",
    description: "Boxes and balls slide over a floor of 100 × 100 tiles, each a separate body.",
    category: Category::Stress,
    steps: 300,
    law: Law { overlap_max: 0.01, ..Law::NONE },
    source: file!(),
    build,
};

/// Tiles along each side.
const TILES: i32 = 100;

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = PhysicsWorld::new();
    let middle = 0.5 * (TILES - 1) as Real;
    for i in 0..TILES {
        for j in 0..TILES {
            let place = Vector::new(i as Real - middle, -0.5, j as Real - middle);
            let tile = cube(0.5).friction(0.1);
            world.insert(RigidBodyBuilder::fixed().translation(place), tile);
        }
    }
    for i in 0..1_000 {
        let [x, z] = [i % 32, i / 32].map(|n| 2.5 * (n as Real - 16.0));
        let shape = if i % 3 == 0 { ColliderBuilder::ball(0.4) } else { cube(0.4) };
        let body = add(&mut world, Vector::new(x, 0.4, z), shape.friction(0.1));
        // Velocities are tangential to a circle, so that bodies meet.
        let velocity = Vector::new(-z, 0.0, x).normalize_or_zero() * 6.0;
        world.bodies[body].set_linvel(velocity, true);
    }
    Scene::new(world, View::orbit(35.0, 75.0))
        .focusing(Vector::new(-30.0, 0.0, -24.0), Vector::new(30.0, 2.0, 30.0))
}
