//! Records of one world put into another, where they know the same places but have other partners.

use super::scene::{at, cube, step};
use crate::rapier::prelude::*;

/// Two bodies, each with a collider.
fn pair() -> (PhysicsWorld, [RigidBodyHandle; 2], [ColliderHandle; 2]) {
    let mut world = PhysicsWorld::new();
    world.insert_collider(ColliderBuilder::halfspace(Vector::Y), None);
    let [(one, part1), (two, part2)] = [0.0, 3.0]
        .map(|x| world.insert(RigidBodyBuilder::dynamic().translation(at(x, 0.5)), cube(0.5)));
    (0..5).for_each(|_| world.step());
    (world, [one, two], [part1, part2])
}

/// Each collider is listed by the body that it names, and by no other.
fn check_attachments(world: &PhysicsWorld) {
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

/// The body of the twin stands at the same place of the same lists, but has the other one's collider besides.
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

/// The collider of the twin names another body.
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

/// The copy is older than the attachment, and both are of the time since the last step.
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
