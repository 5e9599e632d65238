//! Event handlers.

use crate::dynamics::RigidBodySet;
use crate::geometry::{
    ColliderSet, CollisionEvent, ContactForceEvent, ContactPair, to_pair, wrap_colliders,
};
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

    /// Called when a soft body tears: never, because the engine has none.
    #[cfg(rapier036)]
    fn handle_soft_body_tear_event(
        &self,
        _soft_bodies: &crate::dynamics::SoftBodySet,
        _event: &crate::dynamics::SoftBodyTearEvent,
    ) {
    }

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
        #[cfg(rapier036)] _soft_body_tear_event_sender: Sender<crate::dynamics::SoftBodyTearEvent>,
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
pub(super) struct Events<'a> {
    handler: &'a dyn EventHandler,
    /// The bodies that the step disabled.
    #[cfg(rapier036)]
    quarantined: std::sync::Mutex<Vec<crate::dynamics::RigidBodyHandle>>,
}

impl<'a> Events<'a> {
    /// Forwards to a handler of the program.
    pub fn new(handler: &'a dyn EventHandler) -> Self {
        Self {
            handler,
            #[cfg(rapier036)]
            quarantined: std::sync::Mutex::default(),
        }
    }

    /// The bodies that the step disabled.
    #[cfg(rapier036)]
    pub fn into_quarantined(self) -> Vec<crate::dynamics::RigidBodyHandle> {
        self.quarantined.into_inner().unwrap_or_default()
    }
}

impl engine::pipeline::EventHandler for Events<'_> {
    fn handle_collision_event(
        &self,
        bodies: &engine::dynamics::RigidBodySet,
        colliders: &engine::geometry::ColliderSet,
        event: &CollisionEvent,
        contact_pair: Option<&engine::geometry::ContactPair>,
    ) {
        let read = contact_pair.filter(|_| self.handler.reads_contact_pairs());
        let pair = read.map(to_pair);
        let (bodies, colliders) = (RigidBodySet::wrap(bodies), wrap_colliders(colliders));
        self.handler.handle_collision_event(bodies, colliders, *event, pair.as_ref());
    }

    fn handle_contact_force_event_of_pair(
        &self,
        dt: Real,
        event: &engine::geometry::ContactForceEvent,
        contact_pair: &engine::geometry::ContactPair,
        bodies: &engine::dynamics::RigidBodySet,
        colliders: &engine::geometry::ColliderSet,
    ) {
        if !self.handler.reads_contact_pairs() {
            return self.handler.handle_contact_force(event.into());
        }
        #[cfg_attr(not(rapier036), expect(unused_mut, reason = "version 0.36 has a mark"))]
        let mut pair = to_pair(contact_pair);
        #[cfg(rapier036)]
        {
            pair.force_started = event.started;
        }
        let (bodies, colliders) = (RigidBodySet::wrap(bodies), wrap_colliders(colliders));
        let total = event.total_force_magnitude;
        self.handler.handle_contact_force_event(dt, bodies, colliders, &pair, total);
    }

    #[cfg(rapier036)]
    fn handle_quarantine_event(
        &self,
        event: &engine::pipeline::QuarantineEvent,
        _: &engine::dynamics::RigidBodySet,
        _: &engine::geometry::ColliderSet,
    ) {
        if let engine::pipeline::QuarantineEvent::Body { body, .. } = event
            && let Ok(mut quarantined) = self.quarantined.lock()
        {
            quarantined.push(*body);
        }
    }
}
