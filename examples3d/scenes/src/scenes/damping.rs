//! Damping of linear and angular velocities.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::cube;
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "damping",
    description: "Weightless boxes, flung and spun alike, with a damping that grows from bottom to top.",
    category: Category::Basics,
    steps: 120,
    law: Law { overlap_max: 0.01, height_min: 0.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = PhysicsWorld::new();
    world.gravity = Vector::ZERO;
    for row in 0..8 {
        let damping = 0.4 * row as Real;
        let y = 1.6 * row as Real;
        let flung = RigidBodyBuilder::dynamic()
            .translation(Vector::new(0.0, y, 0.0))
            .linvel(Vector::X * 8.0)
            .linear_damping(damping);
        world.insert(flung, cube(0.4));
        let spun = RigidBodyBuilder::dynamic()
            .translation(Vector::new(-2.5, y, 0.0))
            .angvel(Vector::new(0.0, 6.0, 0.5))
            .angular_damping(damping);
        world.insert(spun, ColliderBuilder::cuboid(0.8, 0.3, 0.4));
    }
    Scene::new(world, View::orbit(8.0, 12.0))
}
