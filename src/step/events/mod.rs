//! # Events: calls of the user's event handler
//!
//! Reads:   notes of begun and ended contacts, broken joints and quarantined bodies; impulses
//! Writes:  the flags of pairs that reach their force threshold; calls of the user's handler
//! Runs:    serial, in the order of the colliders; forces in that of the pairs
//! Never:   changes a body, a collider or the structure

use crate::base::held::HeldPanic;
use crate::dim::math::Real;
use crate::model::body::RigidBodySet;
use crate::model::collider::{ActiveEvents, Collider, ColliderSet};
use crate::model::contact::{ContactPair, NarrowPhase};
use crate::model::event::{ContactForceEvent, EventHandler};
use crate::step::notes::StepNotes;

/// Context of the events.
pub(crate) struct EventContext<'a> {
    pub bodies: &'a RigidBodySet,
    pub colliders: &'a ColliderSet,
    pub narrow_phase: &'a mut NarrowPhase,
    pub notes: &'a StepNotes,
    /// Duration of the motion: 0 if no contact has an impulse.
    pub duration: Real,
    pub handler: &'a dyn EventHandler,
}

/// Sends all events of a step. A handler that panics is called for the rest of them, too: none is lost.
pub(crate) fn report(context: EventContext<'_>, panic: &mut HeldPanic) {
    let EventContext { bodies, colliders, narrow_phase, notes, duration: dt, handler } = context;
    for event in &notes.quarantined {
        panic.hold(|| handler.handle_quarantine_event(event, bodies, colliders));
    }
    for event in &notes.events {
        let pair = narrow_phase.contact_pair(event.collider1(), event.collider2());
        panic.hold(|| handler.handle_collision_event(bodies, colliders, event, pair));
    }
    for event in &notes.broken {
        panic.hold(|| handler.handle_joint_break_event(event, bodies));
    }
    if dt <= 0.0 {
        return;
    }
    let mut strong = core::mem::take(narrow_phase.contacts.strong_mut());
    for id in narrow_phase.contacts.reporting() {
        let pair = narrow_phase.written_back(id);
        let Some(threshold) = force_threshold(pair, colliders) else { continue };
        let total = pair.total_impulse_magnitude() / dt;
        if total > 0.0 && total >= threshold {
            let mut event = ContactForceEvent::from_contact_pair(dt, pair, total);
            event.started = strong.insert(id);
            panic.hold(|| {
                handler.handle_contact_force_event_of_pair(dt, &event, pair, bodies, colliders);
            });
        } else {
            strong.remove(id);
        }
    }
    *narrow_phase.contacts.strong_mut() = strong;
}

/// The force threshold of a pair: the lower threshold of the colliders with force events. `None` if neither
/// does.
fn force_threshold(pair: &ContactPair, colliders: &ColliderSet) -> Option<Real> {
    let threshold = |collider: &Collider| {
        let has_force_events =
            collider.active_events().contains(ActiveEvents::CONTACT_FORCE_EVENTS);
        has_force_events.then_some(collider.contact_force_event_threshold)
    };
    let of = |handle| colliders.get(handle).and_then(threshold);
    match (of(pair.collider1), of(pair.collider2)) {
        (Some(a), Some(b)) => Some(a.min(b)),
        (a, b) => a.or(b),
    }
}
