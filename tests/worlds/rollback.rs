//! Worlds that are saved in memory and restored in place.

use super::scene::{at, cube, step, world};
use crate::rapier::prelude::*;
use allocation_counter::measure;

fn hashes(world: &mut PhysicsWorld, steps: usize) -> Vec<u64> {
    let mut run = || {
        step(world);
        world.hash()
    };
    (0..steps).map(|_| run()).collect()
}

#[test]
fn a_world_that_returns_repeats_its_steps() {
    for before in [0, 1, 12, 60] {
        let mut world = world();
        (0..before).for_each(|_| step(&mut world));
        let saved = world.clone();
        let first = hashes(&mut world, 30);
        world.clone_from(&saved);
        assert_eq!(first, hashes(&mut world, 30), "saved after {before} steps");
    }
}

/// Bodies are inserted and removed between saving and returning, and the target may be any world.
#[test]
fn a_world_returns_from_any_state() {
    let mut original = world();
    (0..20).for_each(|_| step(&mut original));
    let saved = original.clone();
    let expected = hashes(&mut original, 20);

    let mut edited = saved.clone();
    let handles: Vec<_> = edited.bodies.iter().map(|(handle, _)| handle).collect();
    for handle in handles.iter().step_by(2) {
        edited.remove_body(*handle);
    }
    for k in 0..40 {
        edited.insert(RigidBodyBuilder::dynamic().translation(at(0.0, k as Real)), cube(0.4));
    }
    (0..5).for_each(|_| step(&mut edited));
    let joints: Vec<_> = edited.impulse_joints().map(|(handle, _)| handle).collect();
    for joint in joints {
        edited.remove_impulse_joint(joint);
    }
    for mut target in [edited, PhysicsWorld::new(), world()] {
        target.clone_from(&saved);
        assert_eq!(hashes(&mut target, 20), expected);
    }
}

/// Queries after the return use the restored world.
#[test]
fn queries_use_the_restored_world() {
    let mut world = PhysicsWorld::new();
    let (body, _) = world.insert(RigidBodyBuilder::dynamic().linvel(Vector::X), cube(0.5));
    world.gravity = Vector::ZERO;
    world.step();
    let saved = world.clone();
    let ray = Ray::new(at(0.0, 5.0), -Vector::Y);
    let hits =
        |world: &PhysicsWorld| world.cast_ray(&ray, 100.0, true, QueryFilter::default()).is_some();
    assert!(hits(&world));
    world.bodies[body].set_translation(at(50.0, 0.0), true);
    (0..3).for_each(|_| world.step());
    assert!(!hits(&world));
    world.clone_from(&saved);
    assert!(hits(&world));
}

/// The world is saved and restored in every step, like a game with rollback.
#[test]
fn saving_and_returning_allocate_nothing() {
    let mut world = world();
    let compound = RigidBodyBuilder::dynamic().translation(at(30.0, 5.0));
    let body = world.insert_body(compound);
    for k in 0..6 {
        world.insert_collider(cube(0.3).translation(at(k as Real * 0.5, 0.0)), Some(body));
    }
    (0..60).for_each(|_| step(&mut world));
    let mut saved = world.clone();
    (0..10).for_each(|_| step(&mut world));
    saved.clone_from(&world);
    (0..10).for_each(|_| step(&mut world));
    let allocations = measure(|| {
        for _ in 0..10 {
            world.clone_from(&saved);
            saved.clone_from(&world);
        }
    });
    assert_eq!(allocations.count_total, 0);
}
