//! Bodies on a line.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add, square};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "polyline",
    description: "Bodies slide down a winding line into a basket, also a line.",
    category: Category::Shapes,
    steps: 420,
    law: Law { overlap_max: 0.01, height_min: -4.0, reach_max: 18.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = PhysicsWorld::new();
    world.insert(RigidBodyBuilder::fixed(), ColliderBuilder::polyline(slide(), None).friction(0.1));
    let basket = [(5.2, -1.5), (8.5, -4.0), (15.0, -4.0), (16.5, 4.0)];
    let basket = basket.map(|(x, y)| Vector::new(x, y)).to_vec();
    world.insert(RigidBodyBuilder::fixed(), ColliderBuilder::polyline(basket, None));
    for i in 0..70 {
        let place = Vector::new(-12.0 + 0.8 * (i % 10) as Real, 9.0 + 0.9 * (i / 10) as Real);
        let shape = match i % 3 {
            0 => ColliderBuilder::ball(0.3),
            1 => square(0.27),
            _ => ColliderBuilder::capsule_x(0.25, 0.2),
        };
        add(&mut world, place, shape.friction(0.1));
    }
    Scene::new(world, View::flat()).focusing(Vector::new(-15.0, -4.5), Vector::new(17.0, 9.0))
}

/// Returns a slide from the upper left, with waves.
fn slide() -> Vec<Vector> {
    (0..=100)
        .map(|i| {
            let t = i as Real / 100.0;
            let drop = 9.0 * (1.0 - t) * (1.0 - t);
            Vector::new(-14.0 + 20.0 * t, drop - 0.5 + 0.35 * t * (t * 26.0).sin())
        })
        .collect()
}
