//! Simple shapes rain onto a floor.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add, add_walls, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "primitives",
    description: "Balls, boxes, capsules, cylinders and cones rain onto a floor.",
    category: Category::Basics,
    steps: 300,
    law: Law { overlap_max: 0.01, height_min: 0.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(200.0);
    add_walls(&mut world, 6.0, 0.8);
    let shapes = [
        ColliderBuilder::ball(0.5),
        ColliderBuilder::cuboid(0.5, 0.4, 0.6),
        ColliderBuilder::capsule_y(0.4, 0.35),
        ColliderBuilder::cylinder(0.4, 0.5),
        ColliderBuilder::cone(0.5, 0.5),
    ];
    for layer in 0..10 {
        for row in 0..5 {
            for column in 0..5 {
                // Layers are shifted, so that no body lands flat on an equal one.
                let shift = if layer % 2 == 0 { 0.0 } else { 0.35 };
                let [x, z] = [column, row].map(|i| 1.4 * (i as Real - 2.0) + shift);
                let place = Vector::new(x, 1.0 + 1.6 * layer as Real, z);
                add(&mut world, place, shapes[(layer + row + 2 * column) % 5].clone());
            }
        }
    }
    Scene::new(world, View::orbit(30.0, 22.0))
        .focusing(Vector::new(-7.0, 0.0, -7.0), Vector::new(7.0, 3.0, 7.0))
}
