//! Characters: they climb stairs and a slope, ride a lift and a turntable, and push crates.

use crate::common::{Controls, Law, Scene, SceneInfo, Walker};
use crate::kit::{add, add_fixed, cube, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "characters",
    description: "Characters walk over stairs, a roof, a lift and a turntable, and push crates.",
    category: Category::Controllers,
    steps: 200,
    law: Law { overlap_max: 0.01, height_min: 0.0, reach_max: 2.0, speed_max: 0.1, ..Law::NONE },
    source: file!(),
    build,
};

/// Distance of two lanes.
const LANE: Real = 3.0;

/// Adds stairs up and down, with their middle at x = 0.
fn add_stairs(world: &mut PhysicsWorld, z: Real) {
    for step in 0..8 {
        let half = ColliderBuilder::cuboid(3.0 - 0.35 * step as Real, 0.1, 1.2);
        add_fixed(world, Vector::new(0.0, 0.1 + 0.2 * step as Real, z), half);
    }
}

/// Adds a roof of two slopes of 30°.
fn add_roof(world: &mut PhysicsWorld, z: Real) {
    let corners = [(-3.0, 0.0), (3.0, 0.0), (0.0, 3.0 * Real::to_radians(30.0).tan())];
    let corners =
        corners.iter().flat_map(|&(x, y)| [-1.2, 1.2].map(|depth| Vector::new(x, y, depth)));
    let roof = ColliderBuilder::convex_hull(&corners.collect::<Vec<_>>());
    world.insert_collider(roof.expect("a prism").translation(Vector::Z * z), None);
}

/// Adds a platform that rises by 2 and descends again, between two floors of that height.
fn add_lift(world: &mut PhysicsWorld, z: Real) -> RigidBodyHandle {
    for side in [-1.0, 1.0] {
        let floor = ColliderBuilder::cuboid(1.4, 1.0, 1.2);
        add_fixed(world, Vector::new(2.7 * side, 1.0, z), floor);
    }
    let lift = RigidBodyBuilder::kinematic_velocity_based().translation(Vector::new(0.0, -0.1, z));
    world.insert(lift, ColliderBuilder::cuboid(1.2, 0.1, 1.2)).0
}

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(30.0);
    let lanes = [2.0, 1.0, 0.0, -1.0, -2.0].map(|lane| lane * LANE);
    add_stairs(&mut world, lanes[0]);
    add_roof(&mut world, lanes[1]);
    let lift = add_lift(&mut world, lanes[4]);
    let table = RigidBodyBuilder::kinematic_velocity_based()
        .translation(Vector::new(0.0, 0.1, lanes[3]))
        .angvel(Vector::Y * 1.0);
    world.insert(table, ColliderBuilder::cylinder(0.1, 1.4));
    for i in 0..6 {
        let place = Vector::new(0.5 * i as Real - 1.0, 0.25, lanes[2] + 0.1 * (i % 3) as Real);
        add(&mut world, place, cube(0.2).density(20.0));
    }

    let mut walkers = Vec::new();
    for lane in [0, 1, 2] {
        for (x, speed) in [(-4.5, 2.0), (4.5, -1.5)] {
            // The characters are side by side, so that they pass each other.
            let foot = Vector::new(x, 0.0, lanes[lane] + 0.4 * speed);
            walkers.push(Walker::new(&mut world, foot, speed, [-5.0, 5.0]));
        }
    }
    for (x, z) in [(0.0, lanes[4]), (0.9, lanes[3]), (-0.6, lanes[3] + 0.5)] {
        walkers.push(Walker::new(&mut world, Vector::new(x, 0.2, z), 0.0, [-5.0, 5.0]));
    }
    let view = View::orbit(32.0, 32.0);
    let scene =
        Scene::new(world, view).focusing(Vector::new(-5.0, 0.0, -7.0), Vector::new(5.0, 2.5, 7.0));
    let controls = Controls::new("Arrow keys move a character on the stairs.");
    let keys = controls.clone();
    scene.controlled(controls).script(move |world, step| {
        let time = step as Real * world.integration_parameters.dt;
        if let Some(lift) = world.bodies.get_mut(lift) {
            lift.set_linvel(Vector::Y * (1.2 * time).sin() * 1.2, true);
        }
        if let Some([right, up]) = keys.direction() {
            walkers[0].steer(Vector::new(2.5 * right, 0.0, -2.5 * up));
        }
        walkers.iter_mut().for_each(|walker| walker.walk(world));
    })
}
