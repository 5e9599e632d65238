//! Hierarchies of entities, and scales.

use crate::dim::{cube, floor, vector};
use crate::plugin::prelude::*;
use crate::scene::*;
use bevy::prelude::*;

/// World position of an entity's collider in the engine.
fn collider_at(app: &App, entity: Entity) -> [f64; 2] {
    let position = physics(app).collider(entity).expect("a collider").position().translation;
    [f64::from(position.x), f64::from(position.y)]
}

#[track_caller]
fn assert_at(found: [f64; 2], expected: [f64; 2]) {
    assert_near(found[0], expected[0], 1.0e-5);
    assert_near(found[1], expected[1], 1.0e-5);
}

#[test]
fn colliders_belong_to_the_nearest_body_above_them() {
    let mut app = weightless();
    let quarter = Quat::from_rotation_z(core::f32::consts::FRAC_PI_2);
    let body =
        app.world_mut().spawn((RigidBody::Dynamic, at(10.0, 0.0).with_rotation(quarter))).id();
    let arm = app.world_mut().spawn((at(2.0, 0.0).with_rotation(quarter), ChildOf(body))).id();
    let hand = app.world_mut().spawn((cube(0.5), at(1.0, 0.0), ChildOf(arm))).id();
    run(&mut app, 2);
    let world = physics(&app);
    assert_eq!(world.collider(hand).unwrap().parent(), world.body_handle(body));
    // 2 along the body's x axis, which is the world's y; then 1 along -x.
    assert_at(collider_at(&app, hand), [9.0, 2.0]);
    // A child moves on its body without waking anything else.
    edit::<Transform>(&mut app, hand).translation.x = 3.0;
    run(&mut app, 2);
    let relative = physics(&app).collider(hand).unwrap().position_wrt_parent().unwrap().translation;
    assert_at([f64::from(relative.x), f64::from(relative.y)], [2.0, 3.0]);
}

#[test]
fn a_collider_moves_with_its_ancestors_until_it_gets_another_body() {
    let mut app = weightless();
    let first = app.world_mut().spawn((RigidBody::Fixed, at(1.0, 0.0))).id();
    let second = app.world_mut().spawn((RigidBody::Fixed, at(5.0, 0.0))).id();
    let part = app.world_mut().spawn((cube(0.5), at(0.0, 1.0), ChildOf(first))).id();
    run(&mut app, 2);
    assert_at(collider_at(&app, part), [1.0, 1.0]);
    app.world_mut().entity_mut(part).insert(ChildOf(second));
    run(&mut app, 2);
    assert_at(collider_at(&app, part), [5.0, 1.0]);
    assert_eq!(physics(&app).collider(part).unwrap().parent(), physics(&app).body_handle(second));
    app.world_mut().entity_mut(part).remove::<ChildOf>();
    run(&mut app, 2);
    assert_at(collider_at(&app, part), [0.0, 1.0]);
    assert_eq!(physics(&app).collider(part).unwrap().parent(), None);
}

#[test]
fn a_detached_collider_has_the_pose_and_the_scale_of_its_own_transform() {
    let mut app = weightless();
    let group = app.world_mut().spawn(at(2.0, 0.0).with_scale(Vec3::splat(2.0))).id();
    let wall = app.world_mut().spawn((cube(0.5), at(0.0, 1.0), ChildOf(group))).id();
    let bundle = (RigidBody::Fixed, cube(0.5), at(3.0, 0.0), ChildOf(group));
    let body = app.world_mut().spawn(bundle).id();
    run(&mut app, 2);
    let right = |app: &App, entity| {
        physics(app).collider(entity).expect("a collider").compute_aabb().maxs.x
    };
    assert_at(collider_at(&app, wall), [2.0, 2.0]);
    assert_eq!([wall, body].map(|entity| right(&app, entity)), [3.0, 9.0]);
    for entity in [wall, body] {
        app.world_mut().entity_mut(entity).remove::<ChildOf>();
    }
    run(&mut app, 2);
    assert_at(collider_at(&app, wall), [0.0, 1.0]);
    assert_eq!([wall, body].map(|entity| right(&app, entity)), [0.5, 3.5]);
}

#[test]
fn scenery_moves_with_its_transform() {
    let mut app = weightless();
    let group = app.world_mut().spawn(at(2.0, 0.0)).id();
    let wall = app.world_mut().spawn((cube(0.5), at(0.0, 1.0), ChildOf(group))).id();
    run(&mut app, 2);
    assert_at(collider_at(&app, wall), [2.0, 1.0]);
    edit::<Transform>(&mut app, group).translation.x = 7.0;
    run(&mut app, 2);
    assert_at(collider_at(&app, wall), [7.0, 1.0]);
}

#[test]
fn a_compound_body_of_children_has_their_mass() {
    let mut app = weightless();
    let body = app.world_mut().spawn(RigidBody::Dynamic).id();
    for x in [-1.0, 1.0] {
        app.world_mut().spawn((cube(0.5), ColliderMass::Mass(3.0), at(x, 0.0), ChildOf(body)));
    }
    edit::<ExternalImpulse>(&mut app, body).impulse = vector(12.0, 0.0);
    run(&mut app, 4);
    let engine_body = physics(&app).body(body).unwrap();
    assert_near(engine_body.mass(), 6.0, 1.0e-5);
    assert_near(get::<Velocity>(&app, body).linear.x, 2.0, 1.0e-5);
}

#[test]
fn a_scale_applies_to_shapes_and_to_offsets() {
    let mut app = app();
    app.world_mut().spawn((floor(), at(0.0, -1.0)));
    let body = app.world_mut().spawn((RigidBody::Dynamic, cube(0.5), at(0.0, 1.0))).id();
    edit::<Transform>(&mut app, body).scale = Vec3::splat(2.0);
    let part = app.world_mut().spawn((cube(0.5), at(3.0, 0.0), ChildOf(body))).id();
    run(&mut app, 128);
    assert_near(position(&app, body).y, 1.0, 0.01);
    assert_near(collider_at(&app, part)[0], 6.0, 0.01);
    assert_eq!(get::<Transform>(&app, body).scale, Vec3::splat(2.0));
    // Half of the size, half of the height.
    edit::<Transform>(&mut app, body).scale = Vec3::splat(1.0);
    run(&mut app, 128);
    assert_near(position(&app, body).y, 0.5, 0.01);
    assert_near(collider_at(&app, part)[0], 3.0, 0.01);
}

#[test]
fn an_uneven_scale_makes_an_ellipse_of_a_ball() {
    let mut app = weightless();
    let scale = Vec3::new(3.0, 1.0, 1.0);
    let ball = app.world_mut().spawn((Collider::ball(1.0), Transform::from_scale(scale))).id();
    run(&mut app, 2);
    let bounds = physics(&app).collider(ball).unwrap().compute_aabb();
    assert_near(bounds.maxs.x, 3.0, 0.05);
    assert_near(bounds.maxs.y, 1.0, 0.05);
}

#[test]
fn a_body_below_another_moves_on_its_own() {
    let mut app = weightless();
    let carrier = (RigidBody::Dynamic, cube(0.5), Velocity::linear(vector(1.0, 0.0)));
    let carrier = app.world_mut().spawn(carrier).id();
    let bundle = (RigidBody::Dynamic, cube(0.5), at(0.0, 5.0), ChildOf(carrier));
    let passenger = app.world_mut().spawn(bundle).id();
    run(&mut app, 64);
    // In the world it rests; relative to its parent it moves back.
    let pose = physics(&app).body(passenger).unwrap().position().translation;
    assert_near(pose.x, 0.0, 1.0e-6);
    assert_near(pose.y, 5.0, 1.0e-6);
    assert_near(position(&app, carrier).x, 1.0, 1.0e-4);
    assert_near(position(&app, passenger).x, -1.0, 1.0e-4);
    assert_near(get::<GlobalTransform>(&app, passenger).translation().x, 0.0, 1.0e-4);
}

#[test]
fn a_moved_group_takes_its_bodies_along() {
    let mut app = app();
    let group = app.world_mut().spawn(at(10.0, 0.0)).id();
    let ground =
        app.world_mut().spawn((RigidBody::Fixed, floor(), at(0.0, -1.0), ChildOf(group))).id();
    let body =
        app.world_mut().spawn((RigidBody::Dynamic, cube(0.5), at(0.0, 0.5), ChildOf(group))).id();
    run(&mut app, 64);
    assert_near(physics(&app).body(body).unwrap().position().translation.x, 10.0, 0.01);
    edit::<Transform>(&mut app, group).translation.y = 4.0;
    run(&mut app, 64);
    assert_near(physics(&app).body(ground).unwrap().position().translation.y, 3.0, 1.0e-5);
    assert_near(position(&app, ground).y, -1.0, 0.0);
    assert_near(position(&app, body).y, 0.5, 0.01);
    assert_near(get::<GlobalTransform>(&app, body).translation().y, 4.5, 0.01);
}

#[test]
fn a_body_follows_its_transform_to_another_parent() {
    let mut app = weightless();
    let groups = [10.0, 20.0].map(|x| app.world_mut().spawn(at(x, 0.0)).id());
    let body = (RigidBody::Fixed, cube(0.5), at(1.0, 0.0), ChildOf(groups[0]));
    let body = app.world_mut().spawn(body).id();
    let engine_x = |app: &App| physics(app).body(body).unwrap().position().translation.x;
    run(&mut app, 2);
    assert_near(engine_x(&app), 11.0, 1.0e-5);
    app.world_mut().entity_mut(body).insert(ChildOf(groups[1]));
    run(&mut app, 2);
    assert_near(engine_x(&app), 21.0, 1.0e-5);
    app.world_mut().entity_mut(body).remove::<ChildOf>();
    run(&mut app, 2);
    assert_near(engine_x(&app), 1.0, 1.0e-5);
    assert_near(position(&app, body).x, 1.0, 1.0e-5);
}

#[test]
fn a_body_below_a_kinematic_body_moves_by_friction_alone() {
    let mut app = app();
    let platform = app.world_mut().spawn((RigidBody::KinematicPosition, floor())).id();
    let bundle = (RigidBody::Dynamic, cube(0.5), at(0.0, 1.5), ChildOf(platform));
    let rider = app.world_mut().spawn(bundle).id();
    run(&mut app, 64);
    for _ in 0..64 {
        edit::<Transform>(&mut app, platform).translation.x += 1.0 / 64.0;
        app.update();
    }
    let pose = physics(&app).body(rider).unwrap().position().translation;
    assert_near(position(&app, platform).x, 1.0, 1.0e-4);
    // It slides by v² / (2 μ g) = 0.1 until it has the speed of the platform.
    assert_near(pose.x, 0.9, 0.03);
    assert_near(position(&app, rider).x, -0.1, 0.03);
}
