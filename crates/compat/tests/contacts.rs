//! Contact pairs and events.

use super::world::{GRAVITY, World, assert_near, cuboid};
use rapier::prelude::*;
use std::sync::Mutex;
use std::sync::mpsc::channel;

/// At rest, the normal impulses of a step are `m g dt`.
#[test]
fn contacts_carry_the_weight() {
    let (mut world, body, [ground, collider]) = World::box_on_ground();
    world.steps(120);
    let weight = world.bodies[body].mass() * GRAVITY * world.parameters.dt;
    let pairs: Vec<&ContactPair> = world.narrow_phase.contact_pairs().collect();
    let [pair] = pairs[..] else { panic!("{} pairs", pairs.len()) };
    assert!(pair.has_any_active_contact());
    assert_near(pair.total_impulse_magnitude(), weight, 0.01 * weight);

    let manifold: &ContactManifold = &pair.manifolds[0];
    let sum: Real = manifold.points.iter().map(|point| point.data.impulse).sum();
    assert_near(sum, weight, 0.01 * weight);
    assert_eq!(manifold.data.solver_contacts.len(), manifold.points.len());
    assert!(manifold.subshape_pos1.is_none() && manifold.subshape_pos2.is_none());
    assert_near(manifold.data.normal.y.abs(), 1.0, 1.0e-4);
    for contact in &manifold.data.solver_contacts {
        assert_near(contact.point.y, 0.0, 0.01);
        assert_near(contact.friction, world.colliders[collider].friction(), 1.0e-6);
    }

    let (deepest, contact) = pair.find_deepest_contact().unwrap();
    assert!(core::ptr::eq(deepest, manifold));
    assert!(manifold.points.iter().all(|point| contact.dist <= point.dist));
    let same = world.narrow_phase.contact_pair(collider, ground).unwrap();
    assert!(core::ptr::eq(same, pair), "a pair is converted once per step");
    assert_eq!(world.narrow_phase.contact_pairs_with(ground).count(), 1);
}

/// Contacts are those of the last step, not those of the first read.
#[test]
fn contacts_follow_the_steps() {
    let mut world = World::default();
    let ground = world.colliders.insert(cuboid(50.0, 1.0).translation(Vector::Y * -1.0));
    let body = RigidBodyBuilder::dynamic().translation(Vector::Y * 0.51);
    let (body, collider) = world.insert(body, ColliderBuilder::ball(0.5));
    world.steps(60);
    let active = |world: &World| {
        let pair = world.narrow_phase.contact_pair(ground, collider);
        pair.is_some_and(ContactPair::has_any_active_contact)
    };
    assert!(active(&world));
    world.bodies[body].set_translation(Vector::Y * 10.0, true);
    world.steps(1);
    assert!(!active(&world));
}

/// Records all events with their pairs.
#[derive(Default)]
struct Recorder {
    collisions: Mutex<Vec<(CollisionEvent, bool)>>,
    forces: Mutex<Vec<Real>>,
}

impl EventHandler for Recorder {
    fn handle_collision_event(
        &self,
        _bodies: &RigidBodySet,
        _colliders: &ColliderSet,
        event: CollisionEvent,
        contact_pair: Option<&ContactPair>,
    ) {
        self.collisions.lock().unwrap().push((event, contact_pair.is_some()));
    }

    fn handle_contact_force_event(
        &self,
        dt: Real,
        bodies: &RigidBodySet,
        _colliders: &ColliderSet,
        contact_pair: &ContactPair,
        total_force_magnitude: Real,
    ) {
        assert_eq!(bodies.len(), 1);
        let force = contact_pair.total_impulse_magnitude() / dt;
        assert_near(force, total_force_magnitude, 1.0e-3 * total_force_magnitude);
        self.forces.lock().unwrap().push(total_force_magnitude);
    }
}

/// At rest, the contact force is `m g`.
#[test]
fn events_come_with_their_pair() {
    let (mut world, body, [_, collider]) = World::box_on_ground();
    world.colliders[collider]
        .set_active_events(ActiveEvents::COLLISION_EVENTS | ActiveEvents::CONTACT_FORCE_EVENTS);
    let recorder = Recorder::default();
    for _ in 0..120 {
        world.step_with(&(), &recorder);
    }
    let collisions = recorder.collisions.into_inner().unwrap();
    assert!(collisions[0].0.started() && collisions[0].1);
    assert_eq!(collisions.len(), 1);
    let weight = world.bodies[body].mass() * GRAVITY;
    assert_near(*recorder.forces.lock().unwrap().last().unwrap(), weight, 0.01 * weight);
}

#[test]
fn channels_receive_all_events() {
    let (mut world, body, [ground, collider]) = World::box_on_ground();
    world.colliders[collider]
        .set_active_events(ActiveEvents::COLLISION_EVENTS | ActiveEvents::CONTACT_FORCE_EVENTS);
    let (send_collisions, collisions) = channel();
    let (send_forces, forces) = channel();
    let events = ChannelEventCollector::new(send_collisions, send_forces);
    for _ in 0..120 {
        world.step_with(&(), &events);
    }
    let event: CollisionEvent = collisions.try_recv().unwrap();
    assert!([event.collider1(), event.collider2()].contains(&ground));
    let force: ContactForceEvent = forces.try_iter().last().unwrap();
    let weight = world.bodies[body].mass() * GRAVITY;
    assert_near(force.total_force.length(), weight, 0.01 * weight);
    assert_near(force.max_force_magnitude, weight, 0.01 * weight);
}

#[test]
fn collision_pipelines_need_no_joints() {
    let (mut world, ..) = World::box_on_ground();
    let mut pipeline = CollisionPipeline::new();
    pipeline.step(
        0.01,
        &mut world.islands,
        &mut world.broad_phase,
        &mut world.narrow_phase,
        &mut world.bodies,
        &mut world.colliders,
        &(),
        &(),
    );
    assert_eq!(world.narrow_phase.contact_pairs().count(), 1);
}

/// Two colliders interact if each filter accepts the other, or in the or-mode if one does.
#[test]
fn groups_have_a_test_mode() {
    let fall = |mode: InteractionTestMode, filter: Group| {
        let (mut world, body, [ground, collider]) = World::box_on_ground();
        world.colliders[ground].set_collision_groups(InteractionGroups::new(
            Group::GROUP_1,
            Group::GROUP_2,
            mode,
        ));
        world.colliders[collider].set_collision_groups(InteractionGroups::new(
            Group::GROUP_2,
            filter,
            mode,
        ));
        world.steps(30);
        world.bodies[body].translation().y < 0.0
    };
    assert!(!fall(InteractionTestMode::And, Group::GROUP_1));
    assert!(fall(InteractionTestMode::And, Group::GROUP_3));
    assert!(!fall(InteractionTestMode::Or, Group::GROUP_3));
}
