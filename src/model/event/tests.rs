//! Flags of events, and their delivery.

use super::{
    ChannelEventCollector, CollisionEvent, CollisionEventFlags, ContactForceEvent, EventHandler,
};
use crate::dim::math::{Real, Vector};
use crate::model::body::RigidBodySet;
use crate::model::collider::{ColliderHandle, ColliderSet};
use crate::model::contact::{Contact, ContactManifold, ContactPair};
use parry::shape::PackedFeatureId;
use std::sync::mpsc::channel;

fn handle(id: u32) -> ColliderHandle {
    ColliderHandle::from_raw_parts(id, 0)
}

fn pressing(normal: Vector, impulses: &[Real]) -> ContactManifold {
    let mut manifold = ContactManifold::default();
    manifold.data.normal = normal;
    for &impulse in impulses {
        let (zero, feature) = (Vector::ZERO, PackedFeatureId::UNKNOWN);
        let mut contact = Contact::new(zero, zero, feature, feature, 0.0);
        contact.impulse = impulse;
        manifold.data.points.push(contact);
    }
    manifold
}

#[test]
fn flags_and_colliders_are_read_back() {
    let event = CollisionEvent::Stopped(handle(1), handle(2), CollisionEventFlags::REMOVED);
    assert!(event.stopped() && !event.started() && event.removed() && !event.sensor());
    assert_eq!((event.collider1(), event.collider2()), (handle(1), handle(2)));
    let event = CollisionEvent::Started(handle(1), handle(2), CollisionEventFlags::SENSOR);
    assert!(event.started() && event.sensor() && !event.removed());
}

#[test]
fn squeezing_forces_cancel_in_the_sum_only() {
    let mut pair = ContactPair { collider1: handle(3), ..Default::default() };
    pair.manifolds.push(pressing(Vector::Y, &[1.0, 2.0]));
    pair.manifolds.push(pressing(-Vector::Y, &[2.5]));
    let dt = 0.5;
    let total = pair.total_impulse_magnitude() / dt;
    let event = ContactForceEvent::from_contact_pair(dt, &pair, total);
    assert_eq!(event.collider1, handle(3));
    assert_eq!(event.total_force, Vector::Y);
    assert_eq!(event.total_force_magnitude, 11.0);
    assert_eq!((event.max_force_magnitude, event.max_force_direction), (5.0, -Vector::Y));
    let still = ContactForceEvent::from_contact_pair(0.0, &pair, 0.0);
    assert_eq!(still.total_force, Vector::ZERO);
}

#[test]
fn collector_sends_both_kinds_and_survives_a_lost_receiver() {
    let (send_collision, collisions) = channel();
    let (send_force, forces) = channel();
    let collector = ChannelEventCollector::new(send_collision, send_force);
    let (bodies, colliders) = (RigidBodySet::new(), ColliderSet::new());
    let hit = CollisionEvent::Started(handle(1), handle(2), CollisionEventFlags::empty());
    let force = ContactForceEvent { max_force_magnitude: 3.0, ..Default::default() };
    collector.handle_collision_event(&bodies, &colliders, &hit, None);
    collector.handle_contact_force_event(1.0, &force, &bodies, &colliders);
    assert_eq!(collisions.try_iter().collect::<Vec<_>>(), [hit]);
    assert_eq!(forces.try_iter().collect::<Vec<_>>(), [force]);
    drop((collisions, forces));
    collector.handle_collision_event(&bodies, &colliders, &hit, None);
    collector.handle_contact_force_event(1.0, &force, &bodies, &colliders);
}
