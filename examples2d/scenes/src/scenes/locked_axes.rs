//! Bodies with locked translations and rotations.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add, square, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "locked_axes",
    description: "A turnstile that only spins, a slider that only slides, pillars that cannot fall, under a rain of boxes.",
    category: Category::Basics,
    steps: 300,
    law: Law { overlap_max: 0.01, height_min: 0.0, reach_max: 23.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(50.0);

    let turnstile = RigidBodyBuilder::dynamic()
        .translation(Vector::new(-5.0, 3.5))
        .lock_translations()
        .can_sleep(false);
    let (turnstile, _) = world.insert(turnstile, ColliderBuilder::cuboid(3.0, 0.12));
    world.insert_collider(ColliderBuilder::cuboid(0.12, 3.0), Some(turnstile));

    let slider = RigidBodyBuilder::dynamic()
        .translation(Vector::new(2.0, 2.0))
        .lock_rotations()
        .enabled_translations(true, false);
    world.insert(slider, ColliderBuilder::cuboid(1.5, 0.15));

    for i in 0..3 {
        let pillar = RigidBodyBuilder::dynamic()
            .translation(Vector::new(5.5 + 1.5 * i as Real, 1.5))
            .locked_axes(LockedAxes::ROTATION_LOCKED);
        world.insert(pillar, ColliderBuilder::cuboid(0.15, 1.5));
    }

    for i in 0..100 {
        let x = -7.5 + 0.85 * (i % 20) as Real + 0.3 * (i / 20 % 2) as Real;
        let y = 9.0 + 1.5 * (i / 20) as Real;
        add(&mut world, Vector::new(x, y), square(0.3));
    }
    Scene::new(world, View::flat())
}
