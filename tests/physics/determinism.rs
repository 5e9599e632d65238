//! Equal worlds and equal calls give equal bits.

use super::stage::{add_ground, drop_pile, run, world};
use crate::dim::components;
use rapier::math::Real;
use rapier::prelude::*;

/// Returns the poses of these bodies, as figures and as bits.
fn poses(world: &PhysicsWorld, bodies: &[RigidBodyHandle]) -> Vec<String> {
    let of_body = |&body: &RigidBodyHandle| {
        let components = components(world.bodies[body].position());
        let text = components.iter().map(|c: &Real| format!("{c} ({:x})", c.to_bits()));
        text.collect::<Vec<_>>().join(", ")
    };
    bodies.iter().map(of_body).collect()
}

/// Fails with the first body whose pose differs, and the number of such bodies.
fn assert_same(poses1: &[String], poses2: &[String]) {
    assert_eq!(poses1.len(), poses2.len());
    let differing = || poses1.iter().zip(poses2).enumerate().filter(|(_, (a, b))| a != b);
    if let Some((body, (pose1, pose2))) = differing().next() {
        let count = differing().count();
        panic!("{count} differ, the first is body {body}:\n  {pose1}\n  {pose2}");
    }
}

/// Returns the poses of a pile of all shapes, three seconds after its fall.
fn pile(change: impl FnOnce(&mut PhysicsWorld)) -> Vec<String> {
    let mut world = world(60);
    add_ground(&mut world, 0.5);
    let bodies = drop_pile(&mut world, 0.0, 60);
    change(&mut world);
    run(&mut world, 3.0);
    poses(&world, &bodies)
}

#[test]
fn twice_the_same() {
    let first = pile(|_| ());
    assert_same(&first, &pile(|_| ()));
    assert!(first.iter().all(|pose| !pose.contains("NaN")));
}

/// A distant pile occupies lanes, slots and colours, but changes no bit of this one.
#[test]
fn far_neighbours_change_nothing() {
    let with_neighbour = pile(|world| drop(drop_pile(world, 50.0, 45)));
    assert_same(&pile(|_| ()), &with_neighbour);
}

/// The widest instructions of the machine give the bits of the baseline.
#[test]
fn wide_instructions_change_nothing() {
    let narrow = pile(|world| world.physics_pipeline.set_wide_instructions(false));
    assert_same(&pile(|_| ()), &narrow);
}

/// A step keeps no state outside the sets: a clone of the sets moves equally with a new pipeline and other
/// buffers.
#[test]
fn a_new_pipeline_changes_nothing() {
    let mut world = world(60);
    add_ground(&mut world, 0.5);
    let bodies = drop_pile(&mut world, 0.0, 60);
    run(&mut world, 1.0);
    world.physics_pipeline = PhysicsPipeline::new();
    run(&mut world, 2.0);
    assert_same(&poses(&world, &bodies), &pile(|_| ()));
}
