//! Shortcuts of `PhysicsWorld`, and its counters.

use super::stage::{add_box, height, plain, steps, world_with_ground};
use crate::dim::vec;
use rapier::prelude::*;

#[test]
fn the_smallest_program_is_small() {
    let mut world = PhysicsWorld::new();
    world.insert_collider(ColliderBuilder::halfspace(Vector::Y), None);
    let ball = RigidBodyBuilder::dynamic().translation(vec(0.0, 3.0));
    let (ball, _) = world.insert(ball, ColliderBuilder::ball(0.5).restitution(0.5));
    for _ in 0..600 {
        world.step();
    }
    assert!((height(&world, ball) - 0.5).abs() < 0.01 && world.bodies[ball].is_sleeping());
}

#[test]
fn queries_of_the_world_equal_those_of_its_sets() {
    let (mut world, ground) = world_with_ground();
    let (body, collider) = add_box(&mut world, vec(0.0, 0.5), plain);
    let zone = ColliderBuilder::ball(1.0).sensor(true);
    let zone = world.insert_collider(zone, None);
    steps(&mut world, 3);
    assert_eq!(world.active_bodies(), world.islands.active_bodies());
    assert_eq!(world.active_bodies(), [body]);
    let pairs = world.contact_pairs().map(|(a, b, _)| (a, b)).collect::<Vec<_>>();
    assert_eq!(pairs, [(ground, collider)]);
    assert_eq!(world.intersection_pairs().collect::<Vec<_>>(), [(collider, zone, true)]);
    assert_eq!(world.intersection_pair(zone, collider), Some(true));
    assert_eq!(world.intersection_pairs_with(zone).count(), 1);
    assert_eq!(world.contact_pairs_with(ground).count(), 1);
    let body_without_collider = world.insert_body(RigidBodyBuilder::fixed());
    let attached = world.insert_collider(ColliderBuilder::ball(0.1), Some(body_without_collider));
    assert_eq!(world.bodies[body_without_collider].colliders(), [attached]);
}

#[test]
fn the_world_wakes_one_body_or_all() {
    let (mut world, _) = world_with_ground();
    let (near, _) = add_box(&mut world, vec(0.0, 0.5), plain);
    let (above, _) = add_box(&mut world, vec(0.0, 1.5), plain);
    let (far, _) = add_box(&mut world, vec(9.0, 0.5), plain);
    let awake = |world: &PhysicsWorld| [near, above, far].map(|b| !world.bodies[b].is_sleeping());
    steps(&mut world, 200);
    assert_eq!(awake(&world), [false; 3]);
    world.wake_up(near, true);
    steps(&mut world, 1);
    assert_eq!(awake(&world), [true, true, false], "what it touches wakes with it");
    steps(&mut world, 200);
    world.wake_up_all(true);
    steps(&mut world, 1);
    assert_eq!(awake(&world), [true; 3]);
}

/// A removed body is returned without its colliders, and can be inserted again.
#[test]
fn removed_bodies_can_be_inserted_again() {
    let (mut world, ground) = world_with_ground();
    let (body, collider) = add_box(&mut world, vec(0.0, 0.5), plain);
    steps(&mut world, 10);
    let removed = world.remove_body(body).expect("it is there");
    assert!(removed.colliders().is_empty() && removed.mass() == 0.0);
    steps(&mut world, 1);
    assert!(!world.colliders.contains(collider), "its colliders go with it");
    let again = world.insert_body(removed);
    assert!(again != body && !world.bodies.contains(body));
    let removed = world.remove_collider(ground).expect("it is there");
    let again = world.insert_collider(removed, Some(again));
    steps(&mut world, 10);
    assert!(world.colliders[again].parent().is_some());
}

#[test]
fn a_pipeline_belongs_to_no_world() {
    let (mut first, _) = world_with_ground();
    let (mut second, _) = world_with_ground();
    let (a, _) = add_box(&mut first, vec(0.0, 3.0), plain);
    let (b, _) = add_box(&mut second, vec(0.0, 3.0), plain);
    for _ in 0..60 {
        first.step();
        std::mem::swap(&mut first.physics_pipeline, &mut second.physics_pipeline);
        second.step();
    }
    assert_eq!(first.bodies[a].position(), second.bodies[b].position());
}

#[test]
fn counters_count_and_measure_on_request() {
    let (mut world, _) = world_with_ground();
    add_box(&mut world, vec(0.0, 0.5), plain);
    assert!(!world.physics_pipeline.counters.enabled(), "a clock takes longer than a small step");
    world.physics_pipeline.counters.enable();
    steps(&mut world, 2);
    let counters = &world.physics_pipeline.counters;
    assert!(counters.enabled() && counters.step_time_ms() > 0.0);
    let stages = counters.user_changes_time_ms()
        + counters.collision_detection_time_ms()
        + counters.island_construction_time_ms()
        + counters.solver_time_ms()
        + counters.update_time_ms();
    assert!(stages > 0.0 && stages <= counters.step_time_ms() * 1.01);
    let cd = counters.broad_phase_time_ms() + counters.narrow_phase_time_ms();
    assert!(cd <= counters.collision_detection_time_ms() * 1.01);
    assert_eq!(counters.cd.ncontact_pairs, 1);
    assert_eq!(counters.solver.nconstraints, 1);
    assert!((2..=4).contains(&counters.solver.ncontacts), "{}", counters.solver.ncontacts);

    world.physics_pipeline.counters.disable();
    steps(&mut world, 1);
    let counters = &world.physics_pipeline.counters;
    assert!(!counters.enabled() && counters.step_time_ms() == 0.0);
    assert_eq!(counters.solver.nconstraints, 1, "numbers are counted without timers");
    world.physics_pipeline.counters.enable();
    steps(&mut world, 200);
    let counters = &world.physics_pipeline.counters;
    assert_eq!(counters.solver.nconstraints, 0, "sleeping bodies have no constraints");
    assert!(counters.step_time_ms() > 0.0);
}

#[test]
fn iteration_is_in_the_order_of_the_slots() {
    let mut world = PhysicsWorld::new();
    let handles: Vec<_> = (0..5).map(|_| world.insert_body(RigidBodyBuilder::dynamic())).collect();
    world.remove_body(handles[2]);
    let order: Vec<_> = world.bodies.iter().map(|(handle, _)| handle).collect();
    assert_eq!(order, [handles[0], handles[1], handles[3], handles[4]]);
    let reversed: Vec<_> = world.bodies.iter_mut().rev().map(|(handle, _)| handle).collect();
    assert_eq!(reversed.into_iter().rev().collect::<Vec<_>>(), order);
    let (_, found) = world.bodies.get_unknown_gen(4).expect("a body stands there");
    assert_eq!(found, handles[4]);
    assert!(world.bodies.get_unknown_gen(2).is_none());
}
