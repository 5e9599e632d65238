//! Bodies of several parts: several colliders, or one compound shape.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::world_with_floor;
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "compound",
    description: "Tables with each leg a separate collider, and crosses of one compound shape.",
    category: Category::Basics,
    steps: 300,
    law: Law { overlap_max: 0.02, height_min: 0.0, reach_max: 30.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(50.0);
    for layer in 0..8 {
        for column in 0..7 {
            let place = Vector::new(2.4 * (column as Real - 3.0), 1.5 + 2.2 * layer as Real);
            let turn = 0.4 * (layer * 3 + column) as Real;
            let body = RigidBodyBuilder::dynamic().translation(place).rotation(turn);
            if (layer + column) % 2 == 0 {
                add_table(&mut world, body);
            } else {
                world.insert(body, cross());
            }
        }
    }
    Scene::new(world, View::flat())
}

/// Adds a table: a top and two legs, each a collider.
fn add_table(world: &mut PhysicsWorld, body: RigidBodyBuilder) {
    let (table, _) = world.insert(body, ColliderBuilder::cuboid(0.9, 0.1));
    for x in [-0.75, 0.75] {
        let leg = ColliderBuilder::cuboid(0.1, 0.5).translation(Vector::new(x, -0.5));
        world.insert_collider(leg, Some(table));
    }
}

/// Returns two crossed capsules as one shape.
fn cross() -> ColliderBuilder {
    let arms = [Vector::X, Vector::Y]
        .map(|axis| (Pose::IDENTITY, SharedShape::capsule(axis * -0.7, axis * 0.7, 0.17)));
    ColliderBuilder::compound(arms.to_vec())
}
