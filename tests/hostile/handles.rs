//! Handles without an object: stale, foreign, invalid, and far out of range.

use super::listener::listen;
use super::scene::Scene;
use super::world::check;
use rapier::prelude::*;

/// Returns handles of bodies that the scene does not contain.
fn missing_bodies(scene: &mut Scene) -> Vec<RigidBodyHandle> {
    let gone = scene.world.insert_body(RigidBodyBuilder::dynamic());
    scene.world.remove_body(gone);
    let (slot, generation) = scene.body.into_raw_parts();
    vec![
        gone,
        RigidBodyHandle::default(),
        RigidBodyHandle::invalid(),
        RigidBodyHandle::from_raw_parts(u32::MAX, 0),
        RigidBodyHandle::from_raw_parts(u32::MAX - 1, u32::MAX),
        RigidBodyHandle::from_raw_parts(slot, generation + 1),
        RigidBodyHandle::from_raw_parts(slot, u32::MAX),
        RigidBodyHandle::from_raw_parts(1_000_000, 0),
    ]
}

/// Returns handles of colliders that the scene does not contain.
fn missing_colliders(scene: &mut Scene) -> Vec<ColliderHandle> {
    let gone = scene.world.insert_collider(ColliderBuilder::ball(0.1), None);
    scene.world.remove_collider(gone);
    let (slot, generation) = scene.collider.into_raw_parts();
    vec![
        gone,
        ColliderHandle::default(),
        ColliderHandle::invalid(),
        ColliderSet::invalid_handle(),
        ColliderHandle::from_raw_parts(u32::MAX, 0),
        ColliderHandle::from_raw_parts(u32::MAX - 1, u32::MAX),
        ColliderHandle::from_raw_parts(slot, generation + 1),
        ColliderHandle::from_raw_parts(slot, u32::MAX),
        ColliderHandle::from_raw_parts(1_000_000, 0),
    ]
}

#[test]
fn missing_bodies_are_not_found() {
    let mut scene = Scene::new();
    let before = scene.world.bodies.len();
    for missing in missing_bodies(&mut scene) {
        let bodies = &mut scene.world.bodies;
        assert!(!bodies.contains(missing), "{missing:?}");
        assert!(bodies.get(missing).is_none() && bodies.get_mut(missing).is_none(), "{missing:?}");
        assert!(bodies.remove(missing).is_none(), "{missing:?}");
        let pair = bodies.get_pair_mut(missing, scene.body);
        assert!(pair.0.is_none() && pair.1.is_some(), "{missing:?}");
        let pair = bodies.get_pair_mut(scene.body, missing);
        assert!(pair.0.is_some() && pair.1.is_none(), "{missing:?}");
        assert!(scene.world.remove_body(missing).is_none(), "{missing:?}");
        scene.world.wake_up(missing, true);
    }
    let pair = scene.world.bodies.get_pair_mut(scene.body, scene.body);
    assert!(pair.0.is_some() && pair.1.is_none(), "one body cannot be borrowed twice");
    assert!(scene.world.bodies.get_unknown_gen(u32::MAX).is_none());
    assert!(scene.world.bodies.get_unknown_gen_mut(u32::MAX).is_none());
    assert_eq!(scene.world.bodies.len(), before);
    scene.steps(3);
}

#[test]
fn a_missing_collider_is_never_found() {
    let mut scene = Scene::new();
    let before = scene.world.colliders.len();
    for missing in missing_colliders(&mut scene) {
        let colliders = &mut scene.world.colliders;
        assert!(!colliders.contains(missing), "{missing:?}");
        assert!(
            colliders.get(missing).is_none() && colliders.get_mut(missing).is_none(),
            "{missing:?}"
        );
        let pair = colliders.get_pair_mut(missing, scene.collider);
        assert!(pair.0.is_none() && pair.1.is_some(), "{missing:?}");
        let pair = colliders.get_pair_mut(scene.collider, missing);
        assert!(pair.0.is_some() && pair.1.is_none(), "{missing:?}");
        let world = &mut scene.world;
        assert!(world.remove_collider(missing).is_none(), "{missing:?}");
        assert!(world.contact_pair(missing, scene.collider).is_none(), "{missing:?}");
        assert!(world.contact_pair(missing, missing).is_none(), "{missing:?}");
        assert_eq!(world.contact_pairs_with(missing).count(), 0, "{missing:?}");
        assert!(world.intersection_pair(scene.collider, missing).is_none(), "{missing:?}");
        assert_eq!(world.intersection_pairs_with(missing).count(), 0, "{missing:?}");
    }
    let pair = scene.world.colliders.get_pair_mut(scene.collider, scene.collider);
    assert!(pair.0.is_some() && pair.1.is_none(), "one collider cannot be borrowed twice");
    assert!(scene.world.colliders.get_unknown_gen(u32::MAX).is_none());
    assert!(scene.world.colliders.get_unknown_gen_mut(u32::MAX).is_none());
    assert_eq!(scene.world.colliders.len(), before);
    scene.steps(3);
}

#[test]
fn no_collider_is_attached_to_a_missing_body() {
    let mut untouched = Scene::new();
    missing_bodies(&mut untouched);
    let expected = untouched.distant_in_the_end();
    let mut scene = Scene::new();
    for missing in missing_bodies(&mut scene) {
        let parent = scene.collider().parent();
        let PhysicsWorld { colliders, bodies, .. } = &mut scene.world;
        let (_, heard) = listen(|| colliders.set_parent(scene.collider, Some(missing), bodies));
        assert!(heard.iter().any(|text| text.contains(&format!("{missing:?}"))), "{heard:?}");
        assert_eq!(scene.collider().parent(), parent, "{missing:?}");

        let ball = ColliderBuilder::ball(0.5);
        let (orphan, heard) = listen(|| scene.world.insert_collider(ball, Some(missing)));
        assert!(heard.iter().any(|text| text.contains(&format!("{missing:?}"))), "{heard:?}");
        let orphan = &scene.world.colliders[orphan];
        assert!(orphan.parent().is_none() && !orphan.is_enabled(), "{missing:?}");
    }
    for missing in missing_colliders(&mut scene) {
        let PhysicsWorld { colliders, bodies, .. } = &mut scene.world;
        let (_, heard) = listen(|| colliders.set_parent(missing, Some(scene.body), bodies));
        assert!(heard.iter().any(|text| text.contains(&format!("{missing:?}"))), "{heard:?}");
        colliders.set_parent(missing, None, bodies);
    }
    assert!(scene.distant_in_the_end() == expected, "missing handles affect distant bodies");
}

/// The next step removes a joint to a forged body handle. It allocates no memory for the slots in between.
#[test]
fn no_joint_is_attached_to_a_missing_body() {
    let mut scene = Scene::new();
    let mut missing = missing_bodies(&mut scene);
    missing.push(RigidBodyHandle::from_raw_parts(4_000_000_000, 7));
    for (k, &missing) in missing.iter().enumerate() {
        let joint = FixedJointBuilder::new().build();
        let ends = if k % 2 == 0 { [missing, scene.body] } else { [scene.body, missing] };
        let kept = scene.world.impulse_joints.insert(ends[0], ends[1], joint, true);
        let gone = scene.world.impulse_joints.insert(missing, missing, joint, true);
        assert_eq!(scene.world.impulse_joints.attached_joints(missing).count(), 2, "{missing:?}");
        assert!(scene.world.impulse_joints.remove(gone, true).is_some(), "{missing:?}");
        assert_eq!(scene.world.impulse_joints.joints_between(missing, scene.body).count(), 1);
        scene.world.impulse_joints.remove_joints_attached_to_rigid_body(missing);
        assert!(scene.world.impulse_joints.get(kept).is_none(), "{missing:?}");
        listen(|| {
            scene.world.impulse_joints.insert(ends[0], ends[1], joint, true);
            scene.world.multibody_joints.insert(ends[0], ends[1], joint, true);
            scene.world.multibody_joints.remove_joints_attached_to_rigid_body(missing);
            scene.world.multibody_joints.insert(ends[0], ends[1], joint, true);
        });
        scene.world.wake_up(missing, true);
        scene.world.step();
        assert!(scene.world.impulse_joints.is_empty(), "{missing:?}");
        assert!(scene.world.multibody_joints.is_empty(), "{missing:?}");
    }
    assert!(scene.world.impulse_joints.get_unknown_gen(u32::MAX).is_none());
    assert!(scene.world.multibody_joints.get_unknown_gen(u32::MAX).is_none());
    for slot in [0, 1_000_000, u32::MAX - 1, u32::MAX] {
        for generation in [0, 1, u32::MAX] {
            let joint = ImpulseJointHandle::from_raw_parts(slot, generation);
            assert!(scene.world.impulse_joints.get(joint).is_none());
            assert!(scene.world.impulse_joints.get_mut(joint).is_none());
            assert!(scene.world.impulse_joints.remove(joint, true).is_none());
            let joint = MultibodyJointHandle::from_raw_parts(slot, generation);
            assert!(scene.world.multibody_joints.get(joint).is_none());
            assert!(scene.world.multibody_joints.get_mut(joint).is_none());
            assert!(scene.world.multibody_joints.remove(joint, true).is_none());
            scene.world.multibody_joints.remove_multibody_articulations(joint, true);
        }
    }
    scene.steps(2);
}

/// A capacity is a hint: the memory need not exist.
#[test]
fn any_capacity_may_be_requested() {
    for capacity in [0, 1, usize::MAX / 2, usize::MAX] {
        assert!(RigidBodySet::with_capacity(capacity).is_empty());
        assert!(ColliderSet::with_capacity(capacity).is_empty());
    }
}

/// The handle of a slot's old object does not find the new one.
#[test]
fn a_reused_slot_invalidates_the_old_handle() {
    let mut scene = Scene::new();
    let old = (scene.body, scene.collider);
    for _ in 0..50 {
        scene.world.remove_body(scene.body);
        let ball = ColliderBuilder::ball(0.4);
        let place = RigidBodyBuilder::dynamic().translation(Vector::Y * 2.0);
        (scene.body, scene.collider) = scene.world.insert(place, ball);
        assert_eq!(scene.body.into_raw_parts().0, old.0.into_raw_parts().0, "the slot is reused");
        assert!(scene.world.bodies.get(old.0).is_none());
        scene.steps(1);
        assert!(scene.world.colliders.get(old.1).is_none());
        assert!(scene.world.remove_body(old.0).is_none());
        assert!(scene.world.remove_collider(old.1).is_none());
    }
    assert_eq!(scene.world.colliders.len(), 8);
}

/// Handles of another world may match an object here. Edits then affect that object, and cause no other
/// damage.
#[test]
fn handles_of_another_world_do_no_harm() {
    let mut home = Scene::new();
    let mut other = PhysicsWorld::new();
    let mut foreign = Vec::new();
    for _ in 0..40 {
        foreign.push(other.insert(RigidBodyBuilder::dynamic(), ColliderBuilder::ball(0.5)));
    }
    for (body, collider) in foreign {
        home.world.wake_up(body, true);
        let PhysicsWorld { colliders, bodies, .. } = &mut home.world;
        listen(|| colliders.set_parent(collider, Some(body), bodies));
        home.world.step();
        check(&home.world);
        home.world.remove_collider(collider);
        home.world.remove_body(body);
        home.world.step();
        check(&home.world);
    }
    assert!(home.world.bodies.is_empty(), "all slots of the small world were hit");
}

/// Indexing is the only access that panics on a missing object.
#[test]
fn only_indexing_panics_and_names_the_handle() {
    use std::panic::{AssertUnwindSafe, catch_unwind};
    let mut scene = Scene::new();
    let bodies = missing_bodies(&mut scene);
    let colliders = missing_colliders(&mut scene);
    let message = |result: std::thread::Result<()>| {
        let panic = result.expect_err("a missing handle was indexed");
        *panic.downcast::<String>().expect("a message")
    };
    let world = AssertUnwindSafe(&mut scene.world);
    for missing in bodies {
        let text = message(catch_unwind(|| drop(world.bodies[missing].clone())));
        assert!(text.contains(&format!("{missing:?}")), "{text}");
    }
    for missing in colliders {
        let text = message(catch_unwind(|| drop(world.colliders[missing].clone())));
        assert!(text.contains(&format!("{missing:?}")), "{text}");
    }
}

/// The same holds before the first step. Each collider follows its own body, on any thread.
#[test]
fn bodies_can_be_replaced_before_the_first_step() {
    let mut world = PhysicsWorld::new();
    world.gravity = Vector::ZERO;
    let place = |k: usize| crate::dim::vec(4.0 * k as Real, 0.0);
    let mut insert = |k: usize| {
        let body = RigidBodyBuilder::dynamic().translation(place(k));
        world.insert(body, ColliderBuilder::ball(0.5))
    };
    let made: Vec<_> = (0..4).map(&mut insert).collect();
    world.bodies[made[1].0] = world.bodies[made[0].0].clone();
    let (second, third) = world.bodies.get_pair_mut(made[2].0, made[3].0);
    core::mem::swap(second.unwrap(), third.unwrap());
    for _ in 0..3 {
        for (body, _) in &made {
            world.bodies[*body].set_linvel(crate::dim::vec(1.0, 0.0), true);
        }
        world.step();
    }
    for (body, collider) in made {
        let (body, at) = (&world.bodies[body], world.colliders[collider].translation());
        assert_eq!(body.colliders(), [collider]);
        assert!(
            (body.translation() - at).length() < 1.0e-6,
            "{at} is not at {}",
            body.translation()
        );
    }
}

/// A `&mut` to a body allows its replacement by another body. The world keeps both apart.
#[test]
fn a_replacing_body_takes_over_the_slot() {
    let mut world = PhysicsWorld::new();
    let ground = RigidBodyBuilder::fixed().translation(crate::dim::vec(0.0, -1.0));
    world.insert(ground, crate::dim::cuboid(20.0, 1.0));
    let handles: Vec<_> = (0..6_u8)
        .map(|k| {
            let at = crate::dim::vec(Real::from(k) * 1.5 - 4.0, 0.5);
            world
                .insert(RigidBodyBuilder::dynamic().translation(at), crate::dim::cuboid(0.5, 0.5))
                .0
        })
        .collect();
    for _ in 0..5 {
        world.step();
    }
    let copy = world.bodies[handles[0]].clone();
    world.bodies[handles[1]] = copy.clone();
    world.bodies[handles[2]] =
        RigidBodyBuilder::dynamic().translation(crate::dim::vec(3.0, 4.0)).build();
    world.bodies[handles[3]] = RigidBodyBuilder::kinematic_velocity_based().build();
    world.step();
    world.bodies[handles[4]] = copy;
    world.bodies.remove(handles[4]);
    world.bodies.remove(handles[0]);
    world.bodies.remove(handles[1]);
    for _ in 0..120 {
        world.step(); // Debug builds check here that all lists agree.
    }
    assert_eq!(world.bodies.len(), 4);
    assert!(world.bodies.iter().all(|(_, body)| body.position().is_finite()));
}
