//! Dominance groups: bodies of lower groups do not affect bodies of higher ones, whatever their mass.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add, add_fixed, square};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "dominance",
    description: "Balls shot at walls: the one with a higher dominance group passes through as if the wall had no mass.",
    category: Category::Basics,
    steps: 75,
    // Bodies still land: these overlap by up to a quarter of their size.
    law: Law { overlap_max: 0.25, height_min: -6.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = PhysicsWorld::new();
    add_fixed(&mut world, -Vector::Y * 7.0, ColliderBuilder::cuboid(200.0, 1.0));
    for (lane, dominance) in [-1, 0, 1].into_iter().enumerate() {
        let floor = 9.0 * lane as Real;
        add_fixed(&mut world, Vector::new(4.0, floor - 0.2), ColliderBuilder::cuboid(18.0, 0.2));
        for i in 0..24 {
            let place = Vector::new((i % 3) as Real, floor + 0.5 + (i / 3) as Real);
            add(&mut world, place, square(0.5));
        }
        let ball = RigidBodyBuilder::dynamic()
            .translation(Vector::new(-10.0, floor + 2.5))
            .linvel(Vector::new(14.0, 2.0))
            .dominance_group(dominance);
        world.insert(ball, ColliderBuilder::ball(0.8));
    }
    Scene::new(world, View::flat()).focusing(Vector::new(-12.0, 0.0), Vector::new(20.0, 26.0))
}
