//! Bodies that change their type while the world runs.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add, cube, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "body_types",
    description: "A plank becomes kinematic, fixed and dynamic in turn, under a heap of balls.",
    category: Category::Basics,
    steps: 300,
    law: Law { overlap_max: 0.05, height_min: 0.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(50.0);
    let planks: Vec<RigidBodyHandle> = (0..3)
        .map(|i| {
            let place = Vector::new(5.0 * (i as Real - 1.0), 3.0, 0.0);
            let body = RigidBodyBuilder::fixed().translation(place);
            let (plank, _) = world.insert(body, ColliderBuilder::cuboid(2.0, 0.15, 2.0));
            for k in 0..18 {
                let [x, y, z] = [k % 3, k / 9, k / 3 % 3].map(|n| n as Real);
                let shape = if k % 2 == 0 { ColliderBuilder::ball(0.4) } else { cube(0.35) };
                add(&mut world, place + Vector::new(x - 1.0, 0.8 + y, z - 1.0), shape);
            }
            plank
        })
        .collect();
    Scene::new(world, View::orbit(22.0, 20.0)).script(move |world, step| {
        for (i, &plank) in planks.iter().enumerate() {
            let Some(plank) = world.bodies.get_mut(plank) else { continue };
            match step.checked_sub(60 + 40 * i) {
                Some(0) => {
                    plank.set_body_type(RigidBodyType::KinematicVelocityBased, true);
                    plank.set_angvel(Vector::Z * 0.5, true);
                    plank.set_linvel(Vector::Y * 0.8, true);
                }
                Some(50) => plank.set_body_type(RigidBodyType::Fixed, true),
                Some(90) => plank.set_body_type(RigidBodyType::Dynamic, true),
                _ => {}
            }
        }
    })
}
