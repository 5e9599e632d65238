//! Event queues.

use crate::fault::{Fault, Kind};
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
    /// Whether each step discards the events before it.
    auto_drain: bool,
    /// Whether a step fills the queue. JavaScript can neither read nor free it then.
    is_lent: bool,
}

/// Receives the events of a step. It is shared: a call from a hook reads it during the step.
pub struct Events {
    records: Single<Records>,
}

impl Events {
    /// Prepares for the events of a step.
    fn begin_step(&self) {
        let records = self.records();
        if records.auto_drain {
            records.collisions.clear();
            records.forces.clear();
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
        let handles = (event.collider1().to_number(), event.collider2().to_number());
        self.records().collisions.push((handles.0, handles.1, f64::from(event.started())));
    }

    fn handle_contact_force_event(
        &self,
        _: Real,
        event: &ContactForceEvent,
        _: &RigidBodySet,
        _: &ColliderSet,
    ) {
        self.records().forces.push(*event);
    }
}

static QUEUES: Single<Registry<Events>> = Single::new(Registry::new());

/// The queue of a number, if no step fills it.
fn queue(number: u32) -> Result<&'static Events, Fault> {
    // SAFETY: boxes do not move when the registry grows, and `queue_free` drops none that is lent.
    let events = unsafe { QUEUES.get().get_shared(number) };
    let events = events.ok_or_else(|| Fault::freed("event queue"))?;
    match events.records().is_lent {
        true => Err(Fault::new(Kind::Busy, "a step fills this event queue".to_string())),
        false => Ok(events),
    }
}

/// Lends a queue to a step, until its return. The number 0 is no queue.
pub fn lend(number: u32) -> Result<Option<&'static Events>, Fault> {
    if number == 0 {
        return Ok(None);
    }
    let events = queue(number)?;
    events.records().is_lent = true;
    Ok(Some(events))
}

/// Ends the loan of a queue.
pub fn give_back(number: u32) {
    // SAFETY: the reference ends with the function.
    if let Some(events) = unsafe { QUEUES.get().get_shared(number) } {
        events.records().is_lent = false;
    }
}

/// Runs a step that fills a queue, or drops its events.
pub fn fill<R>(events: Option<&Events>, step: impl FnOnce(&dyn EventHandler) -> R) -> R {
    match events {
        Some(events) => {
            events.begin_step();
            step(events)
        }
        None => step(&()),
    }
}

exports! {
    /// Creates an event queue.
    fn queue_new(auto_drain: u32) -> u32 {
        let records = Records { auto_drain: auto_drain != 0, ..Records::default() };
        let events = Events { records: Single::new(records) };
        // SAFETY: the reference ends with the statement.
        unsafe { QUEUES.get().insert(events) }
    }

    /// Frees an event queue. A second time does nothing.
    fn queue_free(number: u32) {
        // SAFETY: the reference ends with the statement.
        if unsafe { QUEUES.get().get_shared(number) }.is_none() {
            return Ok(());
        }
        queue(number)?;
        // SAFETY: the reference ends with the statement.
        drop(unsafe { QUEUES.get().remove(number) });
    }

    /// Discards all events.
    fn queue_clear(number: u32) {
        let records = queue(number)?.records();
        (records.collisions, records.forces) = (Vec::new(), Vec::new());
    }

    /// Moves the collision events into the list: two colliders and 1 for the start of a collision, 0 for its
    /// end.
    fn queue_take_collisions(number: u32) -> u32 {
        let events = core::mem::take(&mut queue(number)?.records().collisions);
        put_list(events.into_iter().flat_map(|(collider1, collider2, started)| [collider1, collider2, started]))
    }

    /// Moves the contact force events into the lists. The list gets the colliders. The real numbers get the
    /// total force, its magnitude, the direction of the largest force and its magnitude.
    fn queue_take_forces(number: u32) -> u32 {
        let events = core::mem::take(&mut queue(number)?.records().forces);
        memory::put_reals(events.iter().flat_map(|event| {
            let total = event.total_force.to_array().into_iter().chain([event.total_force_magnitude]);
            total.chain(event.max_force_direction.to_array()).chain([event.max_force_magnitude])
        }));
        put_list(events.iter().flat_map(|event| [event.collider1.to_number(), event.collider2.to_number()]))
    }
}
