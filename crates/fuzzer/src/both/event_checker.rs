//! Event handler that checks the sequence of events.

use super::rapier::prelude::*;
use std::collections::BTreeSet;
use std::sync::Mutex;

/// Tracks the touching pairs by events alone.
#[derive(Default)]
pub struct EventChecker {
    touching: Mutex<BTreeSet<[ColliderHandle; 2]>>,
    errors: Mutex<Vec<String>>,
    /// Whether events were missed. The touching pairs are then unknown.
    has_missed_events: bool,
}

impl EventChecker {
    /// Records that events were missed.
    pub fn mark_missed_events(&mut self) {
        self.has_missed_events = true;
    }

    /// # Panics
    /// If an event was inconsistent.
    pub fn check(&self) {
        let errors = self.errors.lock().unwrap();
        assert!(errors.is_empty(), "{}", errors.join("\n"));
    }

    fn report(&self, to: &impl core::fmt::Debug, reason: &str) {
        self.errors.lock().unwrap().push(format!("{reason}: {to:?}"));
    }
}

impl EventHandler for EventChecker {
    fn handle_collision_event(
        &self,
        _: &RigidBodySet,
        colliders: &ColliderSet,
        event: &CollisionEvent,
        pair: Option<&ContactPair>,
    ) {
        let mut key = [event.collider1(), event.collider2()];
        let living = key.iter().filter(|handle| colliders.contains(**handle)).count();
        key.sort_unstable();
        let mut touching = self.touching.lock().unwrap();
        if event.started() {
            if !touching.insert(key) && !self.has_missed_events {
                self.report(event, "a touching pair began to touch");
            }
            if event.removed() || living < 2 {
                self.report(event, "a removed collider began to touch");
            }
            if pair.is_some() == event.sensor() {
                self.report(event, "solid colliders have contacts, sensors have none");
            }
        } else {
            if !touching.remove(&key) && !self.has_missed_events {
                self.report(event, "a separate pair stopped touching");
            }
            if event.removed() != (living < 2) {
                self.report(event, "`removed` is wrong");
            }
        }
    }

    fn handle_contact_force_event(
        &self,
        dt: Real,
        event: &ContactForceEvent,
        _: &RigidBodySet,
        colliders: &ColliderSet,
    ) {
        if !colliders.contains(event.collider1) || !colliders.contains(event.collider2) {
            self.report(event, "a force on removed colliders");
        }
        let is_valid = event.total_force.is_finite()
            && event.total_force_magnitude.is_finite()
            && event.max_force_magnitude.is_finite()
            && event.max_force_magnitude >= 0.0
            && dt > 0.0;
        if !is_valid {
            self.report(event, "a force with invalid numbers");
        }
    }
}
