//! Joints: their motion, their edits, and their end.

use crate::dim::{BALL_GYRATION, HINGE, cube, hinge, vector};
use crate::plugin::prelude::*;
use crate::scene::*;
use bevy::prelude::*;

fn bodies(app: &mut App, distance: f32) -> [Entity; 2] {
    let post = app.world_mut().spawn(RigidBody::Fixed).id();
    let ball = (RigidBody::Dynamic, Collider::ball(0.2), ColliderMass::Mass(1.0));
    [post, app.world_mut().spawn((ball, at(0.0, -distance))).id()]
}

#[test]
fn a_pendulum_has_the_period_of_its_length() {
    let mut app = app();
    let (length, radius) = (2.0_f64, 0.2_f64);
    let [post, bob] = bodies(&mut app, 2.0);
    let (sine, cosine) = 0.1_f32.sin_cos();
    *edit::<Transform>(&mut app, bob) =
        at(2.0 * sine, -2.0 * cosine).with_rotation(Quat::from_rotation_z(0.1));
    let joint = hinge(post, bob).with_anchors(Vector::ZERO, vector(0.0, 2.0));
    app.world_mut().spawn(joint);
    let mut crossings = Vec::new();
    let mut last = f64::from(2.0 * sine);
    for frame in 0..64 * 10 {
        app.update();
        let x = f64::from(position(&app, bob).x);
        if last < 0.0 && x >= 0.0 {
            crossings.push((frame as f64 - x / (x - last)) / 64.0);
        }
        last = x;
    }
    let [first, .., end] = crossings[..] else { panic!("{crossings:?}") };
    let period = (end - first) / (crossings.len() - 1) as f64;
    // A physical pendulum: T = 2π √((L² + k²) / (g L)), and 1 + θ²/16 for the amplitude θ.
    let gyration = f64::from(BALL_GYRATION) * radius * radius;
    let expected = core::f64::consts::TAU
        * ((length * length + gyration) / (f64::from(G) * length)).sqrt()
        * (1.0 + 0.01 / 16.0);
    assert_near(period, expected, 0.005 * expected);
}

#[test]
fn a_rope_ends_a_fall_at_its_length() {
    let mut app = app();
    let [post, ball] = bodies(&mut app, 0.5);
    app.world_mut().spawn(Joint::rope(post, ball, 2.0));
    run(&mut app, 64 * 5);
    assert_near(position(&app, ball).y, -2.0, 0.02);
}

#[test]
fn a_spring_stretches_by_the_weight_over_its_stiffness() {
    let mut app = app();
    let [post, ball] = bodies(&mut app, 1.0);
    app.world_mut().spawn(Joint::spring(post, ball, 1.0, 50.0, 5.0));
    run(&mut app, 64 * 20);
    assert_near(position(&app, ball).y, -1.0 - f64::from(G) / 50.0, 0.002);
}

#[test]
fn a_slider_keeps_its_axis_and_its_limits() {
    let mut app = app();
    let [post, ball] = bodies(&mut app, 0.0);
    let slider = Joint::prismatic(post, ball, vector(0.0, 1.0)).with_contacts(false);
    app.world_mut().spawn(slider.with_limits(JointAxis::LinX, [-1.5, 1.5]));
    edit::<Velocity>(&mut app, ball).linear = vector(3.0, 0.0);
    run(&mut app, 64 * 3);
    assert_near(position(&app, ball).x, 0.0, 0.01);
    assert_near(position(&app, ball).y, -1.5, 0.02);
}

#[test]
fn a_motor_reaches_its_velocity_and_an_edit_stops_it() {
    let mut app = weightless();
    let [post, wheel] = bodies(&mut app, 0.0);
    let joint = hinge(post, wheel).with_motor_velocity(HINGE, 3.0, 10.0);
    let joint = app.world_mut().spawn(joint).id();
    run(&mut app, 128);
    assert_near(crate::dim::angle(get::<Velocity>(&app, wheel).angular), 3.0, 0.02);
    let stopped = get::<Joint>(&app, joint).with_motor_velocity(HINGE, 0.0, 10.0);
    *edit::<Joint>(&mut app, joint) = stopped;
    run(&mut app, 128);
    assert_near(crate::dim::angle(get::<Velocity>(&app, wheel).angular), 0.0, 0.02);
    assert_eq!(counts(&app)[2], 1);
}

#[test]
fn a_fixed_joint_holds_the_weight_and_reports_it() {
    let mut app = app();
    let [post, ball] = bodies(&mut app, 1.0);
    let joint = Joint::fixed(post, ball).with_anchors(vector(0.0, -1.0), Vector::ZERO);
    let joint = app.world_mut().spawn(joint).id();
    run(&mut app, 64);
    assert_near(position(&app, ball).y, -1.0, 0.01);
    let force = physics(&app).joint(joint).expect("a joint").force();
    assert_near(force.length(), G, 0.05);
}

#[derive(Resource, Default)]
struct Broken(Vec<JointBroken>);

#[test]
fn an_overloaded_joint_breaks_once() {
    let mut app = app();
    app.init_resource::<Broken>();
    app.add_observer(|on: On<JointBroken>, mut broken: ResMut<Broken>| broken.0.push(*on));
    let [post, ball] = bodies(&mut app, 1.0);
    let joint = Joint::fixed(post, ball).with_anchors(vector(0.0, -1.0), Vector::ZERO);
    let joint = app.world_mut().spawn(joint.with_break_thresholds(20.0, 1.0e9)).id();
    run(&mut app, 64);
    assert!(app.world().resource::<Broken>().0.is_empty());
    edit::<ExternalForce>(&mut app, ball).force = vector(0.0, -30.0);
    run(&mut app, 64);
    let broken = &app.world().resource::<Broken>().0;
    assert_eq!(broken.len(), 1);
    assert_eq!(broken[0].entity, joint);
    assert!(broken[0].force > 20.0);
    assert!(position(&app, ball).y < -5.0);
}

#[test]
fn joints_end_with_their_entity_and_pause_without_a_body() {
    let mut app = app();
    let [post, ball] = bodies(&mut app, 1.0);
    let joint = app.world_mut().spawn(Joint::rope(post, ball, 1.0)).id();
    run(&mut app, 2);
    assert_eq!(counts(&app)[2], 1);
    app.world_mut().entity_mut(post).remove::<RigidBody>();
    run(&mut app, 2);
    assert_eq!(counts(&app)[2], 0);
    app.world_mut().entity_mut(post).insert(RigidBody::Fixed);
    run(&mut app, 2);
    assert_eq!(counts(&app)[2], 1);
    assert_eq!(
        physics(&app).joint(joint).expect("a joint").body1(),
        physics(&app).body_handle(post).expect("a body")
    );
    app.world_mut().entity_mut(joint).despawn();
    run(&mut app, 2);
    assert_eq!(counts(&app)[2], 0);
}

#[test]
fn a_joint_with_other_bodies_is_inserted_anew() {
    let mut app = weightless();
    let [post, ball] = bodies(&mut app, 1.0);
    let other = app.world_mut().spawn((RigidBody::Dynamic, cube(0.1), at(5.0, 0.0))).id();
    let joint = app.world_mut().spawn(Joint::rope(post, ball, 1.0)).id();
    run(&mut app, 2);
    edit::<Joint>(&mut app, joint).body2 = other;
    run(&mut app, 2);
    assert_eq!(counts(&app)[2], 1);
    let handle = physics(&app).joint(joint).expect("a joint").body2();
    assert_eq!(physics(&app).entity_of_body(handle), Some(other));
}

#[test]
fn a_joint_that_waits_for_a_body_lets_the_old_ones_go() {
    let mut app = app();
    let [post, ball] = bodies(&mut app, 1.0);
    let joint = app.world_mut().spawn(Joint::rope(post, ball, 1.0)).id();
    let later = app.world_mut().spawn(at(5.0, 0.0)).id();
    run(&mut app, 32);
    edit::<Joint>(&mut app, joint).body2 = later;
    run(&mut app, 32);
    assert_eq!(counts(&app)[2], 0);
    assert!(position(&app, ball).y < -1.5);
    app.world_mut().entity_mut(later).insert(RigidBody::Dynamic);
    run(&mut app, 2);
    assert_eq!(counts(&app)[2], 1);
}

#[test]
fn a_refused_edit_of_the_bodies_keeps_the_joint() {
    let mut app = app();
    let [post, ball] = bodies(&mut app, 1.0);
    let other = app.world_mut().spawn((RigidBody::Fixed, at(5.0, 0.0))).id();
    let joint = app.world_mut().spawn(Joint::rope(post, ball, 1.0)).id();
    run(&mut app, 2);
    // The engine refuses joints of two fixed bodies.
    edit::<Joint>(&mut app, joint).body2 = other;
    run(&mut app, 32);
    assert_eq!(counts(&app)[2], 1);
    assert_near(position(&app, ball).y, -1.0, 0.02);
}
