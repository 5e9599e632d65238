//! The events of a step.

use crate::rapier::prelude::*;
use std::sync::{Mutex, PoisonError};

/// The events of one step, in the order of the engine's reports.
#[derive(Debug, Default)]
pub struct StepEvents {
    /// Colliders that began or ceased to touch.
    pub collisions: Vec<CollisionEvent>,
    /// Contacts with a force above the threshold of a collider.
    pub contact_forces: Vec<ContactForceEvent>,
}

/// Collects the events of one step. Each step has a log of its own, so copies of a scene share no events.
#[derive(Default)]
pub(super) struct EventLog(Mutex<StepEvents>);

impl EventLog {
    /// The collected events.
    pub(super) fn into_events(self) -> StepEvents {
        self.0.into_inner().unwrap_or_else(PoisonError::into_inner)
    }

    fn add(&self, change: impl FnOnce(&mut StepEvents)) {
        change(&mut self.0.lock().unwrap_or_else(PoisonError::into_inner));
    }
}

impl EventHandler for EventLog {
    fn handle_collision_event(
        &self,
        _: &RigidBodySet,
        _: &ColliderSet,
        event: &CollisionEvent,
        _: Option<&ContactPair>,
    ) {
        self.add(|events| events.collisions.push(*event));
    }

    fn handle_contact_force_event(
        &self,
        _: Real,
        event: &ContactForceEvent,
        _: &RigidBodySet,
        _: &ColliderSet,
    ) {
        self.add(|events| events.contact_forces.push(*event));
    }
}
