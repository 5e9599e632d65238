//! Worlds to run tests in, and what they have in common.

use crate::dim::{cuboid, vec};
use rapier::prelude::*;

/// Steps per second at which everything is tested.
pub const RATES: [u32; 3] = [30, 60, 240];
/// Acceleration of gravity (m/s²).
pub const G: Real = 9.81;

/// An empty world of this many steps per second.
pub fn world(rate: u32) -> PhysicsWorld {
    let mut world = PhysicsWorld::new();
    world.integration_parameters.dt = 1.0 / rate as Real;
    world
}

/// Adds fixed ground whose top is at the height 0, with this friction.
pub fn add_ground(world: &mut PhysicsWorld, friction: Real) -> ColliderHandle {
    let slab = cuboid(100.0, 1.0).translation(vec(0.0, -1.0)).friction(friction);
    world.insert_collider(slab, None)
}

/// Runs a world for this time (s).
pub fn run(world: &mut PhysicsWorld, seconds: Real) {
    for _ in 0..steps(world, seconds) {
        world.step();
    }
}

/// How many steps this time is.
pub fn steps(world: &PhysicsWorld, seconds: Real) -> usize {
    (seconds / world.integration_parameters.dt).round() as usize
}

/// The length of a substep (s).
pub fn substep(world: &PhysicsWorld) -> Real {
    world.integration_parameters.substep()
}

/// How far rounding alone may carry a sum of `terms` numbers of this size: half a unit in the last
/// place each, all in the same direction.
pub fn rounding(terms: usize, size: Real) -> Real {
    0.5 * Real::EPSILON * size * terms as Real
}
