//! Handles, notes of changes, sleep.

use super::off_center_body;
use crate::dim::math::Vector;
use crate::model::body::{RigidBodyBuilder, RigidBodyChanges, RigidBodyHandle, RigidBodySet};
use crate::model::collider::{ColliderBuilder, ColliderHandle, ColliderSet};

/// Clears the change flags, like a step.
fn apply_changes(bodies: &mut RigidBodySet) -> Vec<RigidBodyHandle> {
    let modified = bodies.take_modified();
    for handle in &modified {
        if let Some(body) = bodies.get_unnoted_mut(*handle) {
            body.changes = RigidBodyChanges::empty();
        }
    }
    modified
}

#[test]
fn a_stale_handle_finds_nothing() {
    let mut bodies = RigidBodySet::new();
    let stale = bodies.insert(RigidBodyBuilder::fixed());
    assert!(bodies.remove(stale).is_some());
    assert!(bodies.remove(stale).is_none());
    let fresh = bodies.insert(RigidBodyBuilder::dynamic());
    assert_eq!(stale.into_raw_parts().0, fresh.into_raw_parts().0, "the slot is used again");
    assert!(bodies.get(stale).is_none() && bodies.get_mut(stale).is_none());
    assert!(!bodies.contains(stale) && !bodies.contains(RigidBodyHandle::invalid()));
    let (none, some) = bodies.get_pair_mut(stale, fresh);
    assert!(none.is_none() && some.is_some());
    let (some, none) = bodies.get_pair_mut(fresh, fresh);
    assert!(some.is_some() && none.is_none());
    assert_eq!(bodies.len(), 1);
    let (body, handle) = bodies.get_unknown_gen(0).expect("the slot is taken");
    assert!(body.is_dynamic() && handle == fresh);
}

#[test]
fn each_change_is_noted_once() {
    let mut bodies = RigidBodySet::new();
    let handles: Vec<_> = (0..3).map(|_| bodies.insert(RigidBodyBuilder::dynamic())).collect();
    assert_eq!(apply_changes(&mut bodies), handles);
    assert_eq!(apply_changes(&mut bodies), []);

    bodies[handles[1]].set_linvel(Vector::X, true);
    bodies[handles[1]].set_translation(Vector::X, true);
    bodies.get_unnoted_mut(handles[2]).expect("it is there").set_linvel(Vector::X, true);
    assert_eq!(apply_changes(&mut bodies), [handles[1]]);

    bodies.iter_mut().for_each(|(_, body)| body.wake_up(true));
    assert_eq!(apply_changes(&mut bodies), handles);
}

#[test]
fn removed_bodies_list_their_colliders() {
    let mut bodies = RigidBodySet::new();
    let handle = bodies.insert(off_center_body());
    let collider = ColliderHandle::from_raw_parts(7, 0);
    bodies[handle].attach_collider(collider);
    let copy = bodies[handle].clone();
    let body = bodies.remove(handle).expect("it is there");
    assert!(body.colliders().is_empty());
    let removed = bodies.take_removed();
    assert_eq!((removed[0].0, &removed[0].1), (handle, &Some(smallvec::smallvec![collider])));

    let inserted = bodies.insert(copy);
    assert!(bodies[inserted].colliders().is_empty(), "a copy has no colliders");
}

#[test]
fn sleep_stops_and_waking_is_noted() {
    let mut body = off_center_body();
    body.set_linvel(Vector::X, true);
    body.sleep();
    assert!(body.is_sleeping() && !body.is_moving());
    body.changes = RigidBodyChanges::empty();
    body.wake_up(false);
    assert_eq!(body.changes, RigidBodyChanges::SLEEP);
    assert!(body.activation().is_eligible_for_sleep(), "a weak wake-up keeps the timer");
    body.wake_up(true);
    assert!(!body.activation().is_eligible_for_sleep());
}

#[test]
fn copy_from_keeps_colliders_and_their_mass() {
    let mut bodies = RigidBodySet::new();
    let handle = bodies.insert(RigidBodyBuilder::dynamic());
    let collider = ColliderHandle::from_raw_parts(3, 1);
    bodies[handle].attach_collider(collider);
    bodies[handle].mprops.from_colliders = super::ball_mass(Vector::ZERO);
    let other = off_center_body();
    bodies[handle].copy_from(&other);
    let body = &bodies[handle];
    assert_eq!((body.position(), body.colliders()), (other.position(), &[collider][..]));
    assert!(body.mass() > other.mass() * 1.5);
    assert!(body.changes.contains(RigidBodyChanges::IN_MODIFIED_SET));
}

#[test]
fn colliders_follow_their_body_before_the_next_step() {
    let (mut bodies, mut colliders) = (RigidBodySet::new(), ColliderSet::new());
    let handle = bodies.insert(RigidBodyBuilder::fixed());
    let ball = ColliderBuilder::ball(1.0).translation(Vector::Y);
    let collider = colliders.insert_with_parent(ball, handle, &mut bodies);
    apply_changes(&mut bodies);
    bodies[handle].set_translation(Vector::X * 3.0, true);
    assert_eq!(colliders[collider].position().translation, Vector::Y);
    bodies.propagate_modified_body_positions_to_colliders(&mut colliders);
    assert_eq!(colliders[collider].position().translation, Vector::X * 3.0 + Vector::Y);
}
