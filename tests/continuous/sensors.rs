//! Sensors notice what flies through them in one step.

use super::{PHASES, RADIUS, SPEEDS};
use crate::dim::grounds::box_mesh;
use crate::dim::{cuboid, vec};
use crate::suite::physics::stage::weightless;
use crate::suite::physics::table::Table;
use core::cell::RefCell;
use rapier::prelude::*;

/// Writes down what it is told.
#[derive(Default)]
struct Log(RefCell<Vec<CollisionEvent>>);

// SAFETY: events are sent on the thread that called the step, one after the other.
unsafe impl Sync for Log {}

impl EventHandler for Log {
    fn handle_collision_event(
        &self,
        _: &RigidBodySet,
        _: &ColliderSet,
        event: &CollisionEvent,
        _: Option<&ContactPair>,
    ) {
        self.0.borrow_mut().push(*event);
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
