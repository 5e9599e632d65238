//! Bodies on a terrain of voxels that is dug up while the world runs.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add, cube};
use crate::rapier::parry::math::IVector;
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "voxels",
    description: "A crater is dug into voxels, step by step, and the balls on them follow.",
    category: Category::Shapes,
    steps: 300,
    law: Law { overlap_max: 0.01, height_min: 0.0, reach_max: 7.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Number of voxels from the middle to the edge.
const REACH: Int = 14;
/// Size of a voxel.
const SIZE: Real = 0.5;

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = PhysicsWorld::new();
    let mut keys = Vec::new();
    for x in -REACH..=REACH {
        for z in -REACH..=REACH {
            keys.extend((0..top(x, z)).map(|y| IVector::new(x, y, z)));
        }
    }
    let terrain = ColliderBuilder::voxels(Vector::splat(SIZE), &keys);
    let (_, terrain) = world.insert(RigidBodyBuilder::fixed(), terrain);
    for i in 0..49 {
        let [x, z] = [i % 7, i / 7].map(|n| 1.2 * (n as Real - 3.0));
        let shape = if i % 2 == 0 { ColliderBuilder::ball(0.4) } else { cube(0.33) };
        add(&mut world, Vector::new(x, 6.0, z), shape);
    }
    let view = View::orbit(30.0, 48.0);
    Scene::new(world, view)
        .focusing(Vector::new(-6.5, 0.0, -6.5), Vector::new(6.5, 4.0, 6.5))
        .script(move |world, step| {
            if step >= 90 && step % 6 == 0 {
                dig(world, terrain, (step - 90) / 6);
            }
        })
}

/// Returns the height of the terrain in voxels: hills around a plain, and a rim.
fn top(x: Int, z: Int) -> Int {
    let rim = x.abs().max(z.abs()) == REACH;
    let hill = (x * x + z * z) / 50;
    4 + hill + if rim { 2 } else { 0 }
}

/// Removes the voxels of a ball that grows with each call.
fn dig(world: &mut PhysicsWorld, terrain: ColliderHandle, time: usize) {
    let radius = (1 + time / 3).min(6) as Int;
    let Some(collider) = world.colliders.get_mut(terrain) else { return };
    let Some(voxels) = collider.shape_mut().as_voxels_mut() else { return };
    for x in -radius..=radius {
        for y in -radius..=radius {
            for z in -radius..=radius {
                // One layer remains at the bottom.
                if x * x + y * y + z * z <= radius * radius && y + 5 >= 1 {
                    voxels.set_voxel(IVector::new(x, y + 5, z), false);
                }
            }
        }
    }
}
