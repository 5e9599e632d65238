//! Conveyor belts: surfaces with a velocity on fixed bodies.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add, add_fixed, square, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};
use std::collections::BTreeMap;

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "conveyor_belts",
    description: "A hook gives contacts a tangent velocity: belts carry boxes to and fro, down to the floor.",
    category: Category::Basics,
    steps: 600,
    law: Law { overlap_max: 0.01, height_min: 0.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Speed of the belts (m/s).
const SPEED: Real = 1.5;

/// Surface velocities of the belts. Handles are not ordered, so the key is the pair of numbers in the handle.
struct Belts(BTreeMap<(u32, u32), Vector>);

impl Belts {
    fn velocity(&self, collider: ColliderHandle) -> Option<Vector> {
        self.0.get(&collider.into_raw_parts()).copied()
    }
}

impl PhysicsHooks for Belts {
    fn modify_solver_contact(&self, context: &mut ContactModificationContext) {
        // The tangent velocity is the second body's velocity relative to the first, as friction aims for it.
        if let Some(velocity) = self.velocity(context.collider1) {
            context.set_tangent_velocity(velocity);
        } else if let Some(velocity) = self.velocity(context.collider2) {
            context.set_tangent_velocity(-velocity);
        }
    }
}

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(50.0);
    let mut belts = BTreeMap::new();
    for i in 0..4 {
        let (side, y) = (if i % 2 == 0 { 1.0 } else { -1.0 }, 1.5 + 2.0 * i as Real);
        let shape = ColliderBuilder::round_cuboid(6.0, 0.1, 0.15)
            .friction(1.0)
            .active_hooks(ActiveHooks::MODIFY_SOLVER_CONTACTS);
        let body = add_fixed(&mut world, Vector::new(-side * 1.5, y), shape);
        let key = world.bodies[body].colliders()[0].into_raw_parts();
        belts.insert(key, Vector::X * (side * SPEED));
    }
    for i in 0..24 {
        let place = Vector::new(0.8 * (i % 12) as Real - 3.0, 8.5 + 0.9 * (i / 12) as Real);
        add(&mut world, place, square(0.3));
    }
    Scene::new(world, View::flat())
        .hooks(Belts(belts))
        .focusing(Vector::new(-10.0, 0.0), Vector::new(10.0, 10.0))
}
