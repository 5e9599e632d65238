//! Invalid values: a report that names entity and value, and a world that goes on.

use crate::dim::{cube, rotation, vector};
use crate::plugin::prelude::*;
use crate::plugin::rapier::prelude::InvalidCollider;
use crate::scene::*;
use bevy::prelude::*;

#[derive(Resource, Default)]
struct Reports(Vec<(Entity, Invalid)>);

fn reporting() -> App {
    reporting_with(PhysicsPlugin::default().without_interpolation())
}

fn reporting_with(plugin: PhysicsPlugin) -> App {
    let mut app = app_with(plugin.with_gravity(Vector::Y * -G));
    app.init_resource::<Reports>();
    app.add_observer(|on: On<Refused>, mut reports: ResMut<Reports>| {
        reports.0.push((on.entity, on.reason.clone()));
    });
    app
}

fn take_reports(app: &mut App) -> Vec<(Entity, Invalid)> {
    core::mem::take(&mut app.world_mut().resource_mut::<Reports>().0)
}

#[test]
fn an_invalid_collider_is_reported_once_and_the_rest_goes_on() {
    let mut app = reporting();
    let broken = app.world_mut().spawn((RigidBody::Dynamic, Collider::ball(-3.0))).id();
    let sound = app.world_mut().spawn((RigidBody::Dynamic, cube(0.5), at(5.0, 0.0))).id();
    run(&mut app, 64);
    let reports = take_reports(&mut app);
    assert_eq!(reports.len(), 1);
    let (entity, reason) = &reports[0];
    assert_eq!(*entity, broken);
    let Invalid::Collider(InvalidCollider::Number { parameter, value, .. }) = reason else {
        panic!("{reason:?}");
    };
    assert_eq!((*parameter, *value), ("radius", -3.0));
    assert!(reason.to_string().contains("-3"));
    assert_near(get::<Velocity>(&app, sound).linear.y, -G, 1.0e-4);
    assert_eq!(counts(&app), [2, 1, 0]);
    // A valid shape is the next try.
    app.world_mut().entity_mut(broken).insert(Collider::ball(3.0));
    run(&mut app, 2);
    assert_eq!(counts(&app), [2, 2, 0]);
    assert!(take_reports(&mut app).is_empty());
}

#[test]
fn the_error_of_a_constructor_is_typed() {
    let error = Collider::convex_hull(&[Vector::ZERO]).shape().expect_err("one point is no hull");
    assert!(!error.to_string().is_empty());
    assert!(Collider::trimesh(&[Vector::ZERO], vec![[0, 1, 2]]).shape().is_err());
    assert!(Collider::ball(1.0).shape().is_ok());
}

#[test]
fn an_invalid_edit_keeps_the_last_valid_state() {
    let mut app = reporting();
    let body = app.world_mut().spawn((RigidBody::Dynamic, cube(0.5))).id();
    run(&mut app, 2);
    edit::<Friction>(&mut app, body).coefficient = Scalar::NAN;
    run(&mut app, 2);
    let reports = take_reports(&mut app);
    assert_eq!(reports.len(), 1);
    assert_eq!(reports[0].0, body);
    assert!(reports[0].1.to_string().contains("friction"));
    assert_near(physics(&app).collider(body).unwrap().friction(), 0.5, 1.0e-6);
}

#[test]
fn a_scale_of_zero_is_refused() {
    let mut app = reporting();
    let body = app.world_mut().spawn((RigidBody::Dynamic, cube(0.5))).id();
    run(&mut app, 2);
    edit::<Transform>(&mut app, body).scale = Vec3::new(1.0, 0.0, 1.0);
    run(&mut app, 8);
    let reports = take_reports(&mut app);
    assert_eq!(reports.len(), 1);
    assert!(reports[0].1.to_string().contains("scale is 0"));
    assert_eq!(counts(&app), [1, 1, 0]);
}

#[test]
fn an_invalid_body_is_reported_and_tried_again_after_an_edit() {
    let mut app = reporting();
    let body = app.world_mut().spawn((RigidBody::Dynamic, cube(0.5), at(f32::NAN, 0.0))).id();
    run(&mut app, 8);
    let reports = take_reports(&mut app);
    assert!(!reports.is_empty() && reports.iter().all(|(entity, _)| *entity == body));
    assert!(matches!(reports[0].1, Invalid::Body(_)));
    assert_eq!(reports.len(), 1);
    assert_eq!(counts(&app), [0, 0, 0]);
    *edit::<Transform>(&mut app, body) = at(0.0, 0.0);
    run(&mut app, 4);
    assert_eq!(counts(&app), [1, 1, 0]);
}

#[test]
fn an_invalid_joint_is_reported() {
    let mut app = reporting();
    let [first, second] =
        [0.0, 5.0].map(|x| app.world_mut().spawn((RigidBody::Fixed, at(x, 0.0))).id());
    let joint = app.world_mut().spawn(Joint::rope(first, second, 1.0)).id();
    run(&mut app, 4);
    let reports = take_reports(&mut app);
    assert_eq!(reports.len(), 1);
    assert_eq!(reports[0].0, joint);
    assert!(matches!(reports[0].1, Invalid::Joint(_)));
    assert_eq!(counts(&app), [2, 0, 0]);
}

#[test]
fn a_velocity_that_is_no_number_is_refused() {
    for kind in [RigidBody::Dynamic, RigidBody::Fixed] {
        let mut app = reporting();
        let body = app.world_mut().spawn((kind, cube(0.5))).id();
        run(&mut app, 2);
        let before = *get::<Velocity>(&app, body);
        *edit::<Velocity>(&mut app, body) =
            Velocity { linear: vector(Scalar::NAN, 0.0), angular: rotation(5.0) };
        run(&mut app, 2);
        let reports = take_reports(&mut app);
        assert_eq!(reports.len(), 1);
        assert_eq!(reports[0].0, body);
        assert!(reports[0].1.to_string().contains("linvel"));
        // Neither part of the edit took effect.
        assert_eq!(get::<Velocity>(&app, body).angular, before.angular);
        assert!(get::<Velocity>(&app, body).linear.is_finite());
        assert!(position(&app, body).is_finite());
    }
}

#[test]
fn a_pose_that_is_no_number_returns_to_the_last_one() {
    for kind in [RigidBody::Dynamic, RigidBody::Fixed, RigidBody::KinematicPosition] {
        for interpolates in [false, true] {
            let plugin = PhysicsPlugin::default();
            let plugin = if interpolates { plugin } else { plugin.without_interpolation() };
            let mut app = reporting_with(plugin);
            let body = app.world_mut().spawn((kind, cube(0.5), at(2.0, 0.0))).id();
            run(&mut app, 4);
            edit::<Transform>(&mut app, body).translation = Vec3::NAN;
            run(&mut app, 4);
            let reports = take_reports(&mut app);
            assert_eq!(reports.len(), 1);
            assert_eq!(reports[0].0, body);
            assert!(reports[0].1.to_string().contains("position"));
            assert_near(position(&app, body).x, 2.0, 1.0e-5);
            assert!(get::<GlobalTransform>(&app, body).translation().is_finite());
        }
    }
}

#[test]
fn a_parent_of_size_zero_leaves_finite_transforms() {
    let mut app = reporting();
    let group = app.world_mut().spawn(at(1.0, 0.0)).id();
    let bundle = (RigidBody::Dynamic, GravityScale(0.0), cube(0.5), at(2.0, 3.0), ChildOf(group));
    let body = app.world_mut().spawn(bundle).id();
    run(&mut app, 2);
    edit::<Transform>(&mut app, group).scale = Vec3::ZERO;
    run(&mut app, 4);
    assert_eq!(position(&app, body), Vec3::new(2.0, 3.0, 0.0));
    edit::<Transform>(&mut app, group).scale = Vec3::ONE;
    run(&mut app, 4);
    let pose = physics(&app).body(body).unwrap().position().translation;
    assert_near(pose.x, 3.0, 1.0e-5);
    // An invalid parent moves nothing, and is reported once.
    take_reports(&mut app);
    edit::<Transform>(&mut app, group).translation.x = f32::NAN;
    run(&mut app, 4);
    assert!(position(&app, body).is_finite());
    assert_eq!(take_reports(&mut app).iter().filter(|(entity, _)| *entity == body).count(), 1);
}

#[test]
fn invalid_settings_of_a_body_are_reported_and_change_nothing() {
    let mut app = reporting();
    let body = app.world_mut().spawn((RigidBody::Dynamic, cube(0.5))).id();
    run(&mut app, 2);
    edit::<Damping>(&mut app, body).linear = -1.0;
    edit::<Damping>(&mut app, body).angular = 3.0;
    edit::<GravityScale>(&mut app, body).0 = Scalar::INFINITY;
    edit::<ExternalForce>(&mut app, body).force = vector(Scalar::NAN, 1.0);
    edit::<ExternalImpulse>(&mut app, body).impulse = vector(0.0, Scalar::NAN);
    run(&mut app, 2);
    let reports = take_reports(&mut app);
    assert!(reports.iter().all(|(entity, _)| *entity == body));
    for field in ["linear_damping", "gravity_scale", "external_force", "external_impulse"] {
        let count = reports.iter().filter(|(_, reason)| reason.to_string().contains(field)).count();
        assert_eq!(count, 1, "{field} in {reports:?}");
    }
    assert_eq!(reports.len(), 4);
    let engine_body = physics(&app).body(body).unwrap();
    assert_eq!((engine_body.linear_damping(), engine_body.angular_damping()), (0.0, 0.0));
    assert_eq!(engine_body.gravity_scale(), 1.0);
    assert_eq!(engine_body.user_force(), crate::plugin::rapier::math::Vector::ZERO);
    assert_eq!(*get::<ExternalImpulse>(&app, body), ExternalImpulse::default());
}

#[test]
fn refused_poses_and_scales_are_reported_once() {
    let mut app = reporting();
    let [first, second] =
        [0.0, 9.0].map(|x| app.world_mut().spawn((RigidBody::Fixed, at(x, 0.0))).id());
    let part = app.world_mut().spawn((cube(0.5), ChildOf(first))).id();
    let group = app.world_mut().spawn(at(0.0, 9.0)).id();
    let wall = app.world_mut().spawn((cube(0.5), ChildOf(group))).id();
    run(&mut app, 2);
    app.world_mut().entity_mut(part).insert(ChildOf(second));
    edit::<Transform>(&mut app, part).scale = Vec3::ZERO;
    edit::<Transform>(&mut app, group).translation.x = f32::NAN;
    run(&mut app, 8);
    let reports = take_reports(&mut app);
    let count = |entity| reports.iter().filter(|(reported, _)| *reported == entity).count();
    assert_eq!((count(part), count(wall), reports.len()), (1, 1, 2));
    // Valid values are the next attempt.
    edit::<Transform>(&mut app, part).scale = Vec3::ONE;
    edit::<Transform>(&mut app, group).translation.x = 3.0;
    run(&mut app, 2);
    assert!(take_reports(&mut app).is_empty());
    let world = physics(&app);
    assert_near(world.collider(part).unwrap().position().translation.x, 9.0, 1.0e-5);
    assert_near(world.collider(wall).unwrap().position().translation.x, 3.0, 1.0e-5);
}

#[test]
fn a_body_that_leaves_the_range_of_numbers_is_reported() {
    let mut app = reporting();
    let body = app.world_mut().spawn((RigidBody::Dynamic, cube(0.5))).id();
    run(&mut app, 2);
    edit::<ExternalForce>(&mut app, body).force = vector(1.0e30, 0.0);
    run(&mut app, 2);
    let reports = take_reports(&mut app);
    assert_eq!(reports.len(), 1);
    assert_eq!(reports[0].0, body);
    assert!(matches!(reports[0].1, Invalid::Motion(_)));
    assert!(position(&app, body).is_finite());
}
