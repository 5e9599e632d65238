//! Simple shapes rain onto a floor.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add, add_walls, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "primitives",
    description: "Balls, boxes, capsules and triangles rain onto a floor.",
    category: Category::Basics,
    steps: 300,
    law: Law { overlap_max: 0.05, height_min: 0.0, reach_max: 17.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(50.0);
    add_walls(&mut world, 9.0, 6.0);
    let (a, b, c) = (Vector::new(-0.5, -0.4), Vector::new(0.5, -0.4), Vector::new(0.0, 0.5));
    let shapes = [
        ColliderBuilder::ball(0.45),
        ColliderBuilder::cuboid(0.5, 0.35),
        ColliderBuilder::capsule_y(0.35, 0.3),
        ColliderBuilder::triangle(a, b, c),
    ];
    for layer in 0..16 {
        for column in 0..12 {
            // Layers are shifted, so that no body lands flat on an equal one.
            let shift = if layer % 2 == 0 { 0.0 } else { 0.4 };
            let x = 1.4 * (column as Real - 5.5) + shift;
            let place = Vector::new(x, 1.0 + 1.3 * layer as Real);
            add(&mut world, place, shapes[(layer + column) % 4].clone());
        }
    }
    Scene::new(world, View::flat())
}
