//! Many small pyramids: many islands that could fall asleep independently.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add_pyramid, square};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "many_pyramids",
    description: "400 pyramids of 55 boxes each on 20 shelves: 22,000 boxes.",
    category: Category::Stress,
    steps: 150,
    law: Law {
        overlap_max: 0.01,
        height_min: 0.0,
        top_loss_max: 0.1,
        reach_max: 121.0,
        speed_max: 0.1,
        ..Law::NONE
    },
    source: file!(),
    build,
};

/// Boxes at the base of each pyramid.
const BASE: usize = 10;

/// Builds the scene.
pub fn build() -> Scene {
    build_sized(20)
}

/// Builds the scene with this many shelves, and as many pyramids on each. All shelves are colliders of one
/// body.
pub fn build_sized(shelves: usize) -> Scene {
    let half = 0.5;
    let spacing = 2.0 * half * (BASE + 1) as Real;
    let storey = 2.0 * half * (BASE + 2) as Real;
    let length = 0.5 * spacing * shelves as Real + half;
    let mut world = PhysicsWorld::new();
    let ground = world.insert_body(RigidBodyBuilder::fixed());
    let shape = square(half).friction(0.6);
    for row in 0..shelves {
        let y = storey * row as Real;
        let shelf = ColliderBuilder::cuboid(length, 0.25).translation(Vector::Y * (y - 0.25));
        world.insert_collider(shelf, Some(ground));
        for column in 0..shelves {
            let x = spacing * (column as Real - (shelves - 1) as Real / 2.0);
            add_pyramid(&mut world, Vector::new(x, y), BASE, &shape, half);
        }
    }
    Scene::new(world, View::flat())
}
