//! Conveyor belts: surfaces with a velocity on fixed bodies.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add, add_fixed, cube, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};
use std::collections::BTreeMap;

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "conveyor_belts",
    description: "A hook gives contacts a tangent velocity: four belts with rails carry boxes round in a square.",
    category: Category::Basics,
    steps: 480,
    law: Law { overlap_max: 0.01, height_min: 0.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Speed of the belts (m/s).
const SPEED: Real = 2.0;

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
    for (center, along) in [
        (Vector::new(-1.0, 0.5, -4.0), Vector::X),
        (Vector::new(4.0, 0.5, -1.0), Vector::Z),
        (Vector::new(1.0, 0.5, 4.0), -Vector::X),
        (Vector::new(-4.0, 0.5, 1.0), -Vector::Z),
    ] {
        let across = Vector::new(along.z.abs(), 0.0, along.x.abs());
        let half = along.abs() * 4.0 + across * 1.0 + Vector::Y * 0.25;
        let shape = ColliderBuilder::cuboid(half.x, half.y, half.z)
            .friction(1.0)
            .active_hooks(ActiveHooks::MODIFY_SOLVER_CONTACTS);
        let body = add_fixed(&mut world, center, shape);
        belts.insert(world.bodies[body].colliders()[0].into_raw_parts(), along * SPEED);
    }
    for (distance, half_length) in [(2.8, 2.6), (5.2, 5.4)] {
        add_rails(&mut world, distance, half_length);
    }
    for i in 0..24 {
        let (side, place) = (i / 6, (i % 6) as Real - 2.5);
        let y = 1.3 + 0.2 * (i % 3) as Real;
        let start = match side {
            0 => Vector::new(place, y, -4.0),
            1 => Vector::new(4.0, y, place),
            2 => Vector::new(-place, y, 4.0),
            _ => Vector::new(-4.0, y, -place),
        };
        add(&mut world, start, cube(0.3));
    }
    Scene::new(world, View::orbit(30.0, 38.0)).hooks(Belts(belts))
}

/// Adds four rails without friction around the middle.
fn add_rails(world: &mut PhysicsWorld, distance: Real, half_length: Real) {
    for side in [-distance, distance] {
        let along_x = ColliderBuilder::cuboid(half_length, 0.6, 0.2).friction(0.0);
        add_fixed(world, Vector::new(0.0, 0.5, side), along_x);
        let along_z = ColliderBuilder::cuboid(0.2, 0.6, half_length).friction(0.0);
        add_fixed(world, Vector::new(side, 0.5, 0.0), along_z);
    }
}
