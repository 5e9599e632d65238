//! Saved worlds of this engine, in either precision.

use super::engine::prelude::PhysicsWorld;
use crate::clock::Clock;

pub fn save(world: &PhysicsWorld) -> Option<Vec<u8>> {
    world.to_snapshot().ok()
}

pub fn load(bytes: &[u8]) -> bool {
    PhysicsWorld::from_snapshot(bytes).is_ok()
}

pub fn save_and_return(world: &mut PhysicsWorld) -> Option<f64> {
    // The timed copies reuse the memory of this one, as in a game that saves every step.
    let mut saved = world.clone();
    saved.clone_from(world);
    let clock = Clock::start(1);
    saved.clone_from(world);
    world.clone_from(&saved);
    Some(clock.milliseconds())
}
