//! Dominoes: one push topples all.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::world_with_floor;
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "dominoes",
    description: "A spiral of 200 dominoes falls, one after the other.",
    category: Category::Basics,
    steps: 1000,
    law: Law { overlap_max: 0.01, height_min: 0.0, reach_max: 10.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Number of dominoes.
const COUNT: usize = 200;
/// Distance of neighbouring dominoes.
const SPACING: Real = 0.55;

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(50.0);
    let stone = ColliderBuilder::cuboid(0.08, 0.6, 0.3);
    let (mut angle, mut radius): (Real, Real) = (0.0, 2.5);
    for i in 0..COUNT {
        let place = Vector::new(radius * angle.cos(), 0.6, radius * angle.sin());
        // The face is perpendicular to the spiral.
        let mut body = RigidBodyBuilder::dynamic()
            .translation(place)
            .rotation(Vector::Y * (-angle - 0.5 * crate::kit::HALF_TURN));
        if i == 0 {
            let forward = Vector::new(-angle.sin(), 0.0, angle.cos());
            body = body.linvel(forward * 0.8).angvel(Vector::Y.cross(forward) * 2.0);
        }
        world.insert(body, stone.clone());
        let turn = SPACING / radius;
        angle += turn;
        radius += turn * 0.32;
    }
    Scene::new(world, View::orbit(30.0, 45.0))
}
