//! Contact pairs and events.

use super::version::{collector, friction, manifolds, point};
use super::world::{GRAVITY, World, assert_near, cuboid, rounding};
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

    let manifold: &ContactManifold = &manifolds(pair)[0];
    let sum: Real = manifold.points.iter().map(|point| point.data.impulse).sum();
    assert_near(sum, weight, 0.01 * weight);
    assert_eq!(manifold.data.solver_contacts.len(), manifold.points.len());
    #[cfg(not(rapier036))]
    assert!(manifold.subshape_pos1.is_none() && manifold.subshape_pos2.is_none());
    #[cfg(rapier036)]
    assert!(manifold.subshape_poses.is_none());
    assert_near(manifold.data.normal.y.abs(), 1.0, rounding(500));
    assert_near(friction(manifold), world.colliders[collider].friction(), rounding(5));
    for contact in &manifold.data.solver_contacts {
        assert_near(point(contact).y, 0.0, 0.01);
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
        assert_near(force, total_force_magnitude, rounding(100) * force);
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
    let events = collector(send_collisions, send_forces);
    for _ in 0..120 {
        world.step_with(&(), &events);
    }
    let event: CollisionEvent = collisions.try_recv().unwrap();
    assert!([event.collider1(), event.collider2()].contains(&ground));
    let force: ContactForceEvent = forces.try_iter().last().unwrap();
    let weight = world.bodies[body].mass() * GRAVITY;
    assert_near(force.total_force.length(), weight, 0.01 * weight);
    // The weight rests evenly on the corners of the lower face.
    #[cfg(feature = "dim2")]
    let corners = 2.0;
    #[cfg(feature = "dim3")]
    let corners = 4.0;
    assert_near(force.max_force_magnitude, weight / corners, 0.02 * weight / corners);
    assert_near(force.max_force_direction.y.abs(), 1.0, rounding(500));
}

/// The events of a handler and those of a channel are equal, although a channel reads no pair.
#[test]
fn channels_send_the_forces_of_pairs() {
    struct Forces(Mutex<Vec<ContactForceEvent>>);
    impl EventHandler for Forces {
        fn handle_collision_event(
            &self,
            _: &RigidBodySet,
            _: &ColliderSet,
            _: CollisionEvent,
            _: Option<&ContactPair>,
        ) {
        }

        fn handle_contact_force_event(
            &self,
            dt: Real,
            _: &RigidBodySet,
            _: &ColliderSet,
            pair: &ContactPair,
            total: Real,
        ) {
            let event = ContactForceEvent::from_contact_pair(dt, pair, total);
            self.0.lock().unwrap().push(event);
        }
    }

    let run = |events: &dyn EventHandler| {
        let (mut world, _, [_, collider]) = World::box_on_ground();
        world.colliders[collider].set_active_events(ActiveEvents::CONTACT_FORCE_EVENTS);
        for _ in 0..30 {
            world.step_with(&(), events);
        }
    };
    let handler = Forces(Mutex::default());
    run(&handler);
    let (send_forces, forces) = channel();
    run(&collector(channel().0, send_forces));
    let expected = handler.0.into_inner().unwrap();
    assert!(expected.len() > 20);
    assert_eq!(forces.try_iter().collect::<Vec<_>>(), expected);
}

/// Each pair is converted by itself, and stays where it is while others are read.
#[test]
fn pairs_are_read_one_by_one() {
    let mut world = World::default();
    let ground = world.colliders.insert(cuboid(700.0, 1.0).translation(Vector::Y * -1.0));
    let balls: Vec<ColliderHandle> = (0..300)
        .map(|index| {
            let place = Vector::X * (2 * index) as Real + Vector::Y * 0.44;
            let body = RigidBodyBuilder::dynamic().translation(place);
            world.insert(body, ColliderBuilder::ball(0.45)).1
        })
        .collect();
    world.steps(1);
    let read = |ball: &ColliderHandle| world.narrow_phase.contact_pair(*ball, ground).unwrap();
    let pairs: Vec<&ContactPair> = balls.iter().rev().map(read).collect();
    for (pair, ball) in pairs.iter().rev().zip(&balls) {
        assert!([pair.collider1, pair.collider2].contains(ball));
        assert!(core::ptr::eq(*pair, read(ball)));
    }
    assert_eq!(world.narrow_phase.contact_pairs().count(), balls.len());
}

/// While a body slides, its friction is `μ` times its normal force: also for links of multibodies, whose
/// friction is solved per point.
#[test]
fn points_have_the_friction_of_sliding() {
    for is_link in [false, true] {
        let (mut world, body, [ground, collider]) = World::box_on_ground();
        world.colliders[collider].set_friction(0.5);
        world.colliders[ground].set_friction(0.5);
        if is_link {
            let other = RigidBodyBuilder::dynamic().translation(Vector::Y * 0.5);
            let other = world.bodies.insert(other.additional_mass(1.0e-3));
            let joint = FixedJointBuilder::new();
            assert!(world.multibody_joints.insert(body, other, joint, true).is_some());
        }
        world.steps(10);
        world.bodies[body].set_linvel(Vector::X * 10.0, true);
        world.steps(10);
        let pair = world.narrow_phase.contact_pair(ground, collider).unwrap();
        let points = manifolds(pair).iter().flat_map(|manifold| &manifold.points);
        let (mut normal, mut tangent) = (0.0, 0.0);
        for point in points {
            normal += point.data.warmstart_impulse;
            tangent += point.data.tangent_impulse.norm();
        }
        assert!(normal > 0.0);
        assert_near(tangent, 0.5 * normal, 0.03 * normal);
    }
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
