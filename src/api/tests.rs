//! Refusals of the facades, and the equivalence of the world's shortcuts with their long forms.

use super::math::{AsSlice, Real, Vector};
use super::pipeline::{
    ActiveEvents, ActiveHooks, ChannelEventCollector, ContactModificationContext,
    PairFilterContext, PhysicsHooks, PhysicsWorld,
};
use crate::dim::collide::samples;
use crate::model::body::{RigidBodyBuilder, RigidBodyHandle, RigidBodyType};
use crate::model::collider::{ColliderBuilder, ColliderHandle};
use crate::model::contact::ContactLanes;

/// A ball in free fall.
fn falling() -> (PhysicsWorld, RigidBodyHandle, ColliderHandle) {
    let mut world = PhysicsWorld::new();
    let (body, collider) = world.insert(RigidBodyBuilder::dynamic(), ColliderBuilder::ball(0.5));
    (world, body, collider)
}

fn height(world: &PhysicsWorld, body: RigidBodyHandle) -> Real {
    world.bodies[body].translation().y
}

#[test]
fn slices_hold_all_components() {
    assert_eq!(Vector::Y.as_slice()[..2], [0.0, 1.0]);
    assert_eq!(Vector::X.as_slice().len(), super::math::DIM);
}

#[test]
fn invalid_steps_change_nothing() {
    let (mut world, body, _) = falling();
    world.step();
    let fallen = height(&world, body);
    assert!(fallen < 0.0);
    let valid = world.integration_parameters;
    world.integration_parameters.dt = Real::NAN;
    world.step();
    world.detect_collisions(&(), &());
    assert_eq!(height(&world, body), fallen);
    world.integration_parameters = valid;
    world.gravity = Vector::Y * Real::INFINITY;
    world.step();
    assert_eq!(height(&world, body), fallen);
    world.gravity = Vector::ZERO;
    world.step();
    assert!(height(&world, body) < fallen, "valid steps go on where the last one ended");
}

/// One step under a gravity given in one of its two forms.
fn rise(gravity: impl core::borrow::Borrow<Vector>) -> Real {
    let (mut world, body, _) = falling();
    world.physics_pipeline.step(
        gravity,
        &world.integration_parameters,
        &mut world.islands,
        &mut world.broad_phase,
        &mut world.narrow_phase,
        &mut world.bodies,
        &mut world.colliders,
        &mut world.impulse_joints,
        &mut world.multibody_joints,
        &(),
        &(),
    );
    height(&world, body)
}

#[test]
fn gravity_is_taken_by_value_and_by_reference() {
    let (value, reference) = (Vector::Y, &Vector::Y);
    assert!(rise(value) > 0.0);
    assert_eq!(rise(value), rise(reference));
}

#[test]
fn collision_detection_moves_nothing() {
    let (mut world, body, collider) = falling();
    let (_, ground) = world.insert(RigidBodyBuilder::fixed(), ColliderBuilder::ball(0.5));
    assert!(world.contact_pair(collider, ground).is_none());
    world.detect_collisions(&(), &());
    let pair = world.contact_pair(ground, collider).expect("the balls overlap");
    assert!(pair.has_any_active_contact);
    assert_eq!(pair.total_impulse_magnitude(), 0.0);
    assert_eq!(height(&world, body), 0.0);
    assert_eq!(world.contact_pairs().count(), 1);
    assert_eq!(world.contact_pairs_with(collider).count(), 1);
}

#[test]
fn sensors_intersect() {
    let (mut world, _, collider) = falling();
    let zone = world.insert_collider(ColliderBuilder::ball(2.0).sensor(true), None);
    world.step();
    assert_eq!(world.intersection_pair(zone, collider), Some(true));
    assert_eq!(world.intersection_pairs().count(), 1);
    assert_eq!(world.intersection_pairs_with(zone).count(), 1);
    assert!(world.contact_pair(zone, collider).is_none());
}

#[test]
fn removal_takes_the_colliders_along() {
    let (mut world, body, collider) = falling();
    let second = world.insert_collider(ColliderBuilder::ball(0.5), Some(body));
    world.step();
    assert!(world.remove_collider(second).is_some());
    assert!(world.remove_collider(second).is_none(), "the handle is stale");
    assert!(world.remove_body(body).is_some());
    assert!(world.remove_body(body).is_none(), "the handle is stale");
    world.step();
    assert!(world.colliders.get(collider).is_none());
    assert!(world.bodies.is_empty() && world.active_bodies().is_empty());
}

#[test]
fn waking_reaches_every_body() {
    let (mut world, body, _) = falling();
    world.gravity = Vector::ZERO;
    for _ in 0..600 {
        world.step();
    }
    assert!(world.bodies[body].is_sleeping());
    world.wake_up_all(true);
    world.step();
    assert_eq!(world.active_bodies(), [body]);
    for _ in 0..600 {
        world.step();
    }
    world.wake_up(body, true);
    assert!(!world.bodies[body].is_sleeping());
    world.wake_up(RigidBodyHandle::invalid(), true);
}

#[test]
fn counters_measure_the_step() {
    let (mut world, _, _) = falling();
    world.step();
    assert_eq!(world.physics_pipeline.counters.step_time_ms(), 0.0, "without a request");
    world.physics_pipeline.counters.enable();
    world.step();
    let counters = &world.physics_pipeline.counters;
    assert!(counters.step_time_ms() > 0.0);
    assert!(counters.step_time_ms() >= counters.solver_time_ms());
}

/// A ball of radius 0.5 moving up or down at a platform at the origin, a ball of radius 0.5 too.
fn thrown_at_platform(height: Real, velocity: Real) -> (PhysicsWorld, RigidBodyHandle) {
    let mut world = PhysicsWorld::new();
    let platform = ColliderBuilder::ball(0.5).active_hooks(ActiveHooks::all());
    world.insert_collider(platform, None);
    let ball = RigidBodyBuilder::dynamic()
        .translation(Vector::Y * height)
        .linvel(Vector::Y * velocity)
        .lock_rotations();
    let (ball, _) = world.insert(ball, ColliderBuilder::ball(0.5).density(1.0));
    (world, ball)
}

/// Every collider with hooks is a one-way platform. Its normal relative to the first collider is up if that
/// is the platform.
struct OneWay;

impl PhysicsHooks for OneWay {
    fn modify_solver_contact(&self, context: &mut ContactModificationContext) {
        let up = if context.rigid_body1.is_none() { Vector::Y } else { -Vector::Y };
        context.update_as_oneway_platform(up, 0.5);
    }
}

#[test]
fn oneway_platform_is_passed_from_below_and_holds_from_above() {
    let (mut world, ball) = thrown_at_platform(-2.0, 10.0);
    let mut highest: Real = 0.0;
    for _ in 0..180 {
        world.step_with_events(&OneWay, &());
        highest = highest.max(height(&world, ball));
    }
    assert!(highest > 1.5, "went up to {highest}");
    let rest = height(&world, ball);
    assert!((rest - 1.0).abs() < 0.02, "rests at {rest}");
}

/// Colliders with hooks have no contacts.
struct Ghost;

impl PhysicsHooks for Ghost {
    fn filter_contact_pair(&self, _: &PairFilterContext) -> bool {
        false
    }
}

#[test]
fn filtered_pair_does_not_collide() {
    let (mut world, ball) = thrown_at_platform(2.0, -10.0);
    for _ in 0..60 {
        world.step_with_events(&Ghost, &());
    }
    let fallen = height(&world, ball);
    assert!(fallen < -2.0, "at {fallen}");
}

#[test]
fn events_report_begin_end_and_force() {
    use std::sync::mpsc::channel;
    let (send_collision, collisions) = channel();
    let (send_force, forces) = channel();
    let events = ChannelEventCollector::new(send_collision, send_force);
    let mut world = PhysicsWorld::new();
    let ground = world.insert_collider(ColliderBuilder::ball(0.5), None);
    let ball = RigidBodyBuilder::dynamic().translation(Vector::Y).lock_rotations();
    let collider = ColliderBuilder::ball(0.5).active_events(ActiveEvents::all());
    let (ball, collider) = world.insert(ball, collider);
    for _ in 0..60 {
        world.step_with_events(&(), &events);
    }
    let begun: Vec<_> = collisions.try_iter().collect();
    assert_eq!(begun.len(), 1);
    assert!(begun[0].started() && !begun[0].sensor());
    let force = forces.try_iter().last().expect("the ball rests on the other");
    let weight = world.bodies[ball].mass() * 9.81;
    let error = (force.total_force_magnitude - weight).abs() / weight;
    assert!(error < 0.01, "{} instead of {weight}", force.total_force_magnitude);
    assert_eq!(force.total_force.length(), force.max_force_magnitude);

    assert!(world.remove_collider(collider).is_some());
    world.step_with_events(&(), &events);
    let ended: Vec<_> = collisions.try_iter().collect();
    assert_eq!(ended.len(), 1);
    assert!(ended[0].stopped() && ended[0].removed());
    assert!([ended[0].collider1(), ended[0].collider2()].contains(&ground));
}

/// The triangle cache is discarded with its shape: a body sinks to the new floor, although the boxes of old
/// and new overlap.
#[test]
fn a_new_floor_acts_at_once() {
    fn high(at: Vector) -> Real {
        if at.x.abs() > 2.5 { 1.0 } else { 0.0 }
    }
    fn low(at: Vector) -> Real {
        if at.x.abs() > 2.5 { 1.0 } else { -0.5 }
    }
    let ground = |height| ColliderBuilder::new(samples::carpet(20, 0.3, height, |_| true));
    let mut world = PhysicsWorld::new();
    let floor = world.insert_collider(ground(high), None);
    let body = RigidBodyBuilder::dynamic().translation(Vector::Y * 0.5).linvel(Vector::X * 0.2);
    let collider = ColliderBuilder::new(samples::cuboid(Vector::splat(0.5)));
    let (body, _) = world.insert(body, collider);
    for _ in 0..20 {
        world.step();
    }
    assert!((height(&world, body) - 0.5).abs() < 0.01);
    world.colliders[floor].set_shape(ground(low).shape);
    for _ in 0..90 {
        world.step();
    }
    // Contacts are soft: a box of this weight sinks in by some millimetres.
    assert!(height(&world, body).abs() < 0.01, "{}", height(&world, body));
}

/// The solver's persistent lanes save time, and change nothing: a world that loses them before each step
/// continues in the same way.
#[test]
fn a_world_runs_without_stored_solver_data() {
    let heap = || {
        let mut world = PhysicsWorld::new();
        world.insert_collider(ColliderBuilder::halfspace(Vector::Y), None);
        for k in 0..90_u8 {
            let at = Vector::Y * (0.6 + Real::from(k / 5)) + Vector::X * (0.8 * Real::from(k % 5));
            let body = RigidBodyBuilder::dynamic().translation(at);
            world.insert(body, ColliderBuilder::ball(0.45).restitution(0.05 * Real::from(k % 3)));
        }
        world
    };
    let (mut kept, mut lost) = (heap(), heap());
    for step in 0..150 {
        for world in [&mut kept, &mut lost] {
            let bodies: Vec<_> = world.bodies.iter().map(|(handle, _)| handle).collect();
            let body = bodies[step * 29 % bodies.len()];
            match step % 20 {
                7 => drop(world.remove_body(body)),
                11 => world.bodies[body].set_additional_solver_iterations(step % 3),
                15 => world.bodies[body].set_body_type(RigidBodyType::Fixed, true),
                _ => {}
            }
            world.step();
        }
        lost.narrow_phase.write_back_all(crate::base::tasks::Tasks::SERIAL);
        lost.narrow_phase.lanes = ContactLanes::default();
    }
    for ((_, one), (_, other)) in kept.bodies.iter().zip(lost.bodies.iter()) {
        assert_eq!((one.position(), one.linvel()), (other.position(), other.linvel()));
    }
}
