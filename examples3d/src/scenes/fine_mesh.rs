//! A thousand boxes on a mesh of two hundred thousand triangles.

use crate::common::{Scene, SceneInfo};
use crate::kit::add;
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// The scene's entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "fine_mesh",
    description: "1,000 boxes fall on hills of 200,000 triangles, each smaller than a box.",
    category: Category::Stress,
    steps: 300,
    build,
};

/// Squares of two triangles along each side, and how long they are.
const SQUARES: u32 = 317;
const SIZE: Real = 0.3;
/// Boxes along each side of the crowd.
const BOXES: usize = 32;

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = PhysicsWorld::new();
    let at = |i: u32, j: u32| i * (SQUARES + 1) + j;
    let middle = 0.5 * SIZE * SQUARES as Real;
    let vertex = |i: u32, j: u32| {
        let [x, z] = [i, j].map(|n| SIZE * n as Real - middle);
        Vector::new(x, height(x, z), z)
    };
    let vertices = (0..=SQUARES).flat_map(|i| (0..=SQUARES).map(move |j| vertex(i, j)));
    let square = |i: u32, j: u32| {
        let [a, b, c, d] = [at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)];
        [[a, b, c], [a, c, d]]
    };
    let triangles = (0..SQUARES).flat_map(|i| (0..SQUARES).flat_map(move |j| square(i, j)));
    let ground = ColliderBuilder::trimesh(vertices.collect(), triangles.collect());
    world.insert(RigidBodyBuilder::fixed(), ground.expect("the hills have triangles"));
    for i in 0..1_000 {
        let [x, z] = [i % BOXES, i / BOXES].map(|n| 1.6 * (n as Real - 0.5 * BOXES as Real));
        let y = height(x, z) + 1.5 + 0.3 * (i % 5) as Real;
        add(&mut world, Vector::new(x, y, z), ColliderBuilder::cuboid(0.5, 0.3, 0.4));
    }
    Scene::new(world, View::orbit(28.0, 60.0))
        .focusing(Vector::new(-24.0, -2.0, -20.0), Vector::new(24.0, 4.0, 24.0))
}

/// Gentle hills.
fn height(x: Real, z: Real) -> Real {
    0.8 * (0.31 * x).sin() * (0.23 * z).cos() + 0.3 * (0.9 * x + 0.4 * z).sin()
}
