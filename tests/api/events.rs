//! Start and end events of touching solid colliders.

use super::stage::{Protocol, add_box, between, plain, steps, with_events, world_with_ground};
use crate::dim::{cuboid, vec};
use rapier::prelude::*;
use std::sync::mpsc::channel;

const NONE: CollisionEventFlags = CollisionEventFlags::empty();

#[test]
fn a_bounce_begins_once_and_ends_once() {
    let (mut world, ground) = world_with_ground();
    let (body, ball) = add_box(&mut world, vec(0.0, 2.0), |c| with_events(c).restitution(1.0));
    world.colliders[ground].set_restitution(1.0);
    let protocol = Protocol::default();
    let mut events = Vec::new();
    for _ in 0..60 {
        let falls = world.bodies[body].linvel().y < 0.0;
        for event in protocol.of_steps(&mut world, 1) {
            between(&event, ground, ball);
            assert!(!event.sensor() && !event.removed());
            assert!(event.stopped() || falls, "it begins on the way down");
            events.push(event.started());
        }
    }
    assert_eq!(events, [true, false], "down, up");
}

#[test]
fn colliders_without_active_events_send_none() {
    let (mut world, ground) = world_with_ground();
    let protocol = Protocol::default();
    let (body, _) = add_box(&mut world, vec(0.0, 0.6), plain);
    let force_only = |c: ColliderBuilder| c.active_events(ActiveEvents::CONTACT_FORCE_EVENTS);
    let (other, _) = add_box(&mut world, vec(3.0, 0.6), force_only);
    assert!(protocol.of_steps(&mut world, 60).is_empty());
    world.remove_body(body);
    world.remove_body(other);
    assert!(protocol.of_steps(&mut world, 2).is_empty(), "nor of the end");

    world.colliders[ground].set_active_events(ActiveEvents::COLLISION_EVENTS);
    let (_, collider) = add_box(&mut world, vec(0.0, 0.6), plain);
    let events = protocol.of_steps(&mut world, 60);
    assert_eq!(events.len(), 1, "either collider may have the flag");
    between(&events[0], ground, collider);
}

#[test]
fn events_switched_on_and_off_while_touching() {
    let (mut world, ground) = world_with_ground();
    let (body, collider) = add_box(&mut world, vec(0.0, 0.5), plain);
    let protocol = Protocol::default();
    assert!(protocol.of_steps(&mut world, 10).is_empty());
    world.colliders[collider].set_active_events(ActiveEvents::COLLISION_EVENTS);
    let events = protocol.of_steps(&mut world, 1);
    assert_eq!(events.len(), 1, "what touches already is reported now");
    assert!(events[0].started());
    world.colliders[collider].set_active_events(ActiveEvents::empty());
    assert!(protocol.of_steps(&mut world, 2).is_empty());
    world.bodies[body].set_translation(vec(0.0, 9.0), true);
    let events = protocol.of_steps(&mut world, 2);
    assert_eq!(events.len(), 1, "what was reported to have begun is reported to have ended");
    assert!(events[0].stopped());
    between(&events[0], ground, collider);
}

#[test]
fn removal_is_flagged() {
    type Removal = fn(&mut PhysicsWorld, (RigidBodyHandle, ColliderHandle), ColliderHandle);
    let removals: [Removal; 3] = [
        |w, (body, _), _| drop(w.remove_body(body)),
        |w, (_, collider), _| drop(w.remove_collider(collider)),
        |w, _, ground| drop(w.remove_collider(ground)),
    ];
    for remove in removals {
        for sleeping in [false, true] {
            let (mut world, ground) = world_with_ground();
            let ours = add_box(&mut world, vec(0.0, 0.5), with_events);
            steps(&mut world, if sleeping { 200 } else { 2 });
            assert_eq!(world.bodies[ours.0].is_sleeping(), sleeping);
            let protocol = Protocol::default();
            remove(&mut world, ours, ground);
            let events = protocol.of_steps(&mut world, 3);
            assert_eq!(events.len(), 1, "{events:?}");
            assert!(events[0].stopped() && events[0].removed() && !events[0].sensor());
            between(&events[0], ground, ours.1);
        }
    }
}

/// Edits other than a removal end a contact without the flag `removed`.
#[test]
fn other_ends_are_not_flagged_as_removed() {
    type End = (&'static str, fn(&mut PhysicsWorld, RigidBodyHandle, ColliderHandle));
    let ends: [End; 7] = [
        ("leap", |w, body, _| w.bodies[body].set_translation(vec(0.0, 9.0), true)),
        ("disabled", |w, _, collider| w.colliders[collider].set_enabled(false)),
        ("disabled body", |w, body, _| w.bodies[body].set_enabled(false)),
        ("shrunk", |w, _, collider| w.colliders[collider].set_shape(SharedShape::ball(0.1))),
        ("other groups", |w, _, collider| {
            w.colliders[collider].set_collision_groups(InteractionGroups::none());
        }),
        ("fixed", |w, body, _| w.bodies[body].set_body_type(RigidBodyType::Fixed, true)),
        ("detached", |w, _, collider| w.colliders.set_parent(collider, None, &mut w.bodies)),
    ];
    for (name, end) in ends {
        for sleeping in [false, true] {
            let (mut world, ground) = world_with_ground();
            let (body, collider) = add_box(&mut world, vec(0.0, 0.5), with_events);
            steps(&mut world, if sleeping { 200 } else { 2 });
            let protocol = Protocol::default();
            end(&mut world, body, collider);
            let events = protocol.of_steps(&mut world, 1);
            assert_eq!(events, [CollisionEvent::Stopped(ground, collider, NONE)], "{name}");
        }
    }
}

#[test]
fn a_solid_that_becomes_a_sensor_stops_and_begins() {
    let (mut world, ground) = world_with_ground();
    let (_, collider) = add_box(&mut world, vec(0.0, 0.5), with_events);
    let protocol = Protocol::default();
    protocol.of_steps(&mut world, 2);
    world.colliders[collider].set_sensor(true);
    let sensor = CollisionEventFlags::SENSOR;
    let expected = [
        CollisionEvent::Stopped(ground, collider, NONE),
        CollisionEvent::Started(ground, collider, sensor),
    ];
    assert_eq!(protocol.of_steps(&mut world, 1), expected);
    world.colliders[collider].set_sensor(false);
    let expected = [
        CollisionEvent::Stopped(ground, collider, sensor),
        CollisionEvent::Started(ground, collider, NONE),
    ];
    assert_eq!(protocol.of_steps(&mut world, 1), expected);
}

/// Events of one step are in the order of the pairs. Pairs that begin at once are in the order of the
/// colliders.
#[test]
fn events_of_one_step_are_in_order() {
    let (mut world, ground) = world_with_ground();
    let boxes: Vec<_> = (0..5_u8)
        .map(|i| add_box(&mut world, vec(3.0 * Real::from(i), 0.7), with_events).1)
        .collect();
    let protocol = Protocol::default();
    let events = protocol.of_steps(&mut world, 40);
    let expected: Vec<_> =
        boxes.iter().map(|collider| CollisionEvent::Started(ground, *collider, NONE)).collect();
    assert_eq!(events, expected);
}

/// Returns all numbers below `count` once each, as multiples of a number without a common divisor.
fn shuffled(count: usize, by: usize) -> impl Iterator<Item = usize> {
    (0..count).map(move |k| k * by % count)
}

/// Builds boxes on pads, and moves or removes each fourth pad or makes it a sensor. Returns the following
/// events. The test compares sets of events without their order.
fn edited_pads(arrivals: impl Iterator<Item = usize>) -> Vec<CollisionEvent> {
    const COUNT: usize = 240;
    let mut world = PhysicsWorld::new();
    let at = |k: usize, height: Real| vec(3.0 * k as Real, height);
    let mut boxes = vec![None; COUNT];
    for k in shuffled(COUNT, 77) {
        let pad = cuboid(1.0, 0.5).translation(at(k, -0.5));
        let flier = RigidBodyBuilder::dynamic().translation(at(k, 9.0)).gravity_scale(0.0);
        // Some boxes are older than their pads.
        let late = (k % 3 != 0).then(|| world.insert_collider(pad.clone(), None));
        boxes[k] = Some(world.insert(flier, with_events(cuboid(0.5, 0.5))));
        late.unwrap_or_else(|| world.insert_collider(pad, None));
    }
    let boxes: Vec<_> = boxes.into_iter().flatten().collect();
    for k in arrivals.filter(|k| k % 4 != 0) {
        world.bodies[boxes[k].0].set_translation(at(k, 0.499), true);
        world.step();
    }
    for (k, &(body, collider)) in boxes.iter().enumerate() {
        match k % 4 {
            0 => world.bodies[body].set_translation(at(k, 0.499), true),
            1 => world.bodies[body].set_translation(at(k, 20.0), true),
            2 => drop(world.remove_body(body)),
            _ => world.colliders[collider].set_sensor(true),
        }
    }
    Protocol::default().of_steps(&mut world, 1)
}

/// Hundreds of simultaneous starts and ends with different causes are sent in the order of the colliders,
/// whatever the history. Events of one pair keep their order.
#[test]
fn events_of_one_step_are_in_the_order_of_colliders() {
    let events = edited_pads(0..240);
    assert_eq!(events.len(), 300, "60 begin, 120 end, and 60 end and begin");
    let pair = |event: &CollisionEvent| {
        [event.collider1(), event.collider2()].map(ColliderHandle::into_raw_parts)
    };
    assert!(events.is_sorted_by_key(pair));
    for two in events.windows(2).filter(|two| pair(&two[0]) == pair(&two[1])) {
        assert!(two[0].stopped() && two[1].started() && two[1].sensor(), "{two:?}");
    }
    assert_eq!(edited_pads((0..240).rev()), events);
    assert_eq!(edited_pads(shuffled(240, 131)), events);
}

/// Checks the arguments of a handler.
struct ArgumentChecker {
    ball: ColliderHandle,
}

impl EventHandler for ArgumentChecker {
    fn handle_collision_event(
        &self,
        bodies: &RigidBodySet,
        colliders: &ColliderSet,
        event: &CollisionEvent,
        pair: Option<&ContactPair>,
    ) {
        let body = colliders[self.ball].parent().expect("it has a body");
        assert!(bodies[body].translation().y < 0.7, "bodies are those at the end of the step");
        assert!(event.started());
        let pair = pair.expect("solid colliders have contacts");
        assert!(pair.has_any_active_contact);
        assert_eq!([pair.collider1, pair.collider2], [event.collider1(), event.collider2()]);
        assert!(pair.total_impulse_magnitude() > 0.0, "the hit is in the impulses of this step");
    }
}

#[test]
fn handlers_get_the_impulse_of_a_hit() {
    let (mut world, _) = world_with_ground();
    let (body, ball) = add_box(&mut world, vec(0.0, 1.5), with_events);
    world.bodies[body].set_linvel(vec(0.0, -6.0), true);
    for _ in 0..30 {
        world.step_with_events(&(), &ArgumentChecker { ball });
    }
    assert!(world.contact_pairs().any(|(_, _, pair)| pair.has_any_active_contact));
}

#[test]
fn a_collector_sends_the_events_of_a_handler() {
    let (send_collision, collisions) = channel();
    let (send_force, forces) = channel();
    let events = ChannelEventCollector::new(send_collision, send_force);
    let (mut world, ground) = world_with_ground();
    let (body, collider) = add_box(&mut world, vec(0.0, 0.55), with_events);
    for _ in 0..30 {
        world.step_with_events(&(), &events);
    }
    let begun: Vec<_> = collisions.try_iter().collect();
    assert_eq!(begun, [CollisionEvent::Started(ground, collider, NONE)]);
    assert!(forces.try_iter().count() > 10);
    world.remove_body(body);
    drop(forces); // The collector drops events of a closed channel.
    world.insert(RigidBodyBuilder::dynamic(), with_events(cuboid(0.5, 0.5)));
    world.step_with_events(&(), &events);
    assert_eq!(collisions.try_iter().count(), 2, "one ended, one began");
}
