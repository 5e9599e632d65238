//! Common worlds and helpers of the tests.

use crate::dim::{about_z, assortment, cuboid, vec};
use rapier::prelude::*;

/// Tested numbers of steps per second.
pub const RATES: [u32; 3] = [30, 60, 240];
/// Acceleration of gravity (m/s²).
pub const G: Real = 9.81;

/// Returns an empty world with this number of steps per second.
pub fn world(rate: u32) -> PhysicsWorld {
    let mut world = PhysicsWorld::new();
    world.integration_parameters.dt = 1.0 / rate as Real;
    world
}

/// Adds fixed ground with its top at height 0, with this friction.
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

/// Returns the number of steps in this time.
pub fn steps(world: &PhysicsWorld, seconds: Real) -> usize {
    (seconds / world.integration_parameters.dt).round() as usize
}

/// Returns the largest penetration of any two colliders (m).
pub fn penetration(world: &PhysicsWorld) -> Real {
    let deepest = world.contact_pairs().filter_map(|(_, _, pair)| pair.find_deepest_contact());
    deepest.map(|(_, _, depth)| depth).fold(0.0, Real::max)
}

/// Returns the length of a substep (s).
pub fn substep(world: &PhysicsWorld) -> Real {
    world.integration_parameters.substep()
}

/// Returns a bound of the rounding error of a sum of `terms` numbers of this size. It is half a unit in the
/// last place each, all in the same direction.
pub fn rounding(terms: usize, size: Real) -> Real {
    0.5 * Real::EPSILON * size * terms as Real
}

/// Returns an empty world with this number of steps per second, without gravity.
pub fn weightless(rate: u32) -> PhysicsWorld {
    let mut world = world(rate);
    world.gravity = Vector::ZERO;
    world
}

/// Environment variable with which sweeps run all their cases.
const WHOLE_SWEEPS: &str = "WHOLE_SWEEPS";

/// The part of a sweep that runs by default, where all cases take minutes: one of `period` in the order of
/// the loops. The period has no factor in common with the numbers of values of the inner loops, so that each
/// value occurs.
pub struct Sample {
    period: usize,
    index: usize,
}

impl Sample {
    /// One of `period` cases, or all.
    pub fn one_of(period: usize) -> Self {
        let period = if std::env::var_os(WHOLE_SWEEPS).is_some() { 1 } else { period };
        Self { period, index: 0 }
    }

    /// Returns whether the next case runs.
    pub fn has_next(&mut self) -> bool {
        self.index += 1;
        (self.index - 1).is_multiple_of(self.period)
    }
}

/// Reproducible sequence of numbers (SplitMix64).
pub struct Dice(pub u64);

impl Dice {
    /// Returns the next number, from `low` to `high`.
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
