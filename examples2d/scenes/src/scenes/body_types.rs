//! Bodies that change their type while the world runs.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add, square, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "body_types",
    description: "Planks become kinematic, fixed and dynamic in turn, under heaps of balls and boxes.",
    category: Category::Basics,
    steps: 300,
    // Bodies still land: these overlap by up to a quarter of their size.
    law: Law { overlap_max: 0.2, height_min: 0.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(200.0);
    let planks: Vec<RigidBodyHandle> = (0..3)
        .map(|i| {
            let place = Vector::new(7.0 * (i as Real - 1.0), 3.0);
            let (plank, _) = world.insert(
                RigidBodyBuilder::fixed().translation(place),
                ColliderBuilder::cuboid(2.8, 0.15),
            );
            for k in 0..16 {
                let shape = if k % 2 == 0 { ColliderBuilder::ball(0.4) } else { square(0.35) };
                let offset = Vector::new(1.1 * ((k % 4) as Real - 1.5), 0.8 + (k / 4) as Real);
                add(&mut world, place + offset, shape);
            }
            plank
        })
        .collect();
    Scene::new(world, View::flat()).script(move |world, step| {
        for (i, &plank) in planks.iter().enumerate() {
            let Some(plank) = world.bodies.get_mut(plank) else { continue };
            match step.checked_sub(60 + 40 * i) {
                Some(0) => {
                    plank.set_body_type(RigidBodyType::KinematicVelocityBased, true);
                    plank.set_angvel(0.4, true);
                    plank.set_linvel(Vector::Y * 0.8, true);
                }
                Some(50) => plank.set_body_type(RigidBodyType::Fixed, true),
                Some(90) => plank.set_body_type(RigidBodyType::Dynamic, true),
                _ => {}
            }
        }
    })
}
