//! Removal of bodies with the arguments of Rapier.

use super::world::World;
use rapier::prelude::*;

fn remove(world: &mut World, body: RigidBodyHandle, with_colliders: bool) -> Option<RigidBody> {
    world.bodies.remove(
        body,
        &mut world.islands,
        &mut world.colliders,
        &mut world.impulse_joints,
        &mut world.multibody_joints,
        #[cfg(rapier036)]
        &mut world.soft_bodies,
        with_colliders,
    )
}

/// Colliders and joints are gone before the next step.
#[test]
fn colliders_and_joints_go_at_once() {
    let (mut world, body, [_, collider]) = World::box_on_ground();
    let other = world.bodies.insert(RigidBodyBuilder::dynamic());
    world.impulse_joints.insert(body, other, FixedJointBuilder::new(), true);
    world.steps(2);
    assert!(remove(&mut world, body, true).is_some());
    assert!(!world.bodies.contains(body) && !world.colliders.contains(collider));
    assert!(world.impulse_joints.is_empty());
    assert!(remove(&mut world, body, true).is_none());
    world.steps(2);
    assert_eq!(world.bodies.len(), 1);
}

/// Colliders that stay have no body, and stay where they are.
#[test]
fn colliders_may_stay() {
    let (mut world, body, [_, collider]) = World::box_on_ground();
    world.steps(2);
    let before = world.colliders[collider].translation();
    remove(&mut world, body, false);
    assert_eq!(world.colliders[collider].parent(), None);
    world.steps(2);
    assert_eq!(world.colliders[collider].translation(), before);
}

/// Links of a multibody lose their joints.
#[test]
fn multibodies_lose_their_links() {
    let mut world = World::default();
    let bodies: Vec<_> = (0..3)
        .map(|x| {
            let body = RigidBodyBuilder::dynamic().translation(Vector::X * x as Real);
            world.bodies.insert(body.additional_mass(1.0))
        })
        .collect();
    for pair in bodies.windows(2) {
        let joint = FixedJointBuilder::new().local_anchor1(Vector::X);
        assert!(world.multibody_joints.insert(pair[0], pair[1], joint, true).is_some());
    }
    world.steps(1);
    remove(&mut world, bodies[1], true);
    assert_eq!(world.multibody_joints.iter().count(), 0);
    world.steps(1);
    assert_eq!(world.bodies.len(), 2);
}
