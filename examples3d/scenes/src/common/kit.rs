//! The first bodies of most scenes.

use crate::rapier::prelude::*;

/// Adds a dynamic body with one collider.
pub(crate) fn add(
    world: &mut PhysicsWorld,
    place: Vector,
    collider: ColliderBuilder,
) -> RigidBodyHandle {
    world.insert(RigidBodyBuilder::dynamic().translation(place), collider).0
}

/// Adds a fixed body with one collider.
pub(crate) fn add_fixed(
    world: &mut PhysicsWorld,
    place: Vector,
    collider: ColliderBuilder,
) -> RigidBodyHandle {
    world.insert(RigidBodyBuilder::fixed().translation(place), collider).0
}
