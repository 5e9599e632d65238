//! A handler of events that believes nothing.

use super::rapier::prelude::*;
use std::collections::BTreeSet;
use std::sync::Mutex;

/// Follows who touches whom by the events alone.
#[derive(Default)]
pub struct Witness {
    touching: Mutex<BTreeSet<[ColliderHandle; 2]>>,
    lies: Mutex<Vec<String>>,
    /// Some events were not heard: who touches whom cannot be known any more.
    is_lost: bool,
}

impl Witness {
    /// Some events were not heard.
    pub fn lose_track(&mut self) {
        self.is_lost = true;
    }

    /// # Panics
    /// If an event made no sense.
    pub fn check(&self) {
        let lies = self.lies.lock().unwrap();
        assert!(lies.is_empty(), "{}", lies.join("\n"));
    }

    fn object(&self, to: &impl core::fmt::Debug, reason: &str) {
        self.lies.lock().unwrap().push(format!("{reason}: {to:?}"));
    }
}

impl EventHandler for Witness {
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
            if !touching.insert(key) && !self.is_lost {
                self.object(event, "what touches began to touch");
            }
            if event.removed() || living < 2 {
                self.object(event, "a removed collider began to touch");
            }
            if pair.is_some() == event.sensor() {
                self.object(event, "solid colliders have contacts, sensors have not");
            }
        } else {
            if !touching.remove(&key) && !self.is_lost {
                self.object(event, "what did not touch stopped touching");
            }
            if event.removed() != (living < 2) {
                self.object(event, "`removed` is not true");
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
            self.object(event, "a force on nothing");
        }
        let sound = event.total_force.is_finite()
            && event.total_force_magnitude.is_finite()
            && event.max_force_magnitude.is_finite()
            && event.max_force_magnitude >= 0.0
            && dt > 0.0;
        if !sound {
            self.object(event, "no force");
        }
    }
}
