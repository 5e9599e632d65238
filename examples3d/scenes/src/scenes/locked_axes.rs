//! Bodies with locked translations and rotations.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add, cube, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "locked_axes",
    description: "A turnstile that only spins, a slider that only slides, pillars that cannot fall, under a rain of boxes.",
    category: Category::Basics,
    steps: 300,
    law: Law { overlap_max: 0.01, height_min: 0.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(50.0);

    let turnstile = RigidBodyBuilder::dynamic()
        .translation(Vector::new(-4.5, 2.0, 0.0))
        .lock_translations()
        .enabled_rotations(false, false, true)
        .can_sleep(false);
    world.insert(turnstile, ColliderBuilder::cuboid(2.5, 0.15, 1.0));

    let slider = RigidBodyBuilder::dynamic()
        .translation(Vector::new(1.0, 2.0, 0.0))
        .linvel(Vector::Z * 2.0)
        .lock_rotations()
        .enabled_translations(false, false, true);
    world.insert(slider, ColliderBuilder::cuboid(1.5, 0.15, 1.0));

    for i in 0..3 {
        let pillar = RigidBodyBuilder::dynamic()
            .translation(Vector::new(4.5 + 1.2 * i as Real, 1.5, 0.0))
            .locked_axes(LockedAxes::ROTATION_LOCKED);
        world.insert(pillar, ColliderBuilder::cuboid(0.15, 1.5, 0.6));
    }

    for i in 0..60 {
        let x = -6.0 + 1.35 * (i % 10) as Real;
        let y = 6.0 + 1.5 * (i / 10) as Real;
        let z = if i % 3 == 0 { 0.35 } else { -0.1 };
        add(&mut world, Vector::new(x, y, z), cube(0.3));
    }
    Scene::new(world, View::orbit(18.0, 18.0))
}
