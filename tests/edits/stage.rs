//! A box that rests on the ground, and a handler that records events.

use crate::dim::{cuboid, vec};
use rapier::prelude::*;
use std::sync::Mutex;

/// A box on the ground. Its collider reports collisions.
pub struct Resting {
    pub world: PhysicsWorld,
    pub body: RigidBodyHandle,
    pub collider: ColliderHandle,
    pub ground: ColliderHandle,
}

impl Resting {
    /// The box is a centimetre above the ground.
    pub fn falling() -> Self {
        let mut world = PhysicsWorld::new();
        let ground = cuboid(50.0, 1.0).translation(vec(0.0, -1.0));
        let events = ActiveEvents::COLLISION_EVENTS;
        let ground = world.insert_collider(ground.active_events(events), None);
        let body = RigidBodyBuilder::dynamic().translation(vec(0.0, 0.51));
        let (body, collider) = world.insert(body, cuboid(0.5, 0.5).active_events(events));
        Self { world, body, collider, ground }
    }

    /// The box sleeps.
    pub fn asleep() -> Self {
        let mut scene = Self::falling();
        (0..150).for_each(|_| scene.world.step());
        assert!(scene.body().is_sleeping());
        scene
    }

    pub fn body(&mut self) -> &mut RigidBody {
        &mut self.world.bodies[self.body]
    }

    pub fn box_collider(&mut self) -> &mut Collider {
        &mut self.world.colliders[self.collider]
    }

    pub fn ground(&mut self) -> &mut Collider {
        &mut self.world.colliders[self.ground]
    }

    /// Edits both colliders.
    pub fn each(&mut self, edit: impl Fn(&mut Collider)) {
        edit(self.box_collider());
        edit(self.ground());
    }
}

/// Handler that records collision events in their order.
#[derive(Default)]
pub struct Protocol(Mutex<Vec<CollisionEvent>>);

impl Protocol {
    /// Steps a world and returns the events of these steps.
    pub fn of_steps(&self, world: &mut PhysicsWorld, count: usize) -> Vec<CollisionEvent> {
        (0..count).for_each(|_| world.step_with_events(&(), self));
        std::mem::take(&mut self.0.lock().expect("no handler panics"))
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
        self.0.lock().expect("no handler panics").push(*event);
    }

    fn handle_contact_force_event(
        &self,
        _: Real,
        _: &ContactForceEvent,
        _: &RigidBodySet,
        _: &ColliderSet,
    ) {
    }
}

impl AsMut<PhysicsWorld> for Resting {
    fn as_mut(&mut self) -> &mut PhysicsWorld {
        &mut self.world
    }
}
