//! Bodies of several parts in a heap.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add_walls, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "compounds",
    description: "3,000 bodies of two or three parts fall onto a heap.",
    category: Category::Basics,
    steps: 240,
    law: Law { overlap_max: 0.5, height_min: 0.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Bodies in a row.
const COLUMNS: usize = 60;

/// Builds the scene.
pub fn build() -> Scene {
    build_sized(3000)
}

/// Builds the scene with this many bodies.
pub fn build_sized(count: usize) -> Scene {
    let mut world = world_with_floor(200.0);
    add_walls(&mut world, 60.0, 30.0);
    for i in 0..count {
        let [column, row] = [i % COLUMNS, i / COLUMNS].map(|n| n as Real);
        let shift = if (i / COLUMNS).is_multiple_of(2) { 0.0 } else { 0.7 };
        let x = 1.8 * (column - (COLUMNS - 1) as Real / 2.0) + shift;
        let body = RigidBodyBuilder::dynamic().translation(Vector::new(x, 1.0 + 1.7 * row));
        add_compound(&mut world, body, i % 3);
    }
    Scene::new(world, View::flat())
}

/// Adds a table, a hook or a cross.
fn add_compound(world: &mut PhysicsWorld, body: RigidBodyBuilder, kind: usize) {
    let part = |half: (Real, Real), place: (Real, Real)| {
        ColliderBuilder::cuboid(half.0, half.1).translation(Vector::new(place.0, place.1))
    };
    let parts = match kind {
        0 => vec![
            part((0.7, 0.12), (0.0, 0.3)),
            part((0.12, 0.4), (-0.58, -0.2)),
            part((0.12, 0.4), (0.58, -0.2)),
        ],
        1 => vec![part((0.6, 0.15), (0.0, -0.3)), part((0.15, 0.5), (-0.45, 0.2))],
        _ => vec![part((0.65, 0.15), (0.0, 0.0)), part((0.15, 0.65), (0.0, 0.0))],
    };
    let handle = world.insert_body(body);
    for part in parts {
        world.insert_collider(part.friction(0.6), Some(handle));
    }
}
