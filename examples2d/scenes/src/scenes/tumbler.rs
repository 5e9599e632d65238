//! A rotating box: all bodies move all the time.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{HALF_TURN, add, square};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "tumbler",
    description: "A rotating box tumbles 2,025 small ones.",
    category: Category::Stress,
    steps: 400,
    law: Law { overlap_max: 0.1, height_min: -14.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    build_sized(45)
}

/// Builds the scene with a square of boxes in the rotating box, this many along each side.
pub fn build_sized(side: usize) -> Scene {
    let mut world = PhysicsWorld::new();
    // 25 degrees per second.
    let speed = 25.0 / 180.0 * HALF_TURN;
    let body = RigidBodyBuilder::kinematic_velocity_based().angvel(speed);
    let drum = world.insert_body(body);
    let reach = 0.222 * side as Real;
    for (center, half) in [
        (Vector::X * reach, Vector::new(0.5, reach)),
        (Vector::X * -reach, Vector::new(0.5, reach)),
        (Vector::Y * reach, Vector::new(reach, 0.5)),
        (Vector::Y * -reach, Vector::new(reach, 0.5)),
    ] {
        let wall = ColliderBuilder::cuboid(half.x, half.y).translation(center).friction(0.6);
        world.insert_collider(wall, Some(drum));
    }
    let shape = square(0.125).friction(0.6);
    for row in 0..side {
        for column in 0..side {
            let center = (side - 1) as Real / 2.0;
            let [x, y] = [column, row].map(|n| 0.35 * (n as Real - center));
            add(&mut world, Vector::new(x, y), shape.clone());
        }
    }
    Scene::new(world, View::flat())
}
