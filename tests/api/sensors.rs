//! Intersections of sensors.

use super::stage::{
    Protocol, add_box, between, height, plain, steps, with_events, world_with_ground,
};
use crate::dim::{cuboid, vec};
use rapier::prelude::*;

#[test]
fn a_body_falls_through_a_sensor_that_detects_it() {
    let mut world = PhysicsWorld::new();
    let zone = cuboid(1.0, 1.0).sensor(true).active_events(ActiveEvents::COLLISION_EVENTS);
    let zone = world.insert_collider(zone, None);
    let (body, collider) = add_box(&mut world, vec(0.0, 3.0), plain);
    let protocol = Protocol::default();
    let mut seen = Vec::new();
    for _ in 0..120 {
        for event in protocol.of_steps(&mut world, 1) {
            between(&event, zone, collider);
            assert!(event.sensor() && !event.removed());
            seen.push((event.started(), height(&world, body)));
        }
    }
    let [(true, entry), (false, exit)] = seen[..] else { panic!("{seen:?}") };
    assert!((1.0..1.5).contains(&entry), "seen at {entry}");
    assert!((-2.0..-1.5).contains(&exit), "lost at {exit}");
    assert!(height(&world, body) < -10.0, "nothing held it up");
    assert!(world.intersection_pair(zone, collider).is_none(), "out of sight");
}

/// By default, sensors detect dynamic bodies and sensors on them. Detection of fixed bodies needs active
/// collision types.
#[test]
fn sensors_detect_the_active_collision_types() {
    use RigidBodyType::{Dynamic, Fixed, KinematicPositionBased as Kinematic};
    let default = ActiveCollisionTypes::default();
    let all = ActiveCollisionTypes::all();
    for (type1, type2, types, expected) in [
        (Fixed, Dynamic, default, true),
        (Dynamic, Dynamic, default, true),
        (Kinematic, Dynamic, default, true),
        (Fixed, Kinematic, default, false),
        (Fixed, Fixed, default, false),
        (Kinematic, Kinematic, default, false),
        (Fixed, Kinematic, all, true),
        (Fixed, Fixed, all, true),
        (Kinematic, Kinematic, all, true),
    ] {
        for other_is_sensor in [false, true] {
            let mut world = PhysicsWorld::new();
            world.gravity = Vector::ZERO;
            let sensor = with_events(cuboid(1.0, 1.0)).sensor(true).active_collision_types(types);
            let (_, sensor) = world.insert(RigidBodyBuilder::new(type1), sensor);
            let other = cuboid(0.5, 0.5).sensor(other_is_sensor);
            let (_, other) = world.insert(RigidBodyBuilder::new(type2), other);
            let protocol = Protocol::default();
            let events = protocol.of_steps(&mut world, 3);
            let name = format!("{type1:?} {type2:?} {types:?}");
            assert_eq!(events.len(), usize::from(expected), "{name}: {events:?}");
            let seen = world.intersection_pair(other, sensor) == Some(true);
            assert_eq!(seen, expected, "{name}");
            assert!(world.contact_pairs().next().is_none(), "{name}");
        }
    }
}

#[test]
fn sensors_add_mass_but_no_contacts() {
    let (mut world, ground) = world_with_ground();
    let (body, solid) = add_box(&mut world, vec(0.0, 0.5), plain);
    let mass = world.bodies[body].mass();
    let feeler = cuboid(0.5, 2.0).sensor(true).density(1.0);
    let feeler = world.insert_collider(feeler, Some(body));
    assert!(world.bodies[body].mass() > 2.0 * mass);
    steps(&mut world, 30);
    assert!(world.intersection_pair(feeler, ground) == Some(true));
    assert!(world.contact_pair(feeler, ground).is_none());
    assert!(world.contact_pair(solid, ground).is_some());
    assert!(world.intersection_pair(feeler, solid).is_none(), "they are of one body");
    assert_eq!(world.intersection_pairs_with(feeler).count(), 1);
    assert_eq!(world.intersection_pairs().count(), 1);
}

/// A body that falls asleep in a sensor stays in it. Its removal, or the sensor's, ends the intersection.
#[test]
fn a_sleeping_body_stays_detected() {
    let (mut world, _) = world_with_ground();
    let (body, collider) = add_box(&mut world, vec(0.0, 0.5), plain);
    let zone = with_events(cuboid(1.0, 1.0)).sensor(true);
    let zone = world.insert_collider(zone, None);
    let protocol = Protocol::default();
    let events = protocol.of_steps(&mut world, 200);
    assert!(world.bodies[body].is_sleeping());
    assert_eq!(events.len(), 1);
    assert_eq!(world.intersection_pair(zone, collider), Some(true));
    world.bodies[body].wake_up(true);
    assert!(protocol.of_steps(&mut world, 200).is_empty(), "waking is no event");

    world.colliders[zone].set_translation(vec(5.0, 0.0));
    let events = protocol.of_steps(&mut world, 1);
    assert_eq!(events, [CollisionEvent::Stopped(collider, zone, CollisionEventFlags::SENSOR)]);
    world.colliders[zone].set_translation(vec(0.0, 0.0));
    assert!(protocol.of_steps(&mut world, 1)[0].started(), "a zone that comes to a sleeper");
    world.remove_collider(zone);
    let events = protocol.of_steps(&mut world, 1);
    assert!(events.len() == 1 && events[0].removed() && events[0].sensor(), "{events:?}");
}
