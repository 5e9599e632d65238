//! Two thousand colliders on one body.

use crate::common::{Dice, Law, Scene, SceneInfo};
use crate::kit::{add, cube, rock};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "cobbles",
    description: "500 bodies fall on a street of 2,210 stones, convex colliders of one body.",
    category: Category::Stress,
    steps: 300,
    law: Law { overlap_max: 0.01, height_min: -1.0, reach_max: 22.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Number of stones along the street and across.
const STONES: [usize; 2] = [65, 34];
/// Distance of neighbouring stones.
const SPACING: Real = 0.6;

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = PhysicsWorld::new();
    let mut dice = Dice::new(11);
    let street = world.insert_body(RigidBodyBuilder::fixed());
    for i in 0..STONES[0] * STONES[1] {
        let [x, z] = [i % STONES[0], i / STONES[0]];
        let place = Vector::new(
            SPACING * (x as Real - 0.5 * STONES[0] as Real),
            -0.4,
            SPACING * (z as Real - 0.5 * STONES[1] as Real),
        );
        let stone = ColliderBuilder::convex_hull(&rock(&mut dice, 0.45, 20));
        let stone = stone.expect("twenty points on a sphere have a hull");
        world.insert_collider(stone.translation(place), Some(street));
    }
    for i in 0..500 {
        let [x, z] = [i % 25, i / 25].map(|n| n as Real);
        let place = Vector::new(1.4 * (x - 12.0), 1.0 + 0.2 * (i % 4) as Real, 0.9 * (z - 9.5));
        let shape = match i % 3 {
            0 => ColliderBuilder::ball(0.3),
            1 => cube(0.28),
            _ => ColliderBuilder::capsule_y(0.2, 0.2),
        };
        add(&mut world, place, shape);
    }
    Scene::new(world, View::orbit(25.0, 45.0))
        .focusing(Vector::new(-18.0, -0.5, -10.0), Vector::new(18.0, 2.0, 12.0))
}
