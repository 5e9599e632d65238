//! Edits that change nothing: a setter with the value that is there, and edits that are taken back before the
//! step. They send no events, wake no body, and remove no pair.

use super::stage::{Protocol, Resting};
use crate::dim::{about_z, cuboid, vec};
use rapier::prelude::*;

/// An edit of a resting box or its ground that leaves all values as they are.
type Edit = (&'static str, fn(&mut Resting));

const EDITS: [Edit; 45] = [
    ("set_position_wrt_parent", |s| {
        let pose = *s.box_collider().position_wrt_parent().expect("it has a body");
        s.box_collider().set_position_wrt_parent(pose);
    }),
    ("set_translation_wrt_parent", |s| s.box_collider().set_translation_wrt_parent(Vector::ZERO)),
    ("set_rotation_wrt_parent", |s| s.box_collider().set_rotation_wrt_parent(about_z(0.0))),
    ("set_position", |s| {
        let pose = *s.ground().position();
        s.ground().set_position(pose);
    }),
    ("set_translation", |s| {
        let place = s.ground().translation();
        s.ground().set_translation(place);
    }),
    ("set_rotation", |s| {
        let rotation = s.ground().rotation();
        s.ground().set_rotation(rotation);
    }),
    ("set_shape, shared", |s| {
        let shape = s.box_collider().shared_shape().clone();
        s.box_collider().set_shape(shape);
    }),
    ("set_shape, equal", |s| s.box_collider().set_shape(cuboid(0.5, 0.5).shape)),
    ("set_friction", |s| s.each(|it| it.set_friction(0.5))),
    ("set_friction_combine_rule", |s| {
        s.each(|it| it.set_friction_combine_rule(CoefficientCombineRule::Average));
    }),
    ("set_restitution", |s| s.each(|it| it.set_restitution(0.0))),
    ("set_restitution_combine_rule", |s| {
        s.each(|it| it.set_restitution_combine_rule(CoefficientCombineRule::Average));
    }),
    ("set_contact_skin", |s| s.each(|it| it.set_contact_skin(0.0))),
    ("set_density", |s| s.each(|it| it.set_density(1.0))),
    ("set_sensor", |s| s.each(|it| it.set_sensor(false))),
    ("set_sensor to and fro", |s| {
        s.each(|it| it.set_sensor(true));
        s.each(|it| it.set_sensor(false));
    }),
    ("set_enabled", |s| s.each(|it| it.set_enabled(true))),
    ("set_enabled to and fro", |s| {
        s.each(|it| it.set_enabled(false));
        s.each(|it| it.set_enabled(true));
    }),
    ("set_collision_groups", |s| s.each(|it| it.set_collision_groups(InteractionGroups::all()))),
    ("set_solver_groups", |s| s.each(|it| it.set_solver_groups(InteractionGroups::all()))),
    ("set_active_collision_types", |s| {
        s.each(|it| it.set_active_collision_types(ActiveCollisionTypes::default()));
    }),
    ("set_active_collision_types to and fro", |s| {
        s.each(|it| it.set_active_collision_types(ActiveCollisionTypes::empty()));
        s.each(|it| it.set_active_collision_types(ActiveCollisionTypes::default()));
    }),
    ("set_active_hooks", |s| s.each(|it| it.set_active_hooks(ActiveHooks::empty()))),
    ("set_active_events", |s| s.each(|it| it.set_active_events(ActiveEvents::COLLISION_EVENTS))),
    ("set_contact_force_event_threshold", |s| {
        s.each(|it| it.set_contact_force_event_threshold(0.0));
    }),
    ("copy_from of colliders", |s| {
        s.each(|it| {
            let copy = it.clone();
            it.copy_from(&copy);
        });
    }),
    ("set_parent", |s| {
        s.world.colliders.set_parent(s.collider, Some(s.body), &mut s.world.bodies);
    }),
    ("RigidBody::set_position", |s| {
        let pose = *s.body().position();
        s.body().set_position(pose, true);
    }),
    ("RigidBody::set_translation", |s| {
        let place = s.body().translation();
        s.body().set_translation(place, true);
    }),
    ("RigidBody::set_rotation", |s| {
        let rotation = *s.body().rotation();
        s.body().set_rotation(rotation, true);
    }),
    ("set_linvel, set_angvel", |s| {
        let (linvel, angvel) = (s.body().linvel(), s.body().angvel());
        s.body().set_linvel(linvel, true);
        s.body().set_angvel(angvel, true);
    }),
    ("set_gravity_scale", |s| s.body().set_gravity_scale(1.0, true)),
    ("set_linear_damping, set_angular_damping", |s| {
        s.body().set_linear_damping(0.0);
        s.body().set_angular_damping(0.0);
    }),
    ("set_dominance_group", |s| s.body().set_dominance_group(0)),
    ("set_locked_axes", |s| s.body().set_locked_axes(LockedAxes::empty(), true)),
    ("set_additional_mass", |s| s.body().set_additional_mass(0.0, true)),
    ("set_body_type", |s| s.body().set_body_type(RigidBodyType::Dynamic, true)),
    ("RigidBody::set_enabled", |s| s.body().set_enabled(true)),
    ("RigidBody::set_enabled to and fro", |s| {
        s.body().set_enabled(false);
        s.body().set_enabled(true);
    }),
    ("set_body_type to and fro", |s| {
        s.body().set_body_type(RigidBodyType::KinematicVelocityBased, false);
        s.body().set_body_type(RigidBodyType::Dynamic, false);
    }),
    ("reset_forces, add_force(0), apply_impulse(0)", |s| {
        s.body().reset_forces(true);
        s.body().reset_torques(true);
        s.body().add_force(Vector::ZERO, true);
        s.body().apply_impulse(Vector::ZERO, true);
    }),
    ("enable_ccd, set_soft_ccd_prediction", |s| {
        s.body().enable_ccd(false);
        s.body().set_soft_ccd_prediction(0.0);
        s.body().set_additional_solver_iterations(0);
    }),
    ("recompute_mass_properties_from_colliders", |s| {
        let PhysicsWorld { colliders, bodies, .. } = &mut s.world;
        bodies[s.body].recompute_mass_properties_from_colliders(colliders);
    }),
    ("copy_from of bodies", |s| {
        let copy = s.body().clone();
        s.body().copy_from(&copy);
    }),
    ("activation_mut", |s| {
        let threshold = s.body().activation().angular_threshold;
        s.body().activation_mut().angular_threshold = threshold;
    }),
];

/// The same values in each step: the box lands once, falls asleep like any other, and sleeps on.
#[test]
fn setters_with_the_same_value_do_nothing() {
    println!("| edit in each step | events | asleep after (steps) | woken |\n|---|--:|--:|---|");
    let expected = sleep_of(|_| ());
    let mut failures = Vec::new();
    for (name, edit) in EDITS {
        let (events, asleep, woken) = sleep_of(edit);
        println!("| {name} | {events} | {asleep} | {woken} |");
        if (events, asleep, woken) != expected {
            failures.push((name, events, asleep, woken));
        }
    }
    assert_eq!((expected.0, expected.2), (1, false));
    assert!(failures.is_empty(), "{failures:?}, and {expected:?} without edits");
}

/// Returns the number of events in 300 steps with the edit, the step after which the box sleeps, and whether
/// it woke again.
fn sleep_of(edit: fn(&mut Resting)) -> (usize, usize, bool) {
    let (mut scene, protocol) = (Resting::falling(), Protocol::default());
    let (mut events, mut asleep, mut woken) = (0, 0, false);
    for step in 1..=300 {
        if step > 10 {
            edit(&mut scene);
        }
        events += protocol.of_steps(&mut scene.world, 1).len();
        let sleeps = scene.body().is_sleeping();
        woken |= asleep > 0 && !sleeps;
        asleep = if sleeps && asleep == 0 { step } else { asleep };
    }
    (events, asleep, woken)
}

/// A shape that turns inside a sensor stays inside, and one that slides along the ground stays on the ground.
#[test]
fn moved_colliders_keep_their_pairs() {
    let mut world = PhysicsWorld::new();
    world.gravity = Vector::ZERO;
    let zone = ColliderBuilder::ball(3.0).sensor(true);
    world.insert_collider(zone.active_events(ActiveEvents::COLLISION_EVENTS), None);
    let (_, shape) = world.insert(RigidBodyBuilder::dynamic(), cuboid(1.0, 0.2));
    let protocol = Protocol::default();
    let mut events = 0;
    for step in 0..120 {
        world.colliders[shape].set_rotation_wrt_parent(about_z(0.1 * step as Real));
        events += protocol.of_steps(&mut world, 1).len();
    }
    assert_eq!(events, 1, "it never leaves the zone");

    let mut scene = Resting::falling();
    let mut events = protocol.of_steps(&mut scene.world, 30).len();
    for step in 0..60 {
        let place = vec(0.002 * step as Real, 0.0);
        scene.box_collider().set_translation_wrt_parent(place);
        events += protocol.of_steps(&mut scene.world, 1).len();
    }
    assert_eq!(events, 1, "it never leaves the ground");
    let height = scene.body().translation().y;
    assert!((height - 0.5).abs() < 0.005, "and stands on it at {height}");
}

/// A sensor that a collider passes through while it is switched over and back in the same frame reports the
/// entry and the exit alone.
#[test]
fn switches_to_and_fro_send_no_events_of_their_own() {
    let mut world = PhysicsWorld::new();
    let zone = cuboid(1.0, 1.0).sensor(true).active_events(ActiveEvents::COLLISION_EVENTS);
    let zone = world.insert_collider(zone, None);
    let ball = RigidBodyBuilder::dynamic().translation(vec(0.0, 3.0));
    world.insert(ball, ColliderBuilder::ball(0.2));
    let protocol = Protocol::default();
    let mut events = Vec::new();
    for _ in 0..120 {
        for is_sensor in [false, true] {
            world.colliders[zone].set_sensor(is_sensor);
        }
        events.extend(protocol.of_steps(&mut world, 1));
    }
    let starts: Vec<_> = events.iter().map(|event| event.started()).collect();
    assert_eq!(starts, [true, false], "{events:?}");
}

/// Sleeping bodies whose colliders get the poses that they have stay asleep, all of them.
#[test]
fn sleeping_crowds_sleep_on_at_edits_that_change_nothing() {
    let mut world = PhysicsWorld::new();
    world.insert_collider(cuboid(500.0, 1.0).translation(vec(0.0, -1.0)), None);
    for k in 0..50 {
        let body = RigidBodyBuilder::dynamic().translation(vec(2.0 * k as Real, 0.5));
        world.insert(body, cuboid(0.5, 0.5));
    }
    (0..200).for_each(|_| world.step());
    assert!(world.active_bodies().is_empty(), "all sleep");
    for _ in 0..10 {
        for (_, collider) in world.colliders.iter_mut() {
            if let Some(pose) = collider.position_wrt_parent().copied() {
                collider.set_position_wrt_parent(pose);
            }
        }
        world.step();
        assert!(world.active_bodies().is_empty(), "all sleep on");
        assert_eq!(world.physics_pipeline.counters.solver.nconstraints, 0);
    }
}
