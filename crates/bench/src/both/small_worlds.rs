//! Worlds of few bodies.

use super::dim::{add_floors, cell, cube, hinge, pin};
use super::ours::prelude::*;
use crate::small::Small;

/// Number of bodies in a chain.
const LINKS: usize = 5;
/// Side of the square of cells, in worlds of many bodies.
const SIDE: usize = 23;
/// Number of bodies in these worlds.
const BODIES: usize = 500;
/// Distance of the cells.
const SPACING: Real = 3.0;
/// Speed of fast bodies (m/s). They move by more than their radius in a step.
const THROW_SPEED: Real = 60.0;

/// Builds a world.
pub fn build(world: Small) -> PhysicsWorld {
    let mut built = PhysicsWorld::new();
    let ball = || ColliderBuilder::ball(0.5);
    match world {
        Small::Empty => {}
        Small::FreeBall => insert(&mut built, Vector::ZERO, ball()),
        Small::BallOnGround => on_ground(&mut built, ball()),
        Small::BoxOnGround => on_ground(&mut built, cube(0.5)),
        Small::Door => door(&mut built),
        Small::Chain => chain(&mut built, Vector::ZERO),
        Small::Chains => (0..10).for_each(|k| chain(&mut built, cell(k, 10, 10.0))),
        Small::FreeFall => scatter(&mut built, 0.0),
        Small::Fast => scatter(&mut built, THROW_SPEED),
        Small::AmongFixed => among_fixed(&mut built),
    }
    built
}

fn insert(world: &mut PhysicsWorld, place: Vector, collider: ColliderBuilder) {
    world.insert(RigidBodyBuilder::dynamic().translation(place), collider);
}

fn on_ground(world: &mut PhysicsWorld, collider: ColliderBuilder) {
    add_floors(world, 1, 10.0);
    insert(world, 0.5 * Vector::Y, collider);
}

/// A leaf that a motor swings to and fro: the limits of the hinge stop the leaf.
fn door(world: &mut PhysicsWorld) {
    let frame = world.insert_body(RigidBodyBuilder::fixed());
    let leaf = world.insert_body(RigidBodyBuilder::dynamic().translation(0.5 * Vector::X));
    world.insert_collider(cube(0.25), Some(leaf));
    let joint = hinge().local_anchor2(-0.5 * Vector::X).limits([-1.5, 1.5]);
    world.insert_impulse_joint(frame, leaf, joint.motor_velocity(1.0, 10.0));
}

/// Boxes in a row whose first hangs on a fixed point: they swing.
fn chain(world: &mut PhysicsWorld, place: Vector) {
    let mut last = world.insert_body(RigidBodyBuilder::fixed().translation(place));
    for link in 1..=LINKS {
        let middle = place + link as Real * Vector::X;
        let body = world.insert_body(RigidBodyBuilder::dynamic().translation(middle));
        world.insert_collider(cube(0.2), Some(body));
        let anchor = if link == 1 { Vector::ZERO } else { 0.5 * Vector::X };
        world.insert_impulse_joint(last, body, pin(anchor, -0.5 * Vector::X));
        last = body;
    }
}

/// Balls far from each other, all with the same velocity upwards.
fn scatter(world: &mut PhysicsWorld, speed: Real) {
    for index in 0..BODIES {
        let body = RigidBodyBuilder::dynamic().translation(cell(index, SIDE, SPACING));
        world.insert(body.linvel(speed * Vector::Y), ColliderBuilder::ball(0.5));
    }
}

/// Boxes on some of many fixed blocks.
fn among_fixed(world: &mut PhysicsWorld) {
    for index in 0..10_000 {
        let place = cell(index, 100, SPACING);
        world.insert(RigidBodyBuilder::fixed().translation(place), cube(0.5));
        if index % 500 == 0 {
            insert(world, place + 0.9 * Vector::Y, cube(0.4));
        }
    }
}
