//! Poses, velocities, kinematic targets, prediction.

use super::{about_z, assert_near, off_center_body};
use crate::dim::math::{ANG_ZERO, Pose, Real, Vector, ang_length_squared, rotation_from_angle};
use crate::model::body::{RigidBody, RigidBodyBuilder, RigidBodyChanges, RigidBodyType};

#[test]
fn a_body_turns_about_its_center_of_mass() {
    let mut body = off_center_body();
    body.set_angvel(about_z(2.0), true);
    body.set_linvel(Vector::Y * 3.0, true);
    let predicted = body.predict_position_using_velocity(0.5);
    let com = predicted * body.local_center_of_mass();
    assert_near(com, body.center_of_mass() + Vector::Y * 1.5);
    let turned = rotation_from_angle(about_z(1.0)) * *body.rotation();
    assert_near(predicted.rotation * Vector::X, turned * Vector::X);
    assert!(predicted.translation.distance(body.translation()) > 1.0);
}

#[test]
fn a_short_prediction_follows_the_velocity_of_every_point() {
    let mut body = off_center_body();
    body.set_angvel(about_z(-1.5), true);
    body.set_linvel(Vector::X, true);
    let (dt, local) = (1.0e-2, Vector::Y * 2.0);
    let point = *body.position() * local;
    let moved = body.predict_position_using_velocity(dt) * local;
    let speed = body.velocity_at_point(point);
    assert!(((moved - point) / dt - speed).length() < 0.1, "{moved} {speed}");
}

#[test]
fn forces_and_damping_bend_the_prediction() {
    let mut body = off_center_body();
    body.add_force(Vector::X * body.mass() * 4.0, true);
    let free = body.predict_position_using_velocity_and_forces(0.5).translation;
    assert_near(free, body.translation() + Vector::X);
    body.set_linear_damping(2.0);
    let damped = body.predict_position_using_velocity_and_forces(0.5).translation;
    assert_near(damped, body.translation() + Vector::X * 0.5);
}

#[test]
fn predictions_are_poses_for_any_input() {
    let mut body = off_center_body();
    body.set_linvel(Vector::X, true);
    for dt in [Real::NAN, Real::INFINITY, Real::NEG_INFINITY, Real::MAX] {
        assert_eq!(body.predict_position_using_velocity(dt), *body.position());
        assert!(body.predict_position_using_velocity_and_forces(dt).is_finite());
    }
}

/// The velocity that the step gives a kinematic body leads it exactly to its target.
#[test]
fn kinematic_bodies_reach_their_target() {
    let mut body = off_center_body();
    body.set_body_type(RigidBodyType::KinematicPositionBased, true);
    let target = Pose::from_parts(Vector::Y * 2.0, rotation_from_angle(about_z(-1.9)));
    body.set_next_kinematic_position(target);
    assert_eq!(*body.next_position(), target);
    let (dt, velocity) = (0.25, body.velocity_to_next_position(4.0));
    let reached = velocity.integrate(dt, body.position(), body.local_center_of_mass());
    assert_near(reached.translation, target.translation);
    assert_near(reached.rotation * Vector::X, target.rotation * Vector::X);
    body.set_next_kinematic_position(*body.position());
    assert!(body.velocity_to_next_position(4.0).is_zero());
}

#[test]
fn only_position_based_bodies_have_targets() {
    for body_type in [RigidBodyType::Dynamic, RigidBodyType::KinematicVelocityBased] {
        let mut body = RigidBodyBuilder::new(body_type).build();
        body.set_next_kinematic_translation(Vector::X);
        assert_eq!(body.next_position(), body.position());
    }
    let mut body = RigidBodyBuilder::kinematic_position_based().sleeping(true).build();
    body.set_next_kinematic_translation(Vector::X);
    body.set_next_kinematic_rotation(rotation_from_angle(about_z(1.0)));
    assert_eq!(body.next_position().translation, Vector::X);
    assert!(!body.is_sleeping(), "a target wakes");
    body.set_linvel(Vector::X, true);
    assert!(!body.is_moving(), "its velocity follows from the target");
}

#[test]
fn a_move_is_noted_and_takes_the_center_of_mass_along() {
    let mut body = off_center_body();
    body.changes = RigidBodyChanges::empty();
    body.set_position(*body.position(), true);
    assert_eq!(body.changes, RigidBodyChanges::empty(), "it did not move");
    let before = body.center_of_mass();
    body.set_translation(body.translation() + Vector::Y, true);
    assert_near(body.center_of_mass(), before + Vector::Y);
    assert_eq!(body.changes, RigidBodyChanges::POSITION);
}

fn set_everything(body: &mut RigidBody, bad: Real) {
    body.set_position(Pose::from_translation(Vector::X * bad), true);
    body.set_translation(Vector::Y * bad, true);
    body.set_linvel(Vector::X * bad, true);
    body.set_angvel(about_z(bad), true);
    body.set_gravity_scale(bad, true);
    body.set_linear_damping(bad);
    body.set_angular_damping(bad);
    body.set_soft_ccd_prediction(bad);
    body.set_additional_mass(bad, true);
    body.set_rotation(rotation_from_angle(about_z(bad)), true);
    let mut mass = *body.mprops.local_mprops();
    mass.inv_mass = bad;
    body.set_additional_mass_properties(mass, true);
}

#[test]
fn values_that_are_not_finite_are_refused() {
    let mut body = off_center_body();
    body.changes = RigidBodyChanges::empty();
    let before = format!("{body:?}");
    for bad in [Real::NAN, Real::INFINITY, Real::NEG_INFINITY] {
        set_everything(&mut body, bad);
    }
    // Finite, but their squares are not.
    body.set_linvel(Vector::X * Real::MAX.sqrt() * 2.0, true);
    body.set_translation(Vector::X * Real::MAX.sqrt() * 2.0, true);
    body.set_linear_damping(-1.0);
    body.set_additional_mass(-1.0, true);
    assert_eq!(format!("{body:?}"), before);
}

#[test]
fn a_body_that_becomes_fixed_stops() {
    let mut body = off_center_body();
    body.set_linvel(Vector::X, true);
    body.set_body_type(RigidBodyType::Fixed, true);
    assert_eq!((body.linvel(), body.angvel(), body.mass()), (Vector::ZERO, ANG_ZERO, 0.0));
    assert_eq!(body.mprops.inv_mass, Vector::ZERO);
    body.set_body_type(RigidBodyType::Dynamic, true);
    assert!(body.mass() > 0.0 && body.mprops.inv_mass.x > 0.0);
    body.apply_torque_impulse(about_z(1.0), true);
    assert!(ang_length_squared(body.angvel()) > 0.0);
}
