//! Frames between two steps.

use crate::dim::{cube, rotation, vector};
use crate::plugin::prelude::*;
use crate::scene::*;
use bevy::prelude::*;

/// A body that moves by 1 and rotates by 0.5 rad in each step.
fn moving(app: &mut App) -> Entity {
    let velocity = Velocity { linear: vector(64.0, 0.0), angular: rotation(32.0) };
    app.world_mut().spawn((RigidBody::Dynamic, cube(0.5), velocity)).id()
}

fn interpolated() -> App {
    app_with(PhysicsPlugin::default().with_gravity(Vector::ZERO))
}

#[test]
fn a_frame_shows_the_same_fraction_between_the_last_two_states() {
    let mut app = interpolated();
    let body = moving(&mut app);
    run(&mut app, 4);
    frame_length(&mut app, 0.25);
    for quarter in 0..12 {
        // The fixed clock is at step 4: the frames show the time since step 3.
        let shown = 3.0 + f64::from(quarter) * 0.25;
        if quarter > 0 {
            app.update();
        }
        assert_near(position(&app, body).x, shown, 1.0e-4);
        let state = physics(&app).body(body).unwrap().position().translation.x;
        assert_near(state, 4.0 + (f64::from(quarter) * 0.25).floor(), 1.0e-4);
    }
}

#[test]
fn rotations_take_the_short_way() {
    let mut app = interpolated();
    let body = moving(&mut app);
    run(&mut app, 4);
    frame_length(&mut app, 0.5);
    app.update();
    let expected = Quat::from_rotation_z(3.5 * 0.5);
    assert_near(get::<Transform>(&app, body).rotation.angle_between(expected), 0.0, 2.0e-3);
}

#[test]
fn without_interpolation_a_frame_shows_the_last_state() {
    let mut app = weightless();
    let body = moving(&mut app);
    run(&mut app, 4);
    frame_length(&mut app, 0.25);
    app.update();
    assert_near(position(&app, body).x, 4.0, 1.0e-4);
}

#[derive(Resource, Default)]
struct Seen(Vec<f32>);

#[test]
fn systems_in_the_fixed_schedule_read_exact_states() {
    let mut app = interpolated();
    let body = moving(&mut app);
    app.init_resource::<Seen>();
    app.add_systems(
        FixedUpdate,
        |bodies: Query<&Transform, With<RigidBody>>, mut seen: ResMut<Seen>| {
            seen.0.extend(bodies.iter().map(|transform| transform.translation.x));
        },
    );
    frame_length(&mut app, 0.75);
    run(&mut app, 16);
    let seen = &app.world().resource::<Seen>().0;
    assert_eq!(seen.len(), 12);
    for (step, x) in seen.iter().enumerate() {
        assert_near(*x, step as f64, 1.0e-4);
    }
    assert_near(position(&app, body).x, 11.0, 1.0e-4);
}

#[test]
fn a_teleport_between_two_steps_is_not_interpolated() {
    let mut app = interpolated();
    let body = moving(&mut app);
    run(&mut app, 4);
    frame_length(&mut app, 0.5);
    app.update();
    edit::<Transform>(&mut app, body).translation = Vec3::new(100.0, 0.0, 0.0);
    // The step moves the body from its new place: 100 to 101.
    app.update();
    assert_near(position(&app, body).x, 100.0, 1.0e-4);
    app.update();
    assert_near(position(&app, body).x, 100.5, 1.0e-4);
}

/// A body with a velocity whose multiples single precision rounds.
fn locked(app: &mut App) -> Entity {
    let velocity = Velocity::linear(vector(6.4, 0.0));
    let bundle = (RigidBody::Dynamic, cube(0.5), velocity, LockedAxes::ROTATION);
    app.world_mut().spawn(bundle).id()
}

#[test]
fn a_rotation_by_the_user_in_each_frame_keeps_the_motion() {
    let translation = |app: &App, body| physics(app).body(body).unwrap().position().translation;
    let mut undisturbed = interpolated();
    let reference = locked(&mut undisturbed);
    run(&mut undisturbed, 24);
    for frame in [0.25, 1.0, 1.5] {
        let mut app = interpolated();
        app.add_systems(Update, |mut bodies: Query<&mut Transform, With<RigidBody>>| {
            for mut transform in &mut bodies {
                transform.rotation *= Quat::from_rotation_z(0.01);
            }
        });
        let body = locked(&mut app);
        frame_length(&mut app, frame);
        let frames = (24.0 / frame) as usize;
        run(&mut app, frames);
        // The engine keeps its own number: neither interpolated nor rounded to single precision.
        assert_eq!(translation(&app, body), translation(&undisturbed, reference));
        assert_near(position(&app, body).x, 2.3, 1.0e-4);
        let rotation = Quat::from_rotation_z(0.01 * frames as f32);
        let found = get::<Transform>(&app, body).rotation.normalize();
        // Half of one frame's angle; `acos` magnifies the rounding of 96 products.
        assert_near(found.angle_between(rotation), 0.0, 5.0e-3);
    }
}

#[test]
fn a_translation_by_the_user_in_each_frame_keeps_the_rotation() {
    let mut app = interpolated();
    app.add_systems(Update, |mut bodies: Query<&mut Transform, With<RigidBody>>| {
        for mut transform in &mut bodies {
            transform.translation.y = 3.0;
        }
    });
    let velocity = Velocity::angular(rotation(3.2));
    let body = app.world_mut().spawn((RigidBody::Dynamic, cube(0.5), velocity)).id();
    frame_length(&mut app, 0.25);
    run(&mut app, 4 * 16);
    let expected = Quat::from_rotation_z(0.05 * 15.0);
    assert_near(get::<Transform>(&app, body).rotation.angle_between(expected), 0.0, 2.0e-3);
}

#[derive(Resource, Default)]
struct Writes(usize);

#[test]
fn a_frame_without_motion_changes_no_transform() {
    let mut app = interpolated();
    moving(&mut app);
    app.init_resource::<Writes>();
    app.add_systems(
        PostUpdate,
        |changed: Query<(), Changed<Transform>>, mut writes: ResMut<Writes>| {
            writes.0 += changed.iter().count();
        },
    );
    frame_length(&mut app, 0.75);
    run(&mut app, 4);
    assert_eq!(app.world().resource::<Writes>().0, 4);
    app.world_mut().resource_mut::<Time<Virtual>>().pause();
    run(&mut app, 4);
    assert_eq!(app.world().resource::<Writes>().0, 4);
}
