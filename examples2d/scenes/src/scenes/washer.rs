//! A rotating drum with paddles: all bodies move all the time.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{HALF_TURN, add, directions, ring, square};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "washer",
    description: "A drum with paddles rotates and tumbles 8,000 boxes and balls.",
    category: Category::Stress,
    steps: 300,
    law: Law { overlap_max: 0.25, height_min: -33.0, reach_max: 36.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Number of boards around the drum, and of paddles on them.
const BOARDS: usize = 48;
const PADDLES: usize = 6;
/// Initial distance of neighbours, and half the size of a box.
const CELL: Real = 0.5;
const HALF: Real = 0.2;

/// Builds the scene.
pub fn build() -> Scene {
    build_sized(8000)
}

/// Builds the scene with this many bodies, which fill two thirds of the drum at rest.
pub fn build_sized(count: usize) -> Scene {
    let mut world = PhysicsWorld::new();
    let radius = 1.2 * CELL * (count as Real / HALF_TURN).sqrt() + 2.0;
    add_drum(&mut world, radius);
    let reach = (radius / CELL) as i32;
    let grid = (-reach..=reach).flat_map(|y| (-reach..=reach).map(move |x| [x, y]));
    let places = grid.map(|place| Vector::from_array(place.map(|n| CELL * n as Real)));
    let inside = |place: &Vector| place.length() < radius - 2.0;
    for (i, place) in places.filter(inside).take(count).enumerate() {
        let shape = if i % 4 == 0 { ColliderBuilder::ball(HALF) } else { square(HALF) };
        add(&mut world, place, shape);
    }
    Scene::new(world, View::flat())
}

/// Adds a kinematic body of boards in a circle, and of paddles.
fn add_drum(world: &mut PhysicsWorld, radius: Real) {
    let drum = world.insert_body(RigidBodyBuilder::kinematic_velocity_based().angvel(0.4));
    for board in ring(radius, BOARDS, 0.5) {
        world.insert_collider(board, Some(drum));
    }
    for (angle, outward) in directions(PADDLES) {
        let paddle =
            ColliderBuilder::cuboid(1.5, 0.2).translation(outward * (radius - 1.5)).rotation(angle);
        world.insert_collider(paddle, Some(drum));
    }
}
