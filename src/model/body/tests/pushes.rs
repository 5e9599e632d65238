//! Forces, impulses, energy.

use super::{EPSILON, about_z, assert_near, ball_mass, off_center_body};
use crate::dim::axes::LockedAxes;
use crate::dim::mass::angular_momentum;
use crate::dim::math::{ANG_ZERO, AngVector, Real, Vector, ang_length_squared, torque};
use crate::model::body::{RigidBody, RigidBodyBuilder, RigidBodyType};

/// Angular momentum about the origin of the world: that of the centre of mass, and the spin about it.
fn momentum_about_origin(body: &RigidBody) -> AngVector {
    let spin = angular_momentum(&body.mprops.local_mprops, body.pose.rotation, body.angvel());
    torque(body.center_of_mass(), body.linvel() * body.mass()) + spin
}

#[test]
fn an_impulse_at_a_point_brings_its_momentum_and_its_moment() {
    let mut body = off_center_body();
    let impulse = Vector::splat(0.4) - Vector::X * 1.1;
    let point = Vector::splat(-0.7) + Vector::Y * 2.0;
    body.apply_impulse_at_point(impulse, point, true);
    assert_near(body.linvel() * body.mass(), impulse);
    let missing = momentum_about_origin(&body) - torque(point, impulse);
    assert!(ang_length_squared(missing) < EPSILON * EPSILON, "{missing:?}");
}

#[test]
fn an_impulse_through_the_center_of_mass_does_not_turn() {
    let mut body = off_center_body();
    body.apply_impulse_at_point(Vector::Y * 5.0, body.center_of_mass(), true);
    assert_eq!(body.angvel(), ANG_ZERO);
    assert_near(body.velocity_at_point(Vector::ZERO), body.linvel());
}

#[test]
fn locked_axes_take_no_impulse() {
    let mut body = RigidBodyBuilder::dynamic()
        .additional_mass_properties(ball_mass(Vector::ZERO))
        .locked_axes(LockedAxes::TRANSLATION_LOCKED_X)
        .lock_rotations()
        .build();
    body.apply_impulse_at_point(Vector::splat(1.0), Vector::X, true);
    assert_eq!((body.linvel().x, body.angvel()), (0.0, ANG_ZERO));
    assert!((body.linvel().y * body.mass() - 1.0).abs() < EPSILON);

    body.set_locked_axes(LockedAxes::empty(), true);
    body.apply_impulse_at_point(Vector::X, Vector::Y, true);
    assert!(body.linvel().x > 0.0);
    assert!(ang_length_squared(body.angvel()) > 0.0);
}

#[test]
fn only_dynamic_bodies_can_be_pushed() {
    for body_type in [
        RigidBodyType::Fixed,
        RigidBodyType::KinematicPositionBased,
        RigidBodyType::KinematicVelocityBased,
    ] {
        let mut body = RigidBodyBuilder::new(body_type).additional_mass(1.0).build();
        body.apply_impulse(Vector::X, true);
        body.apply_torque_impulse(about_z(1.0), true);
        body.add_force(Vector::X, true);
        assert!(!body.is_moving(), "{body_type:?}");
        assert_eq!(body.user_force(), Vector::ZERO);
    }
}

#[test]
fn forces_add_up_until_they_are_reset() {
    let mut body = off_center_body();
    body.add_force(Vector::Y, true);
    body.add_force_at_point(Vector::Y * 2.0, body.center_of_mass() + Vector::X, true);
    assert_eq!(body.user_force(), Vector::Y * 3.0);
    let expected = about_z(2.0);
    assert!(ang_length_squared(body.user_torque() - expected) < EPSILON * EPSILON);
    body.reset_forces(true);
    body.reset_torques(true);
    assert_eq!((body.user_force(), body.user_torque()), (Vector::ZERO, ANG_ZERO));
}

#[test]
fn an_impulse_that_is_not_finite_or_too_large_is_refused() {
    let mut body = off_center_body();
    body.set_linvel(Vector::X, true);
    for bad in [Real::NAN, Real::INFINITY, Real::MAX] {
        body.apply_impulse(Vector::Y * bad, true);
        body.apply_impulse(Vector::Y * bad, true);
        body.add_force_at_point(Vector::Y * bad, Vector::X * Real::MAX, true);
    }
    assert!(body.vels().is_finite());
    assert!(body.user_force().is_finite());
    assert_eq!(body.linvel().x, 1.0);
}

#[test]
fn only_a_push_with_wake_up_wakes_a_sleeper() {
    let mut body = off_center_body();
    body.sleep();
    body.apply_impulse(Vector::X, false);
    assert!(body.is_sleeping());
    body.apply_impulse(Vector::ZERO, true);
    assert!(body.is_sleeping(), "no push at all");
    body.apply_impulse(Vector::X, true);
    assert!(!body.is_sleeping());
    assert_eq!(body.activation().time_since_can_sleep, 0.0);
}

#[test]
fn kinetic_energy_is_the_work_of_the_impulse() {
    let mut body = off_center_body();
    let (impulse, point) = (Vector::splat(1.5), Vector::X * 4.0);
    body.apply_impulse_at_point(impulse, point, true);
    // An impulse on a body at rest does the work ½ J·v, with the velocity v that its point gets.
    let work = 0.5 * impulse.dot(body.velocity_at_point(point));
    assert!((body.kinetic_energy() - work).abs() < 1.0e-3 * work, "{work}");
}

#[test]
fn energy_is_constant_in_free_fall() {
    let (gravity, dt) = (Vector::Y * -9.81, 1.0 / 60.0);
    let mut body = off_center_body();
    let start = body.gravitational_potential_energy(0.0, gravity);
    for _ in 0..60 {
        body.set_linvel(body.linvel() + gravity * dt, true);
        body.set_position(body.predict_position_using_velocity(dt), true);
    }
    let end = body.kinetic_energy() + body.gravitational_potential_energy(dt, gravity);
    assert!(body.linvel().y < -9.0);
    assert!((end - start).abs() < 1.0e-2, "{start} became {end}");
}

#[test]
fn pushes_add_up_and_last_until_they_are_dropped() {
    let mut body = RigidBodyBuilder::dynamic().build();
    body.add_force(Vector::X, true);
    body.push(Vector::Y, ANG_ZERO);
    body.push(Vector::Y, ANG_ZERO);
    assert_eq!(body.pending_push().0, Vector::Y * 2.0);
    assert_eq!(body.user_force(), Vector::X);
    assert_eq!(body.forces().0, Vector::X + Vector::Y * 2.0);
    body.drop_push();
    assert!(!body.is_pushed());
    assert_eq!(body.forces().0, Vector::X);

    body.push(Vector::splat(Real::NAN), ANG_ZERO);
    assert!(!body.is_pushed());
    body.push(Vector::Y, ANG_ZERO);
    body.drop_push();
    assert_eq!(body.forces().0, Vector::X);
    body.set_body_type(RigidBodyType::Fixed, false);
    body.push(Vector::Y, ANG_ZERO);
    assert!(!body.is_pushed());
}
