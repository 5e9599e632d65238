//! Damping of linear and angular velocities.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::square;
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
        let y = 1.8 * row as Real;
        let flung = RigidBodyBuilder::dynamic()
            .translation(Vector::new(0.0, y))
            .linvel(Vector::X * 8.0)
            .linear_damping(damping);
        world.insert(flung, square(0.4));
        let spun = RigidBodyBuilder::dynamic()
            .translation(Vector::new(-2.5, y))
            .angvel(1.2)
            .angular_damping(damping);
        world.insert(spun, ColliderBuilder::cuboid(0.8, 0.1));
    }
    Scene::new(world, View::flat())
}
