//! The event handler that sends events into channels.

use super::{CollisionEvent, ContactForceEvent, EventHandler, QuarantineEvent};
use crate::dim::math::Real;
use crate::model::body::RigidBodySet;
use crate::model::collider::ColliderSet;
use crate::model::contact::ContactPair;
use std::sync::mpsc::Sender;

/// An event handler that sends every event into a channel.
///
/// ```
/// # use rapier3d::prelude::*;
/// use std::sync::mpsc::channel;
///
/// let (send_collision, collisions) = channel();
/// let (send_force, forces) = channel();
/// let events = ChannelEventCollector::new(send_collision, send_force);
///
/// let mut world = PhysicsWorld::new();
/// world.step_with_events(&(), &events);
/// for event in collisions.try_iter() {
///     println!("{:?} and {:?}: {}", event.collider1(), event.collider2(), event.started());
/// }
/// # assert!(forces.try_recv().is_err());
/// ```
#[derive(Clone, Debug)]
pub struct ChannelEventCollector {
    collisions: Sender<CollisionEvent>,
    forces: Sender<ContactForceEvent>,
    quarantines: Option<Sender<QuarantineEvent>>,
}

impl ChannelEventCollector {
    /// A handler that sends collision events into one channel and contact-force events into the other. Events
    /// whose receiver was dropped are discarded.
    pub fn new(
        collision_event_sender: Sender<CollisionEvent>,
        contact_force_event_sender: Sender<ContactForceEvent>,
    ) -> Self {
        Self {
            collisions: collision_event_sender,
            forces: contact_force_event_sender,
            quarantines: None,
        }
    }

    /// Also sends quarantine events, into a separate channel.
    ///
    /// ```
    /// # use rapier3d::prelude::*;
    /// # use std::sync::mpsc::channel;
    /// # let (send_collision, _collisions) = channel();
    /// # let (send_force, _forces) = channel();
    /// let (send_quarantine, quarantines) = channel();
    /// let events = ChannelEventCollector::new(send_collision, send_force)
    ///     .with_quarantine_events(send_quarantine);
    ///
    /// let mut world = PhysicsWorld::new();
    /// let ball = world.insert_body(RigidBodyBuilder::dynamic().additional_mass(1.0));
    /// world.bodies[ball].add_force(Vector::Y * 1.0e30, true);
    /// world.step_with_events(&(), &events);
    /// assert_eq!(quarantines.try_recv().unwrap().body(), Some(ball));
    /// ```
    #[must_use]
    pub fn with_quarantine_events(self, sender: Sender<QuarantineEvent>) -> Self {
        Self { quarantines: Some(sender), ..self }
    }
}

impl EventHandler for ChannelEventCollector {
    fn handle_collision_event(
        &self,
        _bodies: &RigidBodySet,
        _colliders: &ColliderSet,
        event: &CollisionEvent,
        _contact_pair: Option<&ContactPair>,
    ) {
        // Not an error: a dropped receiver disables the events.
        let _ = self.collisions.send(*event);
    }

    fn handle_contact_force_event(
        &self,
        _dt: Real,
        event: &ContactForceEvent,
        _bodies: &RigidBodySet,
        _colliders: &ColliderSet,
    ) {
        let _ = self.forces.send(*event);
    }

    fn handle_quarantine_event(
        &self,
        event: &QuarantineEvent,
        _bodies: &RigidBodySet,
        _colliders: &ColliderSet,
    ) {
        if let Some(quarantines) = &self.quarantines {
            let _ = quarantines.send(*event);
        }
    }
}
