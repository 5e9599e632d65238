//! One-way platforms: bodies pass them from below and land on them from above.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add_fixed, cube, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "one_way_platforms",
    description: "Boxes shot upwards pass three platforms from below and land on them from above.",
    category: Category::Events,
    steps: 260,
    law: Law { overlap_max: 0.01, height_min: 0.0, reach_max: 5.0, speed_max: 0.1, ..Law::NONE },
    source: file!(),
    build,
};

/// Largest angle between the contact normal and the vertical for a contact to act (rad).
const ALLOWED_ANGLE: Real = 0.1;

/// Hook that keeps contacts of platforms from above only.
struct OneWay {
    platforms: Vec<ColliderHandle>,
}

impl PhysicsHooks for OneWay {
    fn modify_solver_contact(&self, context: &mut ContactModificationContext) {
        // The normal points from the first collider to the second: up, if the platform is the first.
        let up = if self.platforms.contains(&context.collider1) {
            Vector::Y
        } else {
            let rotation = context.colliders[context.collider1].position().rotation;
            rotation.inverse() * -Vector::Y
        };
        context.update_as_oneway_platform(up, ALLOWED_ANGLE);
    }
}

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(50.0);
    let platforms: Vec<ColliderHandle> = (1..=3)
        .map(|i| {
            let shape = ColliderBuilder::cuboid(4.0, 0.1, 1.5)
                .active_hooks(ActiveHooks::MODIFY_SOLVER_CONTACTS);
            let body = add_fixed(&mut world, Vector::Y * (2.5 * i as Real), shape);
            world.bodies[body].colliders()[0]
        })
        .collect();
    for i in 0..12 {
        let body = RigidBodyBuilder::dynamic()
            .translation(Vector::new(0.65 * (i as Real - 5.5), 0.5, 0.0))
            .linvel(Vector::Y * (4.0 + 0.9 * i as Real))
            .lock_rotations();
        world.insert(body, cube(0.25));
    }
    Scene::new(world, View::orbit(18.0, 10.0)).hooks(OneWay { platforms })
}
