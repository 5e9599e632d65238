//! Invariants of every world after any edits.

use super::rapier::prelude::*;

/// Checks the invariants of a world after a step.
///
/// # Panics
/// If an invariant is violated.
pub fn check(world: &PhysicsWorld) {
    check_bodies(world);
    check_colliders(world);
    check_pairs(world);
}

fn check_bodies(world: &PhysicsWorld) {
    for (handle, body) in world.bodies.iter() {
        let pose = body.position();
        assert!(pose.is_finite(), "{handle:?} is at {pose:?}");
        let length = pose.rotation.length();
        assert!((length - 1.0).abs() < 1.0e-3, "rotation of {handle:?} has the length {length}");
        assert!(body.next_position().is_finite(), "{handle:?} goes to {:?}", body.next_position());
        assert!(body.linvel().is_finite(), "{handle:?} moves at {:?}", body.linvel());
        assert!(body.angvel().is_finite(), "{handle:?} turns at {:?}", body.angvel());
        assert!(body.center_of_mass().is_finite(), "{handle:?}: {:?}", body.center_of_mass());
        assert!(body.mass().is_finite(), "{handle:?} weighs {:?}", body.mass());
        let takes_part = body.is_enabled() && !body.is_fixed();
        let listed = world.active_bodies().contains(&handle);
        assert_eq!(
            listed,
            takes_part && !body.is_sleeping(),
            "is {handle:?} awake? {body:?} in {active:?}",
            active = world.active_bodies()
        );
        for collider in body.colliders() {
            let parent = world.colliders.get(*collider).and_then(Collider::parent);
            assert_eq!(parent, Some(handle), "parent of {collider:?}");
        }
    }
    let active = world.active_bodies();
    let mut once = active.to_vec();
    once.sort_unstable();
    once.dedup();
    assert_eq!(once.len(), active.len(), "each awake body is listed once");
    assert!(active.iter().all(|handle| world.bodies.contains(*handle)), "a stale handle is awake");
}

fn check_colliders(world: &PhysicsWorld) {
    for (handle, collider) in world.colliders.iter() {
        assert!(collider.position().is_finite(), "{handle:?} is at {:?}", collider.position());
        let Some(parent) = collider.parent() else { continue };
        let body = world.bodies.get(parent);
        let listed = body.is_some_and(|body| body.colliders().contains(&handle));
        assert!(listed, "{handle:?} has the parent {parent:?}, which does not list it");
    }
}

fn check_pairs(world: &PhysicsWorld) {
    for (handle1, handle2, pair) in world.contact_pairs() {
        let both = [handle1, handle2].map(|handle| world.colliders.get(handle));
        let takes_part = |c: &Collider| c.is_enabled() && !c.is_sensor();
        let all = both.iter().all(|c| c.is_some_and(takes_part));
        assert!(all, "{handle1:?} and {handle2:?} cannot touch");
        for manifold in &pair.manifolds {
            let length = manifold.data.normal.length();
            assert!((length - 1.0).abs() < 1.0e-2, "a normal has the length {length}");
            for contact in &manifold.data {
                let finite = contact.point.is_finite()
                    && contact.dist.is_finite()
                    && contact.impulse.is_finite();
                assert!(finite, "{handle1:?} and {handle2:?}: {contact:?}");
            }
        }
    }
    for (handle1, handle2, _) in world.intersection_pairs() {
        let both = [handle1, handle2].map(|handle| world.colliders.get(handle));
        let enabled = both.iter().all(|c| c.is_some_and(|c| c.is_enabled()));
        let sensor = both.iter().any(|c| c.is_some_and(|c| c.is_sensor()));
        assert!(enabled && sensor, "{handle1:?} and {handle2:?} cannot intersect");
    }
}
