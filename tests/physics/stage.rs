//! Worlds to run tests in, and what they have in common.

use crate::dim::{about_z, assortment, cuboid, vec};
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

/// The deepest overlap of any two colliders (m).
pub fn penetration(world: &PhysicsWorld) -> Real {
    let deepest = world.contact_pairs().filter_map(|(_, _, pair)| pair.find_deepest_contact());
    deepest.map(|(_, _, depth)| depth).fold(0.0, Real::max)
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

/// An empty world of this many steps per second, without gravity.
pub fn weightless(rate: u32) -> PhysicsWorld {
    let mut world = world(rate);
    world.gravity = Vector::ZERO;
    world
}

/// A reproducible sequence of numbers (SplitMix64).
pub struct Dice(pub u64);

impl Dice {
    /// The next number, from `low` to `high`.
    pub fn within(&mut self, low: Real, high: Real) -> Real {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        let unit = ((z ^ (z >> 31)) >> 40) as f64 / (1_u64 << 24) as f64;
        low + (high - low) * unit as Real
    }
}

/// Drops `count` bodies of all shapes in a column above the height 0 at `x`; returns their handles.
pub fn drop_pile(world: &mut PhysicsWorld, x: Real, count: usize) -> Vec<RigidBodyHandle> {
    let shapes = assortment();
    let mut dice = Dice(count as u64);
    let mut drop = |k: usize| {
        let place = vec(x + dice.within(-1.0, 1.0), 0.5 + 0.6 * (k / 2) as Real);
        let body = RigidBodyBuilder::dynamic()
            .translation(place)
            .rotation(about_z(dice.within(-3.0, 3.0)));
        world.insert(body, shapes[k % shapes.len()].clone().restitution(0.2)).0
    };
    (0..count).map(&mut drop).collect()
}
