//! A module with one thread: the same functions as [`threads`](crate::threads) with the feature of that name, without workers.

use crate::rapier::pipeline::PhysicsWorld;

/// Does nothing: there is one thread.
pub fn choose(_world: &mut PhysicsWorld, _has_hooks: bool) {}

/// Returns whether the calling thread is run by a worker.
pub fn is_worker() -> bool {
    false
}
