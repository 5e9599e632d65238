//! A thousand boxes glide over level ground, of one box or of two hundred thousand triangles. Both grounds
//! must give the same motion.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::surface;
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// The entry of the ground of triangles.
pub const ON_MESH: SceneInfo = SceneInfo {
    name: "glide_mesh",
    description: "1,000 boxes glide without friction over a level mesh of 200,000 triangles.",
    category: Category::PastBugs,
    steps: 300,
    law: Law { overlap_max: 0.01, ..Law::NONE },
    source: file!(),
    build: || build(triangles()),
};

/// The entry of the ground of one box.
pub const ON_BOX: SceneInfo = SceneInfo {
    name: "glide_box",
    description: "1,000 boxes glide without friction over one box: the cost of level ground.",
    category: Category::PastBugs,
    steps: 300,
    law: Law { overlap_max: 0.01, ..Law::NONE },
    source: file!(),
    build: || build(slab()),
};

/// Number of squares of two triangles along each side, and their length.
const SQUARES: u32 = 317;
const SIZE: Real = 0.3;
/// Boxes along each side of the crowd.
const BOXES: usize = 32;
/// Speed of the boxes (m/s).
const SPEED: Real = 3.0;

/// Returns the mesh.
fn triangles() -> ColliderBuilder {
    surface(SQUARES, SIZE, |_, _| 0.0)
}

/// Returns the box, with its top at the height of the mesh.
fn slab() -> ColliderBuilder {
    let half = 0.5 * SIZE * SQUARES as Real;
    ColliderBuilder::cuboid(half, 1.0, half).translation(-Vector::Y)
}

fn build(ground: ColliderBuilder) -> Scene {
    let mut world = PhysicsWorld::new();
    world.insert(RigidBodyBuilder::fixed(), ground.friction(0.0));
    for i in 0..1_000 {
        let [x, z] = [i % BOXES, i / BOXES].map(|n| 1.6 * (n as Real - 0.5 * BOXES as Real));
        let place = Vector::new(x - 8.0, 0.3, z);
        let body = RigidBodyBuilder::dynamic().translation(place).linvel(Vector::X * SPEED);
        world.insert(body, ColliderBuilder::cuboid(0.5, 0.3, 0.4).friction(0.0));
    }
    Scene::new(world, View::orbit(28.0, 60.0))
        .focusing(Vector::new(-34.0, -2.0, -26.0), Vector::new(34.0, 4.0, 26.0))
}
