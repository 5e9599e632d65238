//! Characters: they climb stairs and a slope, ride a lift and a raft, and push crates.

use crate::common::{Controls, Law, Scene, SceneInfo, Walker};
use crate::kit::{add, add_fixed, square, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "characters",
    description: "Characters walk over stairs and a roof, ride a lift and a raft, and push crates.",
    category: Category::Controllers,
    steps: 200,
    law: Law { overlap_max: 0.01, height_min: 0.0, reach_max: 20.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Adds stairs up and down, with their middle at `x`.
fn add_stairs(world: &mut PhysicsWorld, x: Real) {
    for step in 0..8 {
        let half = ColliderBuilder::cuboid(3.0 - 0.35 * step as Real, 0.1);
        add_fixed(world, Vector::new(x, 0.1 + 0.2 * step as Real), half);
    }
}

/// Adds a roof of two slopes of 30°.
fn add_roof(world: &mut PhysicsWorld, x: Real) {
    let ridge = Vector::new(0.0, 3.0 * Real::to_radians(30.0).tan());
    let roof = ColliderBuilder::triangle(-Vector::X * 3.0, Vector::X * 3.0, ridge);
    world.insert_collider(roof.translation(Vector::X * x), None);
}

/// Adds a platform that a script moves.
fn add_platform(world: &mut PhysicsWorld, place: Vector) -> RigidBodyHandle {
    let body = RigidBodyBuilder::kinematic_velocity_based().translation(place);
    world.insert(body, ColliderBuilder::cuboid(1.5, 0.1)).0
}

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(60.0);
    add_stairs(&mut world, -12.0);
    add_roof(&mut world, -3.5);
    let lift = add_platform(&mut world, Vector::new(3.0, 0.2));
    let raft = add_platform(&mut world, Vector::new(9.0, 1.2));
    for i in 0..6 {
        let [column, row] = [i % 3, i / 3].map(|n| n as Real);
        let place = Vector::new(15.0 + 0.5 * column, 0.25 + 0.45 * row);
        add(&mut world, place, square(0.2).density(40.0));
    }
    let mut walkers: Vec<Walker> = [
        (-16.5, 0.0, 2.0, [-16.5, -7.5]),
        (-4.0, 1.8, -1.5, [-7.0, 0.5]),
        (3.0, 0.4, 0.0, [0.0, 1.0]),
        (8.0, 1.4, 0.5, [8.0, 10.0]),
        (13.0, 0.0, 1.0, [12.5, 17.0]),
    ]
    .map(|(x, y, speed, range)| Walker::new(&mut world, Vector::new(x, y), speed, range))
    .into();
    let scene =
        Scene::new(world, View::flat()).focusing(Vector::new(-17.5, -0.5), Vector::new(18.5, 4.0));
    let controls = Controls::new("Left and right keys move a character.");
    let keys = controls.clone();
    scene.controlled(controls).script(move |world, step| {
        let time = step as Real * world.integration_parameters.dt;
        if let Some(lift) = world.bodies.get_mut(lift) {
            lift.set_linvel(Vector::Y * (1.2 * time).sin() * 1.2, true);
        }
        if let Some(raft) = world.bodies.get_mut(raft) {
            raft.set_linvel(Vector::X * (0.8 * time).cos(), true);
            raft.set_angvel(0.2 * (1.5 * time).cos(), true);
        }
        if let Some([right, _]) = keys.direction() {
            walkers[0].steer(Vector::X * (2.5 * right));
        }
        walkers.iter_mut().for_each(|walker| walker.walk(world));
    })
}
