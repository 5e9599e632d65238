//! Collision detection without a simulation.

use super::stage::{Protocol, add_box, between, plain, steps, with_events, world_with_ground};
use crate::dim::vec;
use rapier::prelude::*;

/// Detects collisions with a separate pipeline. `applies_edits` applies edits.
pub fn detect(
    world: &mut PhysicsWorld,
    applies_edits: bool,
    hooks: &dyn PhysicsHooks,
    events: &dyn EventHandler,
) {
    let mut pipeline = CollisionPipeline::new();
    pipeline.counters.enable();
    pipeline.step(
        &world.integration_parameters,
        &mut world.islands,
        &mut world.broad_phase,
        &mut world.narrow_phase,
        &mut world.bodies,
        &mut world.colliders,
        &world.impulse_joints,
        &world.multibody_joints,
        hooks,
        events,
        applies_edits,
    );
    assert!(pipeline.counters.step_time_ms() >= pipeline.counters.solver_time_ms());
    assert_eq!(pipeline.counters.solver_time_ms(), 0.0);
}

#[test]
fn detection_finds_contacts_and_moves_nothing() {
    let (mut world, ground) = world_with_ground();
    let (body, collider) = add_box(&mut world, vec(0.0, 0.4), with_events);
    world.bodies[body].set_linvel(vec(1.0, 2.0), true);
    let before = *world.bodies[body].position();
    let protocol = Protocol::default();
    for _ in 0..10 {
        detect(&mut world, true, &(), &protocol);
        let pair = world.contact_pair(ground, collider).expect("they overlap");
        let (_, _, depth) = pair.find_deepest_contact().expect("they overlap");
        assert!((depth - 0.1).abs() < 1.0e-4, "{depth}");
        for manifold in &pair.manifolds {
            for contact in &manifold.data {
                assert_eq!(contact.impulse, 0.0);
            }
        }
    }
    let body = &world.bodies[body];
    assert_eq!((body.position(), body.linvel()), (&before, vec(1.0, 2.0)));
    let events = protocol.collisions();
    assert_eq!(events.len(), 1, "{events:?}");
    between(&events[0], ground, collider);
    assert!(protocol.forces().is_empty());
}

#[test]
fn detection_uses_edits_that_it_applies() {
    let (mut world, ground) = world_with_ground();
    let (body, collider) = add_box(&mut world, vec(0.0, 5.0), with_events);
    let protocol = Protocol::default();
    detect(&mut world, true, &(), &protocol);
    world.bodies[body].set_translation(vec(0.0, 0.4), true);
    let late = world.insert_collider(ColliderBuilder::ball(0.5), None);
    detect(&mut world, false, &(), &protocol);
    assert!(protocol.collisions().is_empty(), "the edit is not applied yet");
    assert!(world.contact_pair(collider, late).is_none());
    detect(&mut world, true, &(), &protocol);
    let events = protocol.collisions();
    assert_eq!(events.len(), 2, "{events:?}");
    assert!(world.contact_pair(collider, late).is_some());
    assert!(world.contact_pair(collider, ground).is_some());
}

#[test]
fn detection_survives_removals_that_it_does_not_apply() {
    let (mut world, ground) = world_with_ground();
    let (body, collider) = add_box(&mut world, vec(0.0, 0.5), with_events);
    let (other, _) = add_box(&mut world, vec(0.0, 1.5), with_events);
    let protocol = Protocol::default();
    steps(&mut world, 5);
    world.remove_body(body);
    for _ in 0..3 {
        detect(&mut world, false, &(), &protocol);
    }
    let (next, _) = add_box(&mut world, vec(0.0, 0.5), with_events);
    assert_eq!(next.into_raw_parts().0, body.into_raw_parts().0, "the slot is used again");
    world.remove_collider(ground);
    detect(&mut world, false, &(), &protocol);
    detect(&mut world, true, &(), &protocol);
    assert!(world.colliders.get(collider).is_none());
    steps(&mut world, 30);
    assert!(world.bodies[other].translation().y < world.bodies[next].translation().y + 1.1);
    assert!(world.bodies[next].translation().y < 0.0, "nothing holds it any more");
}

/// Collision detections between the steps of a simulation do not change the result.
#[test]
fn detection_changes_nothing() {
    let pile = || {
        let (mut world, _) = world_with_ground();
        for i in 0..5_u8 {
            let i = Real::from(i);
            add_box(&mut world, vec(0.2 * i, 0.6 + 1.1 * i), plain);
        }
        world
    };
    let (mut looked_at, mut left_alone) = (pile(), pile());
    for _ in 0..60 {
        looked_at.step();
        left_alone.step();
        for _ in 0..2 {
            looked_at.detect_collisions(&(), &());
        }
    }
    for ((_, a), (_, b)) in looked_at.bodies.iter().zip(left_alone.bodies.iter()) {
        assert_eq!((a.position(), a.linvel()), (b.position(), b.linvel()));
    }
}
