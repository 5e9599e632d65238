//! "Thousands of static cuboids make it slow, and it never gives back what it takes."

use crate::dim::{cuboid, vec};
use crate::suite::physics::stage::{run, world};
use rapier::prelude::*;

/// Touching fixed colliders have no pairs: a step visits only the pairs of moving colliders.
#[test]
fn fixed_colliders_make_no_pairs() {
    let mut world = world(60);
    for k in 0..4000_u16 {
        let place = vec(Real::from(k % 200), -0.5 - Real::from(k / 200));
        world.insert_collider(cuboid(0.5, 0.5).translation(place), None);
    }
    world.step();
    assert_eq!(world.physics_pipeline.counters.cd.ncontact_pairs, 0);
    let ball = RigidBodyBuilder::dynamic().translation(vec(100.2, 0.5));
    world.insert(ball, ColliderBuilder::ball(0.5));
    run(&mut world, 1.0);
    // A ball with a radius of half a metre reaches at most three cubes of one metre in each direction.
    let pairs = world.physics_pipeline.counters.cd.ncontact_pairs;
    assert!((1..=9).contains(&pairs), "{pairs} pairs");
}

/// Slots of removed objects are reused, without any state of the old objects.
#[test]
fn new_bodies_reuse_free_slots() {
    let mut world = world(60);
    world.insert_collider(ColliderBuilder::halfspace(Vector::Y), None);
    let mut living = std::collections::VecDeque::new();
    for round in 0..400_u16 {
        let place = vec(Real::from(round % 7) * 0.3, 0.5);
        let body = RigidBodyBuilder::dynamic().translation(place);
        let (body, collider) = world.insert(body, cuboid(0.5, 0.5));
        living.push_back((body, collider));
        world.step();
        if living.len() > 12 {
            let (oldest, _) = living.pop_front().expect("thirteen");
            world.remove_body(oldest);
        }
        let (slot, _) = body.into_raw_parts();
        let (collider_slot, _) = collider.into_raw_parts();
        // There are at most thirteen bodies at once, plus the ground and a collider that is removed in the
        // next step.
        assert!(slot < 13 && collider_slot < 15, "slots {slot} and {collider_slot}");
    }
    for (body, _) in living {
        world.remove_body(body);
    }
    world.step();
    assert_eq!((world.bodies.len(), world.colliders.len()), (0, 1));
    assert_eq!(world.contact_pairs().count(), 0);
}
