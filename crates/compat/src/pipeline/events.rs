//! Event handlers.

use crate::dynamics::RigidBodySet;
use crate::geometry::{ColliderSet, CollisionEvent, ContactForceEvent, ContactPair, to_pair};
use crate::math::Real;
use std::sync::mpsc::Sender;

/// Handler of the events of a step.
pub trait EventHandler: Send + Sync {
    /// Called when two colliders begin or stop to touch or intersect.
    fn handle_collision_event(
        &self,
        bodies: &RigidBodySet,
        colliders: &ColliderSet,
        event: CollisionEvent,
        contact_pair: Option<&ContactPair>,
    );

    /// Called when the contact forces of two colliders reach a threshold.
    fn handle_contact_force_event(
        &self,
        dt: Real,
        bodies: &RigidBodySet,
        colliders: &ColliderSet,
        contact_pair: &ContactPair,
        total_force_magnitude: Real,
    );

    /// Returns whether the handler reads contact pairs. If not, no pair is converted: collision events have
    /// no pair, and [`Self::handle_contact_force`] replaces [`Self::handle_contact_force_event`].
    #[doc(hidden)]
    fn reads_contact_pairs(&self) -> bool {
        true
    }

    /// Called with a contact force event if the handler reads no contact pairs.
    #[doc(hidden)]
    fn handle_contact_force(&self, _event: ContactForceEvent) {}
}

/// Ignores all events.
impl EventHandler for () {
    fn handle_collision_event(
        &self,
        _: &RigidBodySet,
        _: &ColliderSet,
        _: CollisionEvent,
        _: Option<&ContactPair>,
    ) {
    }

    fn handle_contact_force_event(
        &self,
        _: Real,
        _: &RigidBodySet,
        _: &ColliderSet,
        _: &ContactPair,
        _: Real,
    ) {
    }

    fn reads_contact_pairs(&self) -> bool {
        false
    }
}

/// Sends all events into channels.
pub struct ChannelEventCollector {
    collisions: Sender<CollisionEvent>,
    forces: Sender<ContactForceEvent>,
}

impl ChannelEventCollector {
    /// A collector with one channel for each kind of event.
    pub fn new(
        collision_event_sender: Sender<CollisionEvent>,
        contact_force_event_sender: Sender<ContactForceEvent>,
    ) -> Self {
        Self { collisions: collision_event_sender, forces: contact_force_event_sender }
    }
}

impl EventHandler for ChannelEventCollector {
    fn handle_collision_event(
        &self,
        _: &RigidBodySet,
        _: &ColliderSet,
        event: CollisionEvent,
        _: Option<&ContactPair>,
    ) {
        // Not an error: a dropped receiver disables the events.
        let _ = self.collisions.send(event);
    }

    fn handle_contact_force_event(
        &self,
        dt: Real,
        _: &RigidBodySet,
        _: &ColliderSet,
        contact_pair: &ContactPair,
        total_force_magnitude: Real,
    ) {
        let event = ContactForceEvent::from_contact_pair(dt, contact_pair, total_force_magnitude);
        self.handle_contact_force(event);
    }

    fn reads_contact_pairs(&self) -> bool {
        false
    }

    fn handle_contact_force(&self, event: ContactForceEvent) {
        let _ = self.forces.send(event);
    }
}

/// An event handler for the engine.
pub(super) struct Events<'a>(pub &'a dyn EventHandler);

impl engine::pipeline::EventHandler for Events<'_> {
    fn handle_collision_event(
        &self,
        bodies: &engine::dynamics::RigidBodySet,
        colliders: &ColliderSet,
        event: &CollisionEvent,
        contact_pair: Option<&engine::geometry::ContactPair>,
    ) {
        let read = contact_pair.filter(|_| self.0.reads_contact_pairs());
        let pair = read.map(to_pair);
        let bodies = RigidBodySet::wrap(bodies);
        self.0.handle_collision_event(bodies, colliders, *event, pair.as_ref());
    }

    fn handle_contact_force_event_of_pair(
        &self,
        dt: Real,
        event: &engine::geometry::ContactForceEvent,
        contact_pair: &engine::geometry::ContactPair,
        bodies: &engine::dynamics::RigidBodySet,
        colliders: &ColliderSet,
    ) {
        if !self.0.reads_contact_pairs() {
            return self.0.handle_contact_force(event.into());
        }
        let pair = to_pair(contact_pair);
        let bodies = RigidBodySet::wrap(bodies);
        let total = event.total_force_magnitude;
        self.0.handle_contact_force_event(dt, bodies, colliders, &pair, total);
    }
}
