//! Reading contacts.

use super::stage::{add_box, close, plain, steps, world_with_ground};
use crate::dim::vec;
use rapier::prelude::*;

const G: Real = 9.81;

/// Returns two overlapping balls, after collision detection without a step.
fn two_balls(distance: Real) -> (PhysicsWorld, ColliderHandle, ColliderHandle) {
    let mut world = PhysicsWorld::new();
    let (_, a) = world.insert(RigidBodyBuilder::dynamic(), ColliderBuilder::ball(0.5));
    let right = RigidBodyBuilder::dynamic().translation(vec(distance, 0.0));
    let (_, b) = world.insert(right, ColliderBuilder::ball(0.5));
    world.detect_collisions(&(), &());
    (world, a, b)
}

#[test]
fn the_deepest_contact_points_from_the_first_to_the_second() {
    let (world, a, b) = two_balls(0.8);
    let pair = world.contact_pair(a, b).expect("they overlap");
    assert_eq!((pair.collider1, pair.collider2), (a, b));
    let (normal, point, depth) = pair.find_deepest_contact().expect("they overlap");
    assert!(normal.abs_diff_eq(Vector::X, 1.0e-5), "{normal}");
    assert!(point.abs_diff_eq(vec(0.4, 0.0), 1.0e-5), "{point}");
    close(depth, 0.2, 1.0e-5);
    let manifold = &pair.manifolds[0];
    let deepest = manifold.find_deepest_contact().expect("there is a point");
    close(deepest.dist, -0.2, 1.0e-5);
    assert!(deepest.local_p1.abs_diff_eq(vec(0.5, 0.0), 1.0e-5));
    assert!(deepest.local_p2.abs_diff_eq(vec(-0.5, 0.0), 1.0e-5));
    assert!(manifold.local_n1.abs_diff_eq(-manifold.local_n2, 1.0e-5));
}

/// Near colliders have a contact of negative depth, distant ones none.
#[test]
fn depth_is_negative_where_nothing_overlaps() {
    let (world, a, b) = two_balls(1.01);
    let (_, _, depth) =
        world.contact_pair(a, b).and_then(ContactPair::find_deepest_contact).expect("near");
    close(depth, -0.01, 1.0e-5);
    let (world, a, b) = two_balls(1.05);
    let touch = world.contact_pair(a, b).is_some_and(|pair| pair.has_any_active_contact);
    assert!(!touch);
    let (world, a, b) = two_balls(10.0);
    assert!(world.contact_pair(a, b).is_none());
}

#[test]
fn a_pair_is_found_in_either_order_and_from_either_side() {
    let (world, a, b) = two_balls(0.8);
    let of = |pair: Option<&ContactPair>| pair.map(|pair| (pair.collider1, pair.collider2));
    assert_eq!(of(world.contact_pair(a, b)), Some((a, b)));
    assert_eq!(of(world.contact_pair(b, a)), Some((a, b)));
    assert!(world.contact_pair(a, a).is_none());
    for collider in [a, b] {
        let pairs: Vec<_> = world.contact_pairs_with(collider).map(|p| of(Some(p))).collect();
        assert_eq!(pairs, [Some((a, b))]);
    }
    let all: Vec<_> = world.contact_pairs().map(|(a, b, _)| (a, b)).collect();
    assert_eq!(all, [(a, b)]);
    let narrow_phase = &world.narrow_phase;
    assert_eq!(of(narrow_phase.contact_pair(b, a)), Some((a, b)));
    assert_eq!(narrow_phase.contact_pairs().count(), 1);
    assert_eq!(narrow_phase.contact_pairs_with(a).count(), 1);
    assert_eq!(narrow_phase.intersection_pairs().count(), 0);
}

/// After a step, contact impulses are those of the step: the impulse under a box is its weight times the
/// step.
#[test]
fn impulses_carry_the_weight() {
    for model in [FrictionModel::Standard, FrictionModel::Coulomb] {
        let (mut world, ground) = world_with_ground();
        world.integration_parameters.friction_model = model;
        let (body, collider) = add_box(&mut world, vec(0.0, 0.5), plain);
        *world.bodies[body].activation_mut() = RigidBodyActivation::cannot_sleep();
        steps(&mut world, 120);
        let expected = world.bodies[body].mass() * G * world.integration_parameters.dt;
        let pair = world.contact_pair(ground, collider).expect("it lies there");
        close(pair.total_impulse_magnitude(), expected, 1.0e-3 * expected);
        close(pair.total_impulse().y, expected, 1.0e-3 * expected);
        let mut sum = 0.0;
        for manifold in &pair.manifolds {
            assert!(manifold.data.normal.abs_diff_eq(Vector::Y, 1.0e-4));
            assert_eq!(manifold.data.num_active_contacts(), manifold.contacts().len());
            for contact in &manifold.data {
                assert!(contact.impulse >= 0.0);
                sum += contact.impulse;
            }
        }
        close(sum, expected, 1.0e-3 * expected);
        let (largest, direction) = pair.max_impulse();
        assert!(largest <= sum && direction.abs_diff_eq(Vector::Y, 1.0e-4));
    }
}

/// Each contact of a stack carries the weight of all boxes above it.
#[test]
fn impulses_of_a_stack_add_up() {
    let (mut world, ground) = world_with_ground();
    let mut below = ground;
    let mut contacts = Vec::new();
    for i in 0..5_u8 {
        let (body, collider) = add_box(&mut world, vec(0.0, 0.5 + Real::from(i)), plain);
        *world.bodies[body].activation_mut() = RigidBodyActivation::cannot_sleep();
        contacts.push((below, collider));
        below = collider;
    }
    steps(&mut world, 400);
    let weight = world.bodies.iter().next().map_or(0.0, |(_, body)| body.mass()) * G;
    for (i, (below, above)) in contacts.into_iter().enumerate() {
        let pair = world.contact_pair(below, above).expect("they touch");
        let expected = (5 - i) as Real * weight * world.integration_parameters.dt;
        close(pair.total_impulse_magnitude(), expected, 0.01 * expected);
    }
}

/// A sleeping pile keeps its contacts, and they can be read.
#[test]
fn contacts_of_sleeping_bodies_can_be_read() {
    let (mut world, ground) = world_with_ground();
    let (body, collider) = add_box(&mut world, vec(0.0, 0.5), plain);
    steps(&mut world, 200);
    assert!(world.bodies[body].is_sleeping());
    let pair = world.contact_pair(ground, collider).expect("it lies there");
    assert!(pair.has_any_active_contact);
    assert!(pair.find_deepest_contact().is_some());
}
