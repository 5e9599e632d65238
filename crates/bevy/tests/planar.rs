//! The z coordinate of a body in the plane belongs to the user.

use crate::dim::{cube, vector};
use crate::plugin::prelude::*;
use crate::scene::*;
use bevy::prelude::*;

fn sort_by_height(mut bodies: Query<&mut Transform, With<RigidBody>>) {
    for mut transform in &mut bodies {
        transform.translation.z = -transform.translation.y - transform.translation.x;
    }
}

#[test]
fn a_layer_that_changes_in_each_frame_keeps_the_motion() {
    for frame in [0.25, 1.0, 1.5] {
        let mut app = app_with(PhysicsPlugin::default().with_gravity(Vector::ZERO));
        app.add_systems(Update, sort_by_height);
        let velocity = Velocity::linear(vector(64.0, 0.0));
        let body = app.world_mut().spawn((RigidBody::Dynamic, cube(0.5), velocity)).id();
        frame_length(&mut app, frame);
        run(&mut app, (24.0 / frame) as usize);
        let engine = physics(&app).body(body).unwrap().position().translation;
        assert_eq!(engine.x, 24.0, "frames of {frame} steps");
        let shown = position(&app, body);
        assert_near(shown.z, -f64::from(shown.x), 1.0e-4);
        assert_near(shown.x, 23.0, 1.0e-4);
    }
}

#[test]
fn a_layer_does_not_wake_a_body() {
    let mut app = app();
    app.world_mut().spawn((cube(1.0), at(0.0, -1.0)));
    let body = app.world_mut().spawn((RigidBody::Dynamic, cube(0.5), at(0.0, 0.5))).id();
    run(&mut app, 64 * 4);
    assert!(get::<Sleeping>(&app, body).is_sleeping());
    edit::<Transform>(&mut app, body).translation.z = 7.0;
    run(&mut app, 2);
    assert!(get::<Sleeping>(&app, body).is_sleeping());
    assert_eq!(position(&app, body).z, 7.0);
}

#[test]
fn the_layer_of_a_nested_body_stays() {
    let mut app = weightless();
    let level = Transform::from_xyz(0.0, 0.0, 1.0).with_scale(Vec3::splat(0.5));
    let level = app.world_mut().spawn(level).id();
    let velocity = Velocity::linear(vector(1.0, 0.0));
    let place = Transform::from_xyz(0.0, 0.0, 3.0);
    let bundle = (RigidBody::Dynamic, cube(0.5), velocity, place, ChildOf(level));
    let body = app.world_mut().spawn(bundle).id();
    run(&mut app, 64);
    assert_eq!(position(&app, body).z, 3.0);
    assert_near(position(&app, body).x, 2.0, 1.0e-4);
}
