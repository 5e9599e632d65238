//! # Islands: connectivity, waking and sleep
//!
//! Reads:   the narrow phase's notes, and those of bodies that may sleep
//! Writes:  islands, the list of awake bodies, colours, removed pairs; sleep states; the velocities of bodies
//!     that fall asleep (zero); notes for events
//! Runs:    serial, in the order of the notes
//! Never:   changes a manifold's points; moves a body

mod sleep;

pub(crate) use sleep::{SleepScratch, put_to_sleep};

use crate::base::wide::PREFETCH_DISTANCE;
use crate::model::body::{RigidBody, RigidBodyHandle};
use crate::model::collider::{ActiveEvents, ColliderHandle, ColliderSet};
use crate::model::contact::{ContactManifold, PairId};
use crate::model::event::{CollisionEvent, CollisionEventFlags};
use crate::model::structure::Structure;
use crate::step::notes::{PairChange, StepNotes};

/// Links and cuts pairs that began and stopped touching, and wakes bodies that moving kinematic bodies touch.
pub(crate) fn update(structure: &mut Structure<'_>, notes: &mut StepNotes) {
    let StepNotes { contacts, intersections, events, .. } = notes;
    for (index, &(id, change)) in contacts.iter().enumerate() {
        if let Some(&(later, _)) = contacts.get(index + PREFETCH_DISTANCE) {
            structure.prefetch_contact(later);
        }
        follow_contact(structure, id, change, events);
    }
    for &(id, change) in intersections.iter() {
        follow_intersection(structure, id, change, events);
    }
    kinematic_motion_wakes_bodies(structure);
}

fn follow_contact(
    structure: &mut Structure<'_>,
    id: PairId,
    change: PairChange,
    events: &mut Vec<CollisionEvent>,
) {
    let none = CollisionEventFlags::empty();
    if change == PairChange::Apart {
        let reported = structure.remove_contact_pair(id, true);
        return events.extend(reported.map(|[one, two]| CollisionEvent::Stopped(one, two, none)));
    }
    structure.follow_contact(id);
    debug_assert!(
        structure.narrow_phase.contacts[id].manifolds.iter().all(ContactManifold::is_solvable),
        "the solver reads finite contacts"
    );
    let pair = &mut structure.narrow_phase.contacts[id];
    let (colliders, touching) = ([pair.collider1, pair.collider2], pair.is_touching());
    report(structure.colliders, colliders, touching, &mut pair.start_event_emitted, none, events);
    structure.rest_contact(id);
}

fn follow_intersection(
    structure: &mut Structure<'_>,
    id: PairId,
    change: PairChange,
    events: &mut Vec<CollisionEvent>,
) {
    let sensor = CollisionEventFlags::SENSOR;
    if change == PairChange::Apart {
        let reported = structure.narrow_phase.intersections.remove(id);
        return events.extend(reported.map(|[one, two]| CollisionEvent::Stopped(one, two, sensor)));
    }
    let pair = &mut structure.narrow_phase.intersections[id];
    let (colliders, touching) = ([pair.collider1, pair.collider2], pair.intersecting);
    report(structure.colliders, colliders, touching, &mut pair.start_event_emitted, sensor, events);
    structure.rest_intersection(id);
}

/// Notes an event if the pair began or stopped touching since its last event.
fn report(
    set: &ColliderSet,
    [collider1, collider2]: [ColliderHandle; 2],
    touching: bool,
    reported: &mut bool,
    flags: CollisionEventFlags,
    events: &mut Vec<CollisionEvent>,
) {
    if touching == *reported {
        return;
    }
    let has_collision_events = |handle| {
        set.get(handle).is_some_and(|collider| {
            collider.active_events().contains(ActiveEvents::COLLISION_EVENTS)
        })
    };
    if touching && (has_collision_events(collider1) || has_collision_events(collider2)) {
        *reported = true;
        events.push(CollisionEvent::Started(collider1, collider2, flags));
    } else if !touching {
        *reported = false;
        events.push(CollisionEvent::Stopped(collider1, collider2, flags));
    }
}

/// A kinematic body that has moved, or moves in this step, keeps everything awake that it touches or holds.
/// The velocity of a position-based body is that of its last step.
fn kinematic_motion_wakes_bodies(structure: &mut Structure<'_>) {
    let moves = |body: &RigidBody| body.is_moving() || body.next_position() != body.position();
    for position in 0..structure.islands.awake.kinematic().len() {
        let handle = structure.islands.awake.kinematic()[position];
        if structure.bodies.get(handle).is_some_and(moves) {
            wake_touching(structure, handle);
        }
    }
}

fn wake_touching(structure: &mut Structure<'_>, kinematic: RigidBodyHandle) {
    structure.wake_joined(kinematic);
    let Some(body) = structure.bodies.get(kinematic) else { return };
    for index in 0..body.colliders.len() {
        let Some(body) = structure.bodies.get(kinematic) else { return };
        let slot = body.colliders[index].into_raw_parts().0;
        structure.wake_touching(slot);
    }
}
