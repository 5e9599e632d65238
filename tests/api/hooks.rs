//! Hooks filter pairs and modify contacts.

use super::stage::{
    Protocol, add_box, close, height, plain, steps, with_events, world_with_ground,
};
use crate::dim::{cuboid, vec};
use rapier::prelude::*;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

/// Hook that rejects and counts all pairs.
#[derive(Default)]
struct RejectsAll {
    contacts: AtomicUsize,
    intersections: AtomicUsize,
}

impl PhysicsHooks for RejectsAll {
    fn filter_contact_pair(&self, context: &PairFilterContext) -> bool {
        self.contacts.fetch_add(1, Relaxed);
        let parent = |handle| context.colliders.get(handle).and_then(Collider::parent);
        assert_eq!(context.rigid_body1, parent(context.collider1));
        assert_eq!(context.rigid_body2, parent(context.collider2));
        assert!(context.rigid_body2.is_some_and(|body| context.bodies.contains(body)));
        false
    }

    fn filter_intersection_pair(&self, _: &PairFilterContext) -> bool {
        self.intersections.fetch_add(1, Relaxed);
        false
    }
}

#[test]
fn a_filter_is_called_for_pairs_with_active_hooks() {
    let (mut world, ground) = world_with_ground();
    let refusal = RejectsAll::default();
    let (kept, _) = add_box(&mut world, vec(0.0, 0.6), plain);
    let flags = ActiveHooks::FILTER_CONTACT_PAIRS;
    let (passes, refused) =
        add_box(&mut world, vec(3.0, 0.6), |c| with_events(c).active_hooks(flags));
    let protocol = Protocol::default();
    for _ in 0..60 {
        world.step_with_events(&refusal, &protocol);
    }
    assert!((height(&world, kept) - 0.5).abs() < 0.01);
    assert!(height(&world, passes) < -1.0);
    assert!(refusal.contacts.load(Relaxed) > 0 && refusal.intersections.load(Relaxed) == 0);
    assert!(protocol.collisions().is_empty() && protocol.forces().is_empty());
    let touches = world.contact_pair(ground, refused).is_some_and(|p| p.has_any_active_contact);
    assert!(!touches);
}

#[test]
fn a_filter_is_called_for_sensors() {
    for flags in [ActiveHooks::empty(), ActiveHooks::FILTER_INTERSECTION_PAIR] {
        let (mut world, ground) = world_with_ground();
        let refusal = RejectsAll::default();
        let zone = with_events(cuboid(1.0, 1.0)).sensor(true).active_hooks(flags);
        let zone = world.insert_collider(zone, None);
        let (_, collider) = add_box(&mut world, vec(0.0, 0.5), plain);
        let protocol = Protocol::default();
        for _ in 0..3 {
            world.step_with_events(&refusal, &protocol);
        }
        let filtered = !flags.is_empty();
        assert_eq!(refusal.intersections.load(Relaxed) > 0, filtered);
        assert_eq!(protocol.collisions().is_empty(), filtered);
        assert_eq!(world.intersection_pair(zone, collider), Some(!filtered));
        assert!(
            world.contact_pair(ground, collider).is_some(),
            "the hook does not filter this pair"
        );
    }
}

/// Platform that acts on bodies from above. It may be the first or the second collider of a pair.
struct OneWay {
    platform: ColliderHandle,
}

impl PhysicsHooks for OneWay {
    fn modify_solver_contact(&self, context: &mut ContactModificationContext) {
        let up = if context.collider1 == self.platform { Vector::Y } else { -Vector::Y };
        context.update_as_oneway_platform(up, 0.2);
    }
}

/// A box passes a platform from below, lands on it and stays. Another one falls onto it and stays.
#[test]
fn a_one_way_platform_acts_from_above_only() {
    for platform_first in [true, false] {
        for (start, velocity) in [(-2.0, 11.0), (3.0, -5.0)] {
            let mut world = PhysicsWorld::new();
            let platform = cuboid(2.0, 0.1).active_hooks(ActiveHooks::MODIFY_SOLVER_CONTACTS);
            let insert_platform =
                |world: &mut PhysicsWorld| world.insert_collider(platform.clone(), None);
            let early = platform_first.then(|| insert_platform(&mut world));
            let (body, _) = add_box(&mut world, vec(0.0, start), with_events);
            let platform = early.unwrap_or_else(|| insert_platform(&mut world));
            world.bodies[body].set_linvel(vec(0.0, velocity), true);
            let (hooks, protocol) = (OneWay { platform }, Protocol::default());
            let mut highest = start;
            for _ in 0..240 {
                world.step_with_events(&hooks, &protocol);
                highest = highest.max(height(&world, body));
            }
            close(height(&world, body), 0.6, 0.01);
            assert!(highest > 1.5, "it got to {highest}");
            assert!(protocol.collisions().iter().any(|event| event.started()));
        }
    }
}

/// Belt that moves to the right, as the first or the second collider of a pair.
struct Belt {
    belt: ColliderHandle,
}

impl PhysicsHooks for Belt {
    fn modify_solver_contact(&self, context: &mut ContactModificationContext) {
        let right = vec(2.0, 0.0);
        let is_first = context.collider1 == self.belt;
        context.set_tangent_velocity(if is_first { right } else { -right });
    }
}

#[test]
fn a_belt_carries_bodies() {
    for model in [FrictionModel::Standard, FrictionModel::Coulomb] {
        for belt_first in [true, false] {
            let mut world = PhysicsWorld::new();
            world.integration_parameters.friction_model = model;
            let belt = cuboid(50.0, 1.0).translation(vec(0.0, -1.0));
            let belt = belt.active_hooks(ActiveHooks::MODIFY_SOLVER_CONTACTS);
            let early = belt_first.then(|| world.insert_collider(belt.clone(), None));
            let (body, _) = add_box(&mut world, vec(0.0, 0.5), plain);
            let belt = early.unwrap_or_else(|| world.insert_collider(belt.clone(), None));
            for _ in 0..120 {
                world.step_with_events(&Belt { belt }, &());
            }
            close(world.bodies[body].linvel().x, 2.0, 0.02);
            assert!(world.bodies[body].translation().x > 2.0, "it was carried along");
            steps(&mut world, 60);
            close(world.bodies[body].linvel().x, 0.0, 0.01);
        }
    }
}

/// Hook that counts the steps of a contact in the contact's user data.
struct Memory;

impl PhysicsHooks for Memory {
    fn modify_solver_contact(&self, context: &mut ContactModificationContext) {
        let old = context.user_data();
        context.set_user_data(old + 1);
    }
}

#[test]
fn user_data_lasts_as_long_as_the_contact() {
    let (mut world, ground) = world_with_ground();
    let (body, collider) =
        add_box(&mut world, vec(0.0, 0.5), |c| c.active_hooks(ActiveHooks::all()));
    *world.bodies[body].activation_mut() = RigidBodyActivation::cannot_sleep();
    let age = |world: &PhysicsWorld| {
        let pair = world.contact_pair(ground, collider)?;
        pair.manifolds.first().map(|manifold| manifold.data.user_data)
    };
    for expected in 1..100 {
        world.step_with_events(&Memory, &());
        assert_eq!(age(&world), Some(expected));
    }
    world.bodies[body].set_translation(vec(0.0, 2.0), true);
    world.step_with_events(&Memory, &());
    assert_eq!(age(&world), None);
    for _ in 0..60 {
        world.step_with_events(&Memory, &());
    }
    assert!(age(&world).is_some_and(|age| age < 60), "a new touch starts from zero");
}

/// Hook that changes one number of each contact.
struct Change(fn(&mut ContactModificationContext));

impl PhysicsHooks for Change {
    fn modify_solver_contact(&self, context: &mut ContactModificationContext) {
        self.0(context);
    }
}

#[test]
fn contacts_use_the_values_of_the_hook() {
    type Case = (&'static str, fn(&mut ContactModificationContext), fn(&RigidBody) -> bool);
    let cases: [Case; 6] = [
        ("as they are", |_| {}, |b| b.linvel().x == 0.0 && b.translation().y > 0.45),
        ("slippery", |c| c.set_friction(0.0), |b| (b.linvel().x - 2.0).abs() < 1.0e-3),
        ("bouncing", |c| c.set_restitution(1.0), |b| b.linvel().y.abs() > 0.5),
        ("gone", |c| c.clear_contacts(), |b| b.translation().y < -1.0),
        ("passing", |c| c.set_solver_flags(SolverFlags::empty()), |b| b.translation().y < -1.0),
        ("none kept", |c| c.retain_contacts(|_| false), |b| b.translation().y < -1.0),
    ];
    for (name, change, is_right) in cases {
        let (mut world, _) = world_with_ground();
        let (body, _) = add_box(&mut world, vec(0.0, 0.9), |c| c.active_hooks(ActiveHooks::all()));
        world.bodies[body].set_linvel(vec(2.0, 0.0), true);
        for _ in 0..115 {
            world.step_with_events(&Change(change), &());
        }
        let body = &world.bodies[body];
        assert!(is_right(body), "{name}: {:?} {:?}", body.translation(), body.linvel());
    }
}

/// Pairs without the active hook are not modified.
#[test]
fn pairs_without_active_hooks_are_not_modified() {
    let (mut world, _) = world_with_ground();
    let filters = ActiveHooks::FILTER_CONTACT_PAIRS | ActiveHooks::FILTER_INTERSECTION_PAIR;
    let (body, _) = add_box(&mut world, vec(0.0, 0.5), |c| c.active_hooks(filters));
    for _ in 0..30 {
        world.step_with_events(&Change(|context| context.clear_contacts()), &());
    }
    close(height(&world, body), 0.5, 0.01);
}

/// Hook that panics for a sensor.
struct PanicsForSensors;

impl PhysicsHooks for PanicsForSensors {
    fn filter_intersection_pair(&self, _: &PairFilterContext) -> bool {
        panic!("a sensor");
    }
}

/// Events of a step that a hook interrupted are sent by the next step.
#[test]
fn events_are_sent_after_a_panic() {
    let (mut world, ground) = world_with_ground();
    world.gravity = Vector::ZERO;
    let (_, collider) = add_box(&mut world, vec(0.0, 0.499), with_events);
    let flags = ActiveHooks::FILTER_INTERSECTION_PAIR;
    world.insert_collider(cuboid(1.0, 1.0).sensor(true).active_hooks(flags), None);
    let step = AssertUnwindSafe(|| world.step_with_events(&PanicsForSensors, &()));
    assert!(catch_unwind(step).is_err());
    let heard = Protocol::default().of_steps(&mut world, 2);
    assert_eq!(heard.iter().filter(|event| event.started() && !event.sensor()).count(), 1);
    let touches = world.contact_pair(ground, collider).is_some_and(|p| p.has_any_active_contact);
    assert!(touches);
}
