//! A rotating drum: all bodies move all the time.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{HALF_TURN, add, cube};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "washer",
    description: "A drum with paddles rotates and tumbles 2,000 boxes and balls.",
    category: Category::Stress,
    steps: 300,
    law: Law { overlap_max: 0.2, height_min: -9.0, reach_max: 11.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Boards around the drum.
const BOARDS: usize = 24;
/// Radius of the drum, and half its length.
const RADIUS: Real = 9.0;
const HALF_LENGTH: Real = 4.0;

/// Builds the scene.
pub fn build() -> Scene {
    build_sized(2000)
}

/// Builds the scene with this many bodies in the drum.
pub fn build_sized(count: usize) -> Scene {
    let mut world = PhysicsWorld::new();
    add_drum(&mut world);
    for (i, place) in places().take(count).enumerate() {
        let shape = if i % 4 == 0 { ColliderBuilder::ball(0.33) } else { cube(0.3) };
        add(&mut world, place, shape);
    }
    Scene::new(world, View::orbit(25.0, 12.0))
}

/// Returns positions in the drum, from the bottom up, away from its boards and paddles.
fn places() -> impl Iterator<Item = Vector> {
    let cell = 0.72;
    let inside = |place: &Vector| place.truncate().length() < RADIUS - 1.8;
    (-12..=12)
        .flat_map(|y| (-5..=5).flat_map(move |z| (-12..=12).map(move |x| [x, y, z])))
        .map(move |grid| Vector::from_array(grid.map(|n| cell * n as Real)))
        .filter(inside)
}

/// Adds a kinematic body of boards in a circle, some of them with a paddle. The lids are half-spaces, which
/// are drawn from outside only, so the near one is invisible.
fn add_drum(world: &mut PhysicsWorld) {
    let body = RigidBodyBuilder::kinematic_velocity_based().angvel(Vector::Z * 0.6);
    let drum = world.insert_body(body);
    let half_width = RADIUS * (HALF_TURN / BOARDS as Real).tan();
    for i in 0..BOARDS {
        let angle = 2.0 * HALF_TURN * i as Real / BOARDS as Real;
        let outward = Vector::new(angle.cos(), angle.sin(), 0.0);
        let board = ColliderBuilder::cuboid(0.25, half_width + 0.1, HALF_LENGTH)
            .translation(outward * (RADIUS + 0.25))
            .rotation(Vector::Z * angle);
        world.insert_collider(board, Some(drum));
        if i % 6 == 0 {
            let paddle = ColliderBuilder::cuboid(0.7, 0.15, HALF_LENGTH)
                .translation(outward * (RADIUS - 0.6))
                .rotation(Vector::Z * angle);
            world.insert_collider(paddle, Some(drum));
        }
    }
    for normal in [Vector::Z, -Vector::Z] {
        let lid = ColliderBuilder::halfspace(normal).translation(normal * -HALF_LENGTH);
        world.insert_collider(lid, None);
    }
}
