//! Event queues.

use crate::fault::Fault;
use crate::handle::Handle;
use crate::memory::{self, Single, put_list};
use crate::rapier::dynamics::RigidBodySet;
use crate::rapier::geometry::{ColliderSet, CollisionEvent, ContactForceEvent, ContactPair};
use crate::rapier::math::Real;
use crate::rapier::pipeline::EventHandler;
use crate::registry::Registry;

/// The events of the steps since the queue was drained.
#[derive(Default)]
struct Records {
    collisions: Vec<(f64, f64, f64)>,
    forces: Vec<ContactForceEvent>,
}

/// Receives the events of a step.
pub struct Events {
    records: Single<Records>,
    auto_drain: bool,
    is_kept: bool,
}

impl Default for Events {
    fn default() -> Self {
        Self { records: Single::new(Records::default()), auto_drain: true, is_kept: false }
    }
}

impl Events {
    /// Prepares for the events of a step.
    pub fn begin_step(&mut self, is_kept: bool) {
        self.is_kept = is_kept;
        if self.auto_drain {
            *self.records() = Records::default();
        }
    }

    #[allow(clippy::mut_from_ref, reason = "events arrive through a shared reference")]
    fn records(&self) -> &mut Records {
        // SAFETY: no caller keeps the reference beyond its statement.
        unsafe { self.records.get() }
    }
}

impl EventHandler for Events {
    fn handle_collision_event(
        &self,
        _: &RigidBodySet,
        _: &ColliderSet,
        event: &CollisionEvent,
        _: Option<&ContactPair>,
    ) {
        if self.is_kept {
            let handles = (event.collider1().to_number(), event.collider2().to_number());
            self.records().collisions.push((handles.0, handles.1, f64::from(event.started())));
        }
    }

    fn handle_contact_force_event(
        &self,
        _: Real,
        event: &ContactForceEvent,
        _: &RigidBodySet,
        _: &ColliderSet,
    ) {
        if self.is_kept {
            self.records().forces.push(*event);
        }
    }
}

static QUEUES: Single<Registry<Events>> = Single::new(Registry::new());

/// The queue of a number.
pub fn queue(number: u32) -> Result<&'static mut Events, Fault> {
    // SAFETY: an exported function asks for one queue, once.
    unsafe { QUEUES.get().get(number) }.ok_or_else(|| Fault::freed("event queue"))
}

exports! {
    /// Creates an event queue.
    fn queue_new(auto_drain: u32) -> u32 {
        let events = Events { auto_drain: auto_drain != 0, ..Events::default() };
        // SAFETY: the reference ends with the statement.
        unsafe { QUEUES.get().insert(events) }
    }

    /// Frees an event queue.
    fn queue_free(number: u32) {
        // SAFETY: the reference ends with the statement.
        drop(unsafe { QUEUES.get().remove(number) });
    }

    /// Forgets all events.
    fn queue_clear(number: u32) {
        *queue(number)?.records() = Records::default();
    }

    /// Moves the collision events into the list: two colliders and 1 for the start of a collision, 0 for its end.
    fn queue_take_collisions(number: u32) -> u32 {
        let events = core::mem::take(&mut queue(number)?.records().collisions);
        put_list(events.into_iter().flat_map(|(collider1, collider2, started)| [collider1, collider2, started]))
    }

    /// Moves the contact force events into the lists: colliders into the list; total force, its magnitude, the direction of the largest force and its
    /// magnitude into the real numbers.
    fn queue_take_forces(number: u32) -> u32 {
        let events = core::mem::take(&mut queue(number)?.records().forces);
        memory::put_reals(events.iter().flat_map(|event| {
            let total = event.total_force.to_array().into_iter().chain([event.total_force_magnitude]);
            total.chain(event.max_force_direction.to_array()).chain([event.max_force_magnitude])
        }));
        put_list(events.iter().flat_map(|event| [event.collider1.to_number(), event.collider2.to_number()]))
    }
}
