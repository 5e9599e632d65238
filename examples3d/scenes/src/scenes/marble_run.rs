//! Balls roll down alternating ramps.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add, add_fixed, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "marble_run",
    description: "Three dozen marbles roll down six ramps with rims, from one to the next, down to the floor.",
    category: Category::Shapes,
    steps: 300,
    law: Law { overlap_max: 0.01, height_min: 0.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Number of ramps, half their length, and their slope.
const RAMPS: usize = 6;
const HALF: Real = 4.0;
const SLOPE: Real = 0.16;

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(40.0);
    for i in 0..RAMPS {
        let side = if i % 2 == 0 { 1.0 } else { -1.0 };
        let middle = Vector::new(0.9 * side, 10.5 - 1.7 * i as Real, 0.0);
        add_ramp(&mut world, middle, -side * SLOPE);
        // A board beyond the lower end deflects the marbles to the next ramp.
        let stop = Vector::new(middle.x + side * (HALF + 1.0), middle.y - 0.6, 0.0);
        add_fixed(&mut world, stop, ColliderBuilder::cuboid(0.1, 1.0, 0.8));
    }
    for i in 0..36 {
        let [row, column] = [i / 2, i % 2].map(|n| n as Real);
        let place = Vector::new(
            -3.0 + 0.66 * (row % 9.0),
            12.6 + 0.7 * (row / 9.0).floor(),
            0.64 * (column - 0.5),
        );
        add(&mut world, place, ColliderBuilder::ball(0.3).restitution(0.2));
    }
    Scene::new(world, View::orbit(14.0, 8.0))
        .focusing(Vector::new(-4.8, 3.0, -0.8), Vector::new(4.8, 12.5, 0.8))
}

/// Adds a board between two rims, tilted about the axis towards the eye.
fn add_ramp(world: &mut PhysicsWorld, middle: Vector, tilt: Real) {
    let body = RigidBodyBuilder::fixed().translation(middle).rotation(Vector::Z * tilt);
    let (body, _) = world.insert(body, ColliderBuilder::cuboid(HALF, 0.08, 0.8));
    for z in [-0.8, 0.8] {
        let rim = ColliderBuilder::cuboid(HALF, 0.13, 0.05).translation(Vector::new(0.0, 0.13, z));
        world.insert_collider(rim, Some(body));
    }
}
