//! Small worlds, and a handler that records events.

use crate::dim::{cuboid, vec};
use rapier::prelude::*;
use std::sync::Mutex;

/// Returns a world with fixed ground, with its top at height 0.
pub fn world_with_ground() -> (PhysicsWorld, ColliderHandle) {
    let mut world = PhysicsWorld::new();
    let ground = cuboid(50.0, 1.0).translation(vec(0.0, -1.0));
    let ground = world.insert_collider(ground, None);
    (world, ground)
}

/// Adds a dynamic box of half extents 0.5 with locked rotations.
pub fn add_box(
    world: &mut PhysicsWorld,
    place: Vector,
    collider: impl FnOnce(ColliderBuilder) -> ColliderBuilder,
) -> (RigidBodyHandle, ColliderHandle) {
    let body = RigidBodyBuilder::dynamic().translation(place).lock_rotations();
    world.insert(body, collider(cuboid(0.5, 0.5)))
}

/// Returns the collider unchanged.
pub fn plain(collider: ColliderBuilder) -> ColliderBuilder {
    collider
}

/// Returns the collider with all events active.
pub fn with_events(collider: ColliderBuilder) -> ColliderBuilder {
    collider.active_events(ActiveEvents::all())
}

pub fn steps(world: &mut PhysicsWorld, count: usize) {
    (0..count).for_each(|_| world.step());
}

/// Returns the height of a body.
pub fn height(world: &PhysicsWorld, body: RigidBodyHandle) -> Real {
    world.bodies[body].translation().y
}

/// Returns whether a number equals its target within this error.
#[track_caller]
pub fn close(found: Real, expected: Real, error: Real) {
    assert!((found - expected).abs() <= error, "{found} is not {expected}");
}

/// Handler that records all events in their order.
#[derive(Default)]
pub struct Protocol {
    pub collisions: Mutex<Vec<CollisionEvent>>,
    pub forces: Mutex<Vec<ContactForceEvent>>,
}

impl Protocol {
    /// Returns the collision events since the last call.
    pub fn collisions(&self) -> Vec<CollisionEvent> {
        std::mem::take(&mut self.collisions.lock().unwrap())
    }

    /// Returns the contact-force events since the last call.
    pub fn forces(&self) -> Vec<ContactForceEvent> {
        std::mem::take(&mut self.forces.lock().unwrap())
    }

    /// Steps a world and returns the collision events of these steps.
    pub fn of_steps(&self, world: &mut PhysicsWorld, count: usize) -> Vec<CollisionEvent> {
        (0..count).for_each(|_| world.step_with_events(&(), self));
        self.collisions()
    }
}

impl EventHandler for Protocol {
    fn handle_collision_event(
        &self,
        _: &RigidBodySet,
        _: &ColliderSet,
        event: &CollisionEvent,
        _: Option<&ContactPair>,
    ) {
        self.collisions.lock().unwrap().push(*event);
    }

    fn handle_contact_force_event(
        &self,
        _: Real,
        event: &ContactForceEvent,
        _: &RigidBodySet,
        _: &ColliderSet,
    ) {
        self.forces.lock().unwrap().push(*event);
    }
}

/// Panics unless the event is between these two colliders, in either order.
#[track_caller]
pub fn between(event: &CollisionEvent, a: ColliderHandle, b: ColliderHandle) {
    let mut found = [event.collider1(), event.collider2()];
    let mut expected = [a, b];
    found.sort_unstable();
    expected.sort_unstable();
    assert_eq!(found, expected, "{event:?}");
}
