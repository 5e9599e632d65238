//! Records put in the place of others: `set[a] = set[b].clone()`, and two of them swapped.
//!
//! A body or collider in hand is a `&mut`, and whatever is assigned to it brings along what it knew of *its* place: its
//! body, its colliders, where it stood in the lists of the step.

use super::scene::Scene;
use crate::dim::{cuboid, vec};
use rapier::prelude::*;

/// A collider with the shape and the body of its neighbour's stands there twice: once in each place.
#[test]
fn a_collider_that_is_assigned_belongs_to_the_body_that_it_names() {
    let mut scene = Scene::new();
    let other = scene.world.bodies[scene.neighbours[1]].colliders()[0];
    let copy = scene.world.colliders[other].clone();
    scene.world.colliders[scene.collider] = copy;
    scene.steps(2);
    assert!(scene.world.bodies[scene.body].colliders().is_empty());
    let mut parts = scene.world.bodies[scene.neighbours[1]].colliders().to_vec();
    parts.sort_unstable();
    let mut expected = [other, scene.collider];
    expected.sort_unstable();
    assert_eq!(parts, expected);
    let mass = scene.world.bodies[scene.neighbours[1]].mass();
    let part = scene.world.colliders[other].mass();
    assert!((mass - 2.0 * part).abs() < 1.0e-5 * mass, "two parts of {part} weigh {mass}");
}

/// The same just before it is attached elsewhere, or removed: nobody keeps it in a list.
#[test]
fn a_collider_that_was_assigned_can_be_moved_and_removed() {
    for removes in [false, true] {
        let mut scene = Scene::new();
        let copy = scene.world.colliders[scene.ground].clone();
        scene.world.colliders[scene.collider] = copy;
        if removes {
            scene.world.remove_collider(scene.collider);
        } else {
            let PhysicsWorld { colliders, bodies, .. } = &mut scene.world;
            colliders.set_parent(scene.collider, Some(scene.neighbours[0]), bodies);
        }
        assert!(scene.world.bodies[scene.body].colliders().is_empty(), "it is gone from here");
        scene.steps(3);
        let expected = if removes { 1 } else { 2 };
        assert_eq!(scene.world.bodies[scene.neighbours[0]].colliders().len(), expected);
    }
}

/// Two colliders that change places change bodies: each goes on with the one that it names.
#[test]
fn colliders_that_are_swapped_stay_with_their_bodies() {
    let mut scene = Scene::new();
    let below = scene.world.bodies[scene.neighbours[0]].colliders()[0];
    if let (Some(one), Some(two)) = scene.world.colliders.get_pair_mut(scene.collider, below) {
        core::mem::swap(one, two);
    }
    scene.steps(2);
    assert_eq!(scene.world.bodies[scene.body].colliders(), [below]);
    assert_eq!(scene.world.bodies[scene.neighbours[0]].colliders(), [scene.collider]);
}

/// A fixed body stands in no list of the step: nothing but its slot says that another one was put in its place.
#[test]
fn fixed_bodies_that_are_swapped_keep_the_colliders_of_their_places() {
    let mut world = PhysicsWorld::new();
    let bare = world.insert_body(RigidBodyBuilder::fixed());
    let (clad, collider) = world.insert(RigidBodyBuilder::fixed(), cuboid(0.5, 0.5));
    world.step();
    for _ in 0..2 {
        if let (Some(one), Some(two)) = world.bodies.get_pair_mut(bare, clad) {
            core::mem::swap(one, two);
            // Attaching it where it is already, as far as the record in this place knows.
            let PhysicsWorld { colliders, bodies, .. } = &mut world;
            colliders.set_parent(collider, Some(bare), bodies);
            colliders.set_parent(collider, Some(clad), bodies);
        }
        world.step();
        assert!(world.bodies[bare].colliders().is_empty());
        assert_eq!(world.bodies[clad].colliders(), [collider]);
    }
}

/// A body that is set back to an older copy of itself takes its colliders along, though the copy knows of no change.
#[test]
fn a_body_that_is_set_back_takes_its_colliders_along() {
    let mut world = PhysicsWorld::new();
    let body = RigidBodyBuilder::fixed().translation(vec(1.0, 2.0));
    let (body, collider) = world.insert(body, cuboid(0.5, 0.5));
    world.step();
    let old = world.bodies[body].clone();
    world.bodies[body].set_translation(vec(5.0, 5.0), true);
    world.step();
    world.bodies[body] = old;
    world.step();
    assert_eq!(world.colliders[collider].translation(), vec(1.0, 2.0));
}

/// A joint of a multibody between a body and the one that stood in its slot before.
#[test]
fn a_multibody_of_a_body_and_its_predecessor_is_none() {
    let mut world = PhysicsWorld::new();
    let gone = world.insert_body(RigidBodyBuilder::dynamic());
    world.remove_body(gone);
    let body = world.insert_body(RigidBodyBuilder::dynamic());
    assert_eq!(gone.into_raw_parts().0, body.into_raw_parts().0, "the slot is used again");
    for [parent, child] in [[gone, body], [body, gone]] {
        world.insert_multibody_joint(parent, child, FixedJointBuilder::new());
        world.step();
        super::world::check(&world);
        assert!(world.multibody_joints.is_empty());
    }
}
