//! Motion of bodies against formulas of mechanics.

use crate::dim::{angle, cube, floor, rotation, vector};
use crate::plugin::prelude::*;
use crate::scene::*;
use bevy::prelude::*;

fn ball(app: &mut App, bundle: impl Bundle) -> Entity {
    app.world_mut().spawn((RigidBody::Dynamic, Collider::ball(0.5), bundle)).id()
}

#[test]
fn a_body_in_free_fall_has_the_velocity_g_t() {
    let mut app = app();
    let ball = ball(&mut app, at(0.0, 10.0));
    run(&mut app, 64);
    let velocity = get::<Velocity>(&app, ball).linear;
    assert_near(velocity.y, -G, 1.0e-5 * f64::from(G));
    // A step moves the body by between g·dt²/2 and g·dt² more than the last one.
    let fallen = f64::from(10.0 - position(&app, ball).y);
    assert_near(fallen, f64::from(0.5 * G), f64::from(0.5 * G * DT));
}

#[test]
fn a_box_rests_at_its_half_height_and_falls_asleep() {
    let mut app = app();
    app.world_mut().spawn((floor(), at(0.0, -1.0)));
    let body = app.world_mut().spawn((RigidBody::Dynamic, cube(0.5), at(0.0, 2.0))).id();
    assert!(!get::<Sleeping>(&app, body).is_sleeping());
    run(&mut app, 64 * 8);
    assert_near(position(&app, body).y, 0.5, 0.005);
    assert!(get::<Sleeping>(&app, body).is_sleeping());
    assert_eq!(get::<Velocity>(&app, body).linear, Vector::ZERO);
}

#[test]
fn a_collision_keeps_the_momentum_and_elastic_bodies_keep_the_energy() {
    let mut app = weightless();
    let elastic = (Restitution::new(1.0), Friction::new(0.0));
    let light = (at(-3.0, 0.0), Velocity::linear(vector(4.0, 0.0)), ColliderMass::Mass(1.0));
    let light = ball(&mut app, (light, elastic));
    let heavy = ball(&mut app, (at(0.0, 0.0), ColliderMass::Mass(3.0), elastic));
    run(&mut app, 128);
    let [v1, v2] = [light, heavy].map(|entity| get::<Velocity>(&app, entity).linear.x);
    assert_near(v1 + 3.0 * v2, 4.0, 1.0e-4);
    // (m1 - m2) / (m1 + m2) · v and 2 m1 / (m1 + m2) · v
    assert_near(v1, -2.0, 0.02);
    assert_near(v2, 2.0, 0.02);
}

#[test]
fn a_force_acts_in_every_step_and_an_impulse_in_one() {
    let mut app = weightless();
    let mass = ColliderMass::Mass(2.0);
    let force = ExternalForce { force: vector(6.0, 0.0), ..default() };
    let pushed = ball(&mut app, (mass, at(0.0, 5.0), force));
    let impulse = ExternalImpulse { impulse: vector(6.0, 0.0), ..default() };
    let kicked = ball(&mut app, (mass, at(0.0, -5.0), impulse));
    run(&mut app, 64);
    assert_near(get::<Velocity>(&app, pushed).linear.x, 3.0, 1.0e-4);
    assert_near(get::<Velocity>(&app, kicked).linear.x, 3.0, 1.0e-4);
    assert_eq!(*get::<ExternalImpulse>(&app, kicked), ExternalImpulse::default());
    *edit::<ExternalForce>(&mut app, pushed) = ExternalForce::default();
    edit::<ExternalImpulse>(&mut app, kicked).impulse = vector(2.0, 0.0);
    run(&mut app, 64);
    assert_near(get::<Velocity>(&app, pushed).linear.x, 3.0, 1.0e-4);
    assert_near(get::<Velocity>(&app, kicked).linear.x, 4.0, 1.0e-4);
}

#[test]
fn settings_of_a_body_take_effect_at_the_start_and_later() {
    let mut app = app();
    let floating = ball(&mut app, (at(-5.0, 0.0), GravityScale(0.0)));
    let held = ball(&mut app, (at(0.0, 0.0), LockedAxes::TRANSLATION));
    let damping = Damping { linear: 1.0, angular: 0.0 };
    let slowed = ball(
        &mut app,
        (at(5.0, 0.0), damping, GravityScale(0.0), Velocity::linear(vector(0.0, 8.0))),
    );
    run(&mut app, 64);
    assert_eq!(position(&app, floating).y, 0.0);
    assert_eq!(position(&app, held).y, 0.0);
    // exp(-t), within the error of the integration
    assert_near(get::<Velocity>(&app, slowed).linear.y, 8.0 * (-1.0_f64).exp(), 0.05);
    edit::<GravityScale>(&mut app, floating).0 = 0.5;
    *edit::<LockedAxes>(&mut app, held) = LockedAxes::ROTATION;
    *edit::<Damping>(&mut app, slowed) = Damping::default();
    run(&mut app, 64);
    assert_near(get::<Velocity>(&app, floating).linear.y, -0.5 * G, 1.0e-4);
    assert_near(get::<Velocity>(&app, held).linear.y, -G, 1.0e-4);
    assert_near(get::<Velocity>(&app, slowed).linear.y, 8.0 * (-1.0_f64).exp(), 0.05);
}

#[test]
fn an_edited_transform_teleports_and_keeps_the_velocity() {
    let mut app = weightless();
    let moving = ball(&mut app, Velocity::linear(vector(1.0, 0.0)));
    run(&mut app, 64);
    assert_near(position(&app, moving).x, 1.0, 1.0e-5);
    edit::<Transform>(&mut app, moving).translation = Vec3::new(10.0, 3.0, 0.0);
    run(&mut app, 64);
    assert_near(position(&app, moving).x, 11.0, 1.0e-5);
    assert_near(position(&app, moving).y, 3.0, 0.0);
    edit::<Velocity>(&mut app, moving).linear = vector(0.0, 2.0);
    run(&mut app, 64);
    assert_near(position(&app, moving).x, 11.0, 1.0e-5);
    assert_near(position(&app, moving).y, 5.0, 1.0e-5);
}

#[test]
fn a_step_does_not_count_as_an_edit() {
    // Teleports wake a body: one that is written after each step would never sleep. The engine's own number
    // of digits is kept, too: in double precision a teleport would round the pose.
    let mut app = weightless();
    let start = crate::plugin::rapier::math::Vector::ZERO;
    let moving = ball(&mut app, Velocity::linear(vector(0.1, 0.0)));
    run(&mut app, 10);
    let mut expected = start;
    for _ in 0..10 {
        expected.x += 0.1 * DT;
    }
    let pose = physics(&app).body(moving).expect("a body").position().translation;
    assert_near(pose.x, expected.x, 4.0 * f64::from(Scalar::EPSILON));
}

#[test]
fn kinematic_bodies_follow_the_user_and_carry_others() {
    let mut app = app();
    let platform = app
        .world_mut()
        .spawn((RigidBody::KinematicVelocity, Velocity::linear(vector(1.0, 0.0)), floor()))
        .id();
    let rider = app.world_mut().spawn((RigidBody::Dynamic, cube(0.5), at(0.0, 1.5))).id();
    run(&mut app, 128);
    assert_near(position(&app, platform).x, 2.0, 1.0e-4);
    assert_near(get::<Velocity>(&app, rider).linear.x, 1.0, 1.0e-3);
    *edit::<RigidBody>(&mut app, platform) = RigidBody::KinematicPosition;
    for _ in 0..64 {
        edit::<Transform>(&mut app, platform).translation.x -= 1.0 / 64.0;
        app.update();
    }
    assert_near(position(&app, platform).x, 1.0, 1.0e-4);
    assert_near(get::<Velocity>(&app, platform).linear.x, -1.0, 1.0e-3);
    assert_near(get::<Velocity>(&app, rider).linear.x, -1.0, 1.0e-3);
}

#[test]
fn a_rotation_is_written_to_the_transform() {
    let mut app = weightless();
    let turn = Velocity::angular(rotation(2.0));
    let spinning = ball(&mut app, turn);
    let early = Transform::from_rotation(Quat::from_rotation_z(2.5));
    let turned = ball(&mut app, early.with_translation(Vec3::X * 4.0));
    run(&mut app, 64 * 2);
    let (axis, by) = get::<Transform>(&app, spinning).rotation.to_axis_angle();
    // 4 rad, which is more than half a turn
    let turned_by = if axis.z > 0.0 { by } else { core::f32::consts::TAU - by };
    assert_near(turned_by, 4.0, 1.0e-3);
    assert_near(angle(get::<Velocity>(&app, spinning).angular), 2.0, 1.0e-4);
    let (axis, by) = get::<Transform>(&app, turned).rotation.to_axis_angle();
    assert_near(axis.z * by, 2.5, 1.0e-5);
}

#[test]
fn the_time_step_is_that_of_bevy() {
    let mut app = app();
    app.insert_resource(Time::<Fixed>::from_hz(256.0));
    let ball = ball(&mut app, ());
    run(&mut app, 64);
    assert_near(get::<Velocity>(&app, ball).linear.y, -G, 1.0e-4);
    assert_near(physics(&app).engine.integration_parameters.dt, 1.0 / 256.0, 1.0e-9);
    // Four times as many steps, a quarter of the error.
    let fallen = f64::from(-position(&app, ball).y);
    assert_near(fallen, f64::from(0.5 * G), f64::from(0.125 * G * DT));
}

#[test]
fn a_fixed_body_has_no_velocity_and_gets_an_old_one_back() {
    let mut app = weightless();
    let velocity = Velocity::linear(vector(2.0, 0.0));
    let body = ball(&mut app, velocity);
    run(&mut app, 32);
    *edit::<RigidBody>(&mut app, body) = RigidBody::Fixed;
    run(&mut app, 32);
    assert_eq!(*get::<Velocity>(&app, body), Velocity::default());
    assert_near(position(&app, body).x, 1.0, 1.0e-5);
    *edit::<RigidBody>(&mut app, body) = RigidBody::Dynamic;
    *edit::<Velocity>(&mut app, body) = velocity;
    run(&mut app, 32);
    assert_near(position(&app, body).x, 2.0, 1.0e-5);
    // The same for a velocity that is set while the body is fixed.
    *edit::<RigidBody>(&mut app, body) = RigidBody::Fixed;
    run(&mut app, 2);
    *edit::<Velocity>(&mut app, body) = velocity;
    run(&mut app, 2);
    *edit::<RigidBody>(&mut app, body) = RigidBody::Dynamic;
    run(&mut app, 32);
    assert_near(position(&app, body).x, 3.0, 1.0e-5);
}

#[test]
fn the_impulse_of_a_refused_body_acts_after_its_insertion() {
    let mut app = weightless();
    let impulse = ExternalImpulse { impulse: vector(3.0, 0.0), ..default() };
    let body = ball(&mut app, (ColliderMass::Mass(1.0), at(f32::NAN, 0.0), impulse));
    run(&mut app, 4);
    assert!(physics(&app).body(body).is_none());
    *edit::<Transform>(&mut app, body) = at(0.0, 0.0);
    run(&mut app, 2);
    assert_near(get::<Velocity>(&app, body).linear.x, 3.0, 1.0e-5);
    assert_eq!(*get::<ExternalImpulse>(&app, body), ExternalImpulse::default());
}

#[test]
fn a_kinematic_body_teleports_by_a_change_of_its_type() {
    let mut app = app();
    let platform = app.world_mut().spawn((RigidBody::KinematicPosition, cube(0.5))).id();
    run(&mut app, 4);
    *edit::<RigidBody>(&mut app, platform) = RigidBody::KinematicVelocity;
    edit::<Transform>(&mut app, platform).translation.x = 50.0;
    app.update();
    assert_eq!(get::<Velocity>(&app, platform).linear, Vector::ZERO);
    *edit::<RigidBody>(&mut app, platform) = RigidBody::KinematicPosition;
    run(&mut app, 4);
    assert_eq!(position(&app, platform).x, 50.0);
}
