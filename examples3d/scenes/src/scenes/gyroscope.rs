//! Free rotation: a T-handle flips about its intermediate axis.

use crate::common::{Law, Scene, SceneInfo};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "gyroscope",
    description: "Weightless T-handles spin about each of their three axes; the middle one keeps flipping.",
    category: Category::Basics,
    steps: 400,
    law: Law { overlap_max: 0.01, height_min: -1.0, reach_max: 5.0, speed_max: 0.1, ..Law::NONE },
    source: file!(),
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = PhysicsWorld::new();
    world.gravity = Vector::ZERO;
    // A small rotation about the other axes. Without it even the unstable rotation would persist for long.
    let spins =
        [Vector::new(8.0, 0.05, 0.05), Vector::new(0.05, 8.0, 0.05), Vector::new(0.05, 0.05, 8.0)];
    for (i, spin) in spins.into_iter().enumerate() {
        let body = RigidBodyBuilder::dynamic()
            .translation(Vector::X * (4.0 * (i as Real - 1.0)))
            .angvel(spin)
            .gyroscopic_forces_enabled(true)
            .can_sleep(false);
        let (handle, _) = world.insert(body, ColliderBuilder::cuboid(1.2, 0.2, 0.2));
        let stem = ColliderBuilder::cuboid(0.15, 0.5, 0.15).translation(Vector::Y * -0.7);
        world.insert_collider(stem, Some(handle));
    }
    Scene::new(world, View::orbit(15.0, 20.0))
}
