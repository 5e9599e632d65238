//! Bodies on a triangle mesh.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add, square};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "trimesh",
    description: "Balls and boxes roll along a winding channel made of triangles.",
    category: Category::Shapes,
    steps: 360,
    law: Law { overlap_max: 0.01, height_min: -1.0, reach_max: 16.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Pieces of the channel.
const PIECES: u32 = 120;

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = PhysicsWorld::new();
    let (vertices, triangles) = channel();
    let mesh = ColliderBuilder::trimesh(vertices, triangles)
        .expect("the channel has triangles")
        .friction(0.1);
    world.insert(RigidBodyBuilder::fixed(), mesh);
    for i in 0..90 {
        let place = Vector::new(-13.0 + 0.9 * (i % 15) as Real, 9.0 + 0.9 * (i / 15) as Real);
        let shape = if i % 2 == 0 { ColliderBuilder::ball(0.35) } else { square(0.3) };
        add(&mut world, place, shape.friction(0.1));
    }
    Scene::new(world, View::flat()).focusing(Vector::new(-16.0, -3.0), Vector::new(16.0, 10.0))
}

/// Returns the height of the ground.
fn height(x: Real) -> Real {
    0.03 * x * x + 0.8 * (0.9 * x).sin()
}

/// Returns a band of triangles below the ground line.
fn channel() -> (Vec<Vector>, Vec<[u32; 3]>) {
    let mut vertices = Vec::new();
    for i in 0..=PIECES {
        let x = -16.0 + 32.0 * i as Real / PIECES as Real;
        vertices.push(Vector::new(x, height(x)));
        vertices.push(Vector::new(x, height(x) - 1.5));
    }
    let triangles = (0..PIECES)
        .flat_map(|i| [[2 * i, 2 * i + 1, 2 * i + 2], [2 * i + 1, 2 * i + 3, 2 * i + 2]]);
    (vertices, triangles.collect())
}
