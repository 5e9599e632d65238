//! Bodies of several parts: several colliders, or one compound shape.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{HALF_TURN, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "compound",
    description: "Tables with four legs, each a separate collider, and jacks of one compound shape.",
    category: Category::Basics,
    steps: 450,
    law: Law { overlap_max: 0.01, height_min: 0.0, reach_max: 10.0, speed_max: 0.1, ..Law::NONE },
    source: file!(),
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(50.0);
    for layer in 0..6 {
        for row in 0..3 {
            for column in 0..3 {
                let [x, z] = [column, row].map(|i| 2.8 * (i as Real - 1.0));
                let place = Vector::new(x, 1.5 + 2.4 * layer as Real, z);
                let turn = Vector::new(0.3, layer as Real, 0.2 * column as Real);
                let body = RigidBodyBuilder::dynamic().translation(place).rotation(turn);
                if (layer + row + column) % 2 == 0 {
                    add_table(&mut world, body);
                } else {
                    world.insert(body, jack());
                }
            }
        }
    }
    Scene::new(world, View::orbit(35.0, 24.0))
}

/// Adds a table: a top and four legs, each a collider.
fn add_table(world: &mut PhysicsWorld, body: RigidBodyBuilder) {
    let (table, _) = world.insert(body, ColliderBuilder::cuboid(0.9, 0.08, 0.7));
    for (x, z) in [(-0.75, -0.55), (0.75, -0.55), (0.75, 0.55), (-0.75, 0.55)] {
        let leg = ColliderBuilder::cuboid(0.08, 0.5, 0.08).translation(Vector::new(x, -0.55, z));
        world.insert_collider(leg, Some(table));
    }
}

/// Returns three crossed capsules as one shape.
fn jack() -> ColliderBuilder {
    let arm = SharedShape::capsule_y(0.7, 0.17);
    let poses = [
        Pose::IDENTITY,
        Pose::rotation(Vector::X * (0.5 * HALF_TURN)),
        Pose::rotation(Vector::Z * (0.5 * HALF_TURN)),
    ];
    ColliderBuilder::compound(poses.map(|pose| (pose, arm.clone())).to_vec())
}
