//! The events of a step.

use crate::rapier::prelude::*;
use std::sync::mpsc::channel;

/// The events of one step, in the order of the engine's reports.
#[derive(Debug, Default)]
pub struct StepEvents {
    /// Colliders that began or ceased to touch.
    pub collisions: Vec<CollisionEvent>,
    /// Contacts with a force of at least the threshold of a collider.
    pub contact_forces: Vec<ContactForceEvent>,
}

impl StepEvents {
    /// Runs a step and collects its events. Each step has channels of its own, so copies of a scene share
    /// no events.
    pub(super) fn collect<T>(step: impl FnOnce(&dyn EventHandler) -> T) -> (T, Self) {
        let (send_collision, collisions) = channel();
        let (send_force, forces) = channel();
        let result = step(&ChannelEventCollector::new(send_collision, send_force));
        let events = Self {
            collisions: collisions.try_iter().collect(),
            contact_forces: forces.try_iter().collect(),
        };
        (result, events)
    }
}
