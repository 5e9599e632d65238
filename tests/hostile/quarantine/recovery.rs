//! Return from quarantine, and its events.

use super::super::listener::listen;
use super::stage::Stage;
use crate::dim::{cuboid, vec};
use rapier::prelude::*;
use std::sync::mpsc::channel;

#[test]
fn a_repaired_body_returns() {
    let mut stage = Stage::new();
    let at = *stage.suspect().position();
    stage.suspect().add_force(Vector::X * 1.0e30, true);
    let (events, heard) = listen(|| stage.step());
    assert_eq!(events.quarantines.len(), 1);
    assert!(heard.iter().any(|text| text.contains("disabled")), "{heard:?}");
    for _ in 0..10 {
        assert_eq!(stage.step().quarantines, [], "it is reported once");
        assert_eq!((*stage.suspect().position(), stage.suspect().is_enabled()), (at, false));
    }
    assert!(stage.suspect().quarantine().is_some());
    stage.suspect().reset_forces(true);
    stage.suspect().set_enabled(true);
    assert_eq!(stage.suspect().quarantine(), None);
    for _ in 0..60 {
        assert_eq!(stage.step().quarantines, []);
    }
    assert!(*stage.suspect().position() != at, "it moves again");
}

#[test]
fn a_body_without_repair_is_disabled_again() {
    let mut stage = Stage::new();
    stage.suspect().add_force(Vector::X * 1.0e30, true);
    for _ in 0..3 {
        let events = stage.step().quarantines;
        let [event] = events[..] else { panic!("{events:?}") };
        assert_eq!(event.body(), Some(stage.suspect));
        assert!(matches!(event.cause(), QuarantineCause::Force { .. }));
        stage.suspect().set_enabled(true);
    }
}

/// Failure that no setter can predict: only the step computes the mass of a grain of dust.
#[test]
fn an_unpredictable_failure() {
    let mut world = PhysicsWorld::new();
    world.insert_collider(ColliderBuilder::halfspace(Vector::Y), None);
    let balls = [0_u8, 1, 2].map(|k| {
        let body = RigidBodyBuilder::dynamic().translation(vec(0.5 * Real::from(k), 0.5));
        let radius = if k == 1 { 1.0e-6 } else { 0.5 };
        let ball = ColliderBuilder::ball(radius).active_events(ActiveEvents::COLLISION_EVENTS);
        world.insert(body, ball).0
    });
    world.bodies[balls[1]].add_force(Vector::Y * 2.0e7, true);
    let (send_collision, collisions) = channel();
    let (send_force, _forces) = channel();
    let (send, quarantines) = channel();
    let events = ChannelEventCollector::new(send_collision, send_force);
    let events = events.with_quarantine_events(send);
    for _ in 0..60 {
        world.step_with_events(&(), &events);
        super::super::world::check(&world);
    }
    let events: Vec<_> = quarantines.try_iter().collect();
    let [event] = events[..] else { panic!("{events:?}") };
    assert_eq!(event.body(), Some(balls[1]));
    let events: Vec<_> = collisions.try_iter().collect();
    let dust = world.bodies[balls[1]].colliders()[0];
    assert!(
        !events.is_empty()
            && !events.iter().any(|event| event.collider1() == dust || event.collider2() == dust)
    );
    for ball in [balls[0], balls[2]] {
        let body = &world.bodies[ball];
        assert!(body.is_enabled() && (body.translation().y - 0.5).abs() < 0.05);
    }
}

/// A sensor that a body crosses within a step sends its start and end events in that step, independent of
/// disabled bodies.
#[test]
fn crossed_sensors_still_send_events() {
    for force in [0.0, 1.0e30] {
        let mut stage = Stage::new();
        let gate = cuboid(0.01, 2.0).translation(vec(0.0, 80.0));
        let gate = gate.sensor(true).active_events(ActiveEvents::COLLISION_EVENTS);
        stage.world.insert_collider(gate, None);
        let flyer = RigidBodyBuilder::dynamic().translation(vec(-2.0, 80.0));
        // The ball moves four metres in this step, half of them in front of the gate.
        stage.world.insert(flyer.linvel(vec(240.0, 0.0)), ColliderBuilder::ball(0.1));
        stage.suspect().add_force(Vector::X * force, true);
        let events = stage.step();
        assert_eq!(events.quarantines.len(), usize::from(force > 0.0));
        let passed = events.collisions.iter().filter(|event| event.sensor());
        assert_eq!(passed.map(|event| event.started()).collect::<Vec<_>>(), [true, false]);
    }
}

/// Disabling by the user is not quarantine.
#[test]
fn disabled_by_the_user() {
    let mut stage = Stage::new();
    stage.suspect().set_enabled(false);
    stage.step();
    assert_eq!(stage.suspect().quarantine(), None);
}
