//! A blade in a round pit: fast contacts at its tips, a slow pile below.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add, ring, square};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "spinner",
    description: "A blade spins in a pit with 3,040 balls, boxes and capsules.",
    category: Category::Basics,
    steps: 300,
    law: Law { overlap_max: 1.0, height_min: -40.0, reach_max: 44.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Radius of the pit.
const PIT: Real = 40.0;
/// Pieces of the pit's rim.
const PIECES: usize = 120;

/// Builds the scene.
pub fn build() -> Scene {
    build_sized(3040)
}

/// Builds the scene with this many bodies.
pub fn build_sized(count: usize) -> Scene {
    let mut world = PhysicsWorld::new();
    add_rim(&mut world);
    let blade =
        RigidBodyBuilder::kinematic_velocity_based().translation(Vector::Y * -16.0).angvel(2.0);
    world.insert(blade, ColliderBuilder::round_cuboid(0.4, 20.0, 0.2).friction(0.0));

    let shapes =
        [ColliderBuilder::capsule_x(0.25, 0.25), ColliderBuilder::ball(0.35), square(0.35)]
            .map(|shape| shape.friction(0.1).restitution(0.1).density(0.25));
    let columns = 76;
    for i in 0..count {
        let [column, row] = [i % columns, i / columns].map(|n| n as Real);
        // Bodies alternate between the left and the right of the blade.
        let side = if i % 2 == 0 { -1.0 } else { 1.0 };
        let place = Vector::new(side * (1.6 + 0.38 * column), -20.0 + 0.9 * row);
        if place.length() < PIT - 1.0 {
            add(&mut world, place, shapes[i % 3].clone());
        }
    }
    Scene::new(world, View::flat())
}

/// Adds a fixed body of blocks in a circle, thick enough to contain fast bodies.
fn add_rim(world: &mut PhysicsWorld) {
    let rim = world.insert_body(RigidBodyBuilder::fixed());
    for block in ring(PIT, PIECES, 2.0) {
        world.insert_collider(block.friction(0.1), Some(rim));
    }
}
