//! Records of one world in another one, where their references point to the same slots but other objects.

use super::scene::{at, cube, step};
use crate::rapier::prelude::*;

/// Returns two bodies, each with a collider.
fn pair() -> (PhysicsWorld, [RigidBodyHandle; 2], [ColliderHandle; 2]) {
    let mut world = PhysicsWorld::new();
    world.insert_collider(ColliderBuilder::halfspace(Vector::Y), None);
    let [(one, part1), (two, part2)] = [0.0, 3.0]
        .map(|x| world.insert(RigidBodyBuilder::dynamic().translation(at(x, 0.5)), cube(0.5)));
    (0..5).for_each(|_| world.step());
    (world, [one, two], [part1, part2])
}

/// Checks that each collider is listed by its own body only.
pub fn check_attachments(world: &PhysicsWorld) {
    for (handle, body) in world.bodies.iter() {
        for part in body.colliders() {
            let parent = world.colliders.get(*part).and_then(Collider::parent);
            assert_eq!(parent, Some(handle), "{part:?} is listed by {handle:?}");
        }
    }
    for (part, collider) in world.colliders.iter() {
        let Some(parent) = collider.parent() else { continue };
        assert!(world.bodies[parent].colliders().contains(&part), "{part:?} of {parent:?}");
    }
}

/// The body of the twin has the same indices in the same lists, but has the other body's collider in
/// addition.
#[test]
fn a_body_of_a_twin_gets_the_colliders_of_its_place() {
    let ((mut one, bodies, parts), (mut two, ..)) = (pair(), pair());
    let PhysicsWorld { colliders, bodies: set, .. } = &mut two;
    colliders.set_parent(parts[0], Some(bodies[1]), set);
    one.bodies[bodies[1]] = two.bodies[bodies[1]].clone();
    step(&mut one);
    check_attachments(&one);
    assert_eq!(one.bodies[bodies[1]].colliders(), [parts[1]]);
    (0..10).for_each(|_| step(&mut one));
}

/// The collider of the twin belongs to another body.
#[test]
fn a_collider_of_a_twin_is_part_of_the_body_that_it_names() {
    let ((mut one, bodies, parts), (mut two, ..)) = (pair(), pair());
    let PhysicsWorld { colliders, bodies: set, .. } = &mut two;
    colliders.set_parent(parts[0], Some(bodies[1]), set);
    one.colliders[parts[0]] = two.colliders[parts[0]].clone();
    step(&mut one);
    check_attachments(&one);
    assert_eq!(one.bodies[bodies[0]].colliders(), []);
    (0..10).for_each(|_| step(&mut one));
}

/// The copy is older than the attachment, and both are newer than the last step.
#[test]
fn an_older_copy_of_a_body_gets_the_colliders_of_now() {
    let (mut world, bodies, parts) = pair();
    world.bodies[bodies[0]].wake_up(true);
    let old = world.bodies[bodies[0]].clone();
    let PhysicsWorld { colliders, bodies: set, .. } = &mut world;
    colliders.set_parent(parts[0], Some(bodies[1]), set);
    world.bodies[bodies[0]] = old;
    step(&mut world);
    check_attachments(&world);
    assert_eq!(world.bodies[bodies[0]].colliders(), []);
    (0..10).for_each(|_| step(&mut world));
}

/// Attaches the second collider to the first body, and sets the body back to an older copy.
fn world_with_older_body(steps: usize, is_edited: bool) -> (PhysicsWorld, RigidBodyHandle) {
    let (mut world, bodies, parts) = pair();
    let old = world.bodies[bodies[0]].clone();
    let PhysicsWorld { colliders, bodies: set, .. } = &mut world;
    colliders.set_parent(parts[1], Some(bodies[0]), set);
    (0..steps).for_each(|_| step(&mut world));
    world.bodies[bodies[0]] = old;
    if is_edited {
        world.bodies[bodies[0]].set_linvel(Vector::X, true);
    }
    (world, bodies[0])
}

/// The copy is older than the attachment, and precedes all edits: its list lacks a collider. The body is
/// removed before a step compares it with its own records.
#[test]
fn colliders_are_removed_with_a_body_that_an_older_copy_replaced() {
    for (steps, is_edited) in [(0, false), (0, true), (1, false), (1, true), (5, false)] {
        let (mut world, body) = world_with_older_body(steps, is_edited);
        world.remove_body(body).expect("it is there");
        step(&mut world);
        let attached = world.colliders.iter().filter(|(_, part)| part.parent().is_some()).count();
        println!("{steps} steps, edited: {is_edited}: {attached} colliders are left");
        assert_eq!(attached, 0, "the removed body had both colliders");
        check_attachments(&world);
        (0..10).for_each(|_| step(&mut world));
    }
}

/// The copy is older than the attachment to another body, and is removed: that body loses the collider.
#[test]
fn a_body_loses_a_collider_that_an_older_copy_replaced() {
    for is_edited in [false, true] {
        let (mut world, bodies, parts) = pair();
        let old = world.colliders[parts[0]].clone();
        let PhysicsWorld { colliders, bodies: set, .. } = &mut world;
        colliders.set_parent(parts[0], Some(bodies[1]), set);
        world.colliders[parts[0]] = old;
        if is_edited {
            world.colliders[parts[0]].set_friction(0.1);
        }
        world.remove_collider(parts[0]).expect("it is there");
        step(&mut world);
        check_attachments(&world);
        assert_eq!(world.bodies[bodies[1]].colliders(), [parts[1]], "edited: {is_edited}");
        (0..10).for_each(|_| step(&mut world));
    }
}
