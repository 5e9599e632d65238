//! Bodies on a terrain of voxels that is dug up while the world runs.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add, square};
use crate::rapier::parry::math::IVector;
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "voxels",
    description: "A crater is dug into voxels, step by step, and the bodies on them follow.",
    category: Category::Shapes,
    steps: 300,
    law: Law { overlap_max: 0.01, height_min: 0.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Number of voxels from the middle to the edge.
const REACH: Int = 24;
/// Size of a voxel.
const SIZE: Real = 0.5;

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = PhysicsWorld::new();
    let mut keys = Vec::new();
    for x in -REACH..=REACH {
        keys.extend((0..top(x)).map(|y| IVector::new(x, y)));
    }
    let terrain = ColliderBuilder::voxels(Vector::splat(SIZE), &keys);
    let (_, terrain) = world.insert(RigidBodyBuilder::fixed(), terrain);
    for i in 0..80 {
        let place = Vector::new(0.95 * ((i % 16) as Real - 7.5), 9.0 + 0.9 * (i / 16) as Real);
        let shape = if i % 2 == 0 { ColliderBuilder::ball(0.35) } else { square(0.3) };
        add(&mut world, place, shape);
    }
    Scene::new(world, View::flat())
        .focusing(Vector::new(-12.0, 0.0), Vector::new(12.0, 10.0))
        .script(move |world, step| {
            if step >= 120 && step % 6 == 0 {
                dig(world, terrain, (step - 120) / 6);
            }
        })
}

/// Returns the height of the terrain in voxels: a plain between two hills.
fn top(x: Int) -> Int {
    10 + x * x / 60
}

/// Removes the voxels of a disc that grows with each call.
fn dig(world: &mut PhysicsWorld, terrain: ColliderHandle, time: usize) {
    let radius = (1 + time / 2).min(9) as Int;
    let Some(collider) = world.colliders.get_mut(terrain) else { return };
    let Some(voxels) = collider.shape_mut().as_voxels_mut() else { return };
    for x in -radius..=radius {
        for y in -radius..=radius {
            // One layer remains at the bottom.
            if x * x + y * y <= radius * radius && y + 10 >= 1 {
                voxels.set_voxel(IVector::new(x, y + 10), false);
            }
        }
    }
}
