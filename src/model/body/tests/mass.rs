//! Additional mass.

use super::{EPSILON, about_z, assert_near, ball_mass};
use crate::dim::math::{ANG_ZERO, Vector, ang_length_squared};
use crate::model::body::{RigidBody, RigidBodyBuilder, RigidBodySet};
use crate::model::collider::{ColliderBuilder, ColliderSet};

/// A body whose colliders weigh what a ball off its origin does.
fn body_with_ball() -> RigidBody {
    let mut body = RigidBodyBuilder::dynamic().build();
    body.mprops.from_colliders = ball_mass(Vector::X);
    body.update_mass();
    body
}

#[test]
fn additional_mass_scales_the_inertia_and_leaves_the_center() {
    let (mut light, mut heavy) = (body_with_ball(), body_with_ball());
    heavy.set_additional_mass(light.mass() * 2.0, true);
    assert!((heavy.mass() / light.mass() - 3.0).abs() < EPSILON);
    assert_near(heavy.center_of_mass(), Vector::X);
    light.apply_torque_impulse(about_z(1.0), true);
    heavy.apply_torque_impulse(about_z(3.0), true);
    assert!(ang_length_squared(light.angvel() - heavy.angvel()) < EPSILON * EPSILON);
    heavy.set_additional_mass(0.0, true);
    assert!((heavy.mass() / light.mass() - 1.0).abs() < EPSILON);
}

#[test]
fn additional_mass_without_colliders_cannot_be_turned() {
    let mut body = RigidBodyBuilder::dynamic().additional_mass(2.0).build();
    assert!((body.mass() - 2.0).abs() < EPSILON);
    body.apply_impulse_at_point(Vector::Y, Vector::X, true);
    assert_near(body.linvel(), Vector::Y * 0.5);
    assert_eq!(body.angvel(), ANG_ZERO);
}

#[test]
fn additional_mass_properties_are_one_more_part() {
    let mut body = body_with_ball();
    let mass = body.mass();
    body.set_additional_mass_properties(ball_mass(-Vector::X), true);
    assert!((body.mass() / mass - 2.0).abs() < EPSILON);
    assert_near(body.center_of_mass(), Vector::ZERO);
    // Two balls a length unit from the axis: the parallel axis theorem.
    let ball = ball_mass(Vector::ZERO);
    let mut one = RigidBodyBuilder::dynamic().additional_mass_properties(ball).build();
    let spin = |body: &mut RigidBody, impulse| {
        body.apply_torque_impulse(about_z(impulse), true);
        ang_length_squared(body.angvel()).sqrt()
    };
    let inertia = 1.0 / spin(&mut one, 1.0);
    assert!((spin(&mut body, 2.0 * (inertia + mass)) - 1.0).abs() < EPSILON);
}

#[test]
fn a_body_without_mass_takes_no_impulse() {
    let mut body = RigidBodyBuilder::dynamic().build();
    body.apply_impulse(Vector::X, true);
    assert_eq!((body.mass(), body.linvel()), (0.0, Vector::ZERO));
}

/// Three balls, one of them off the line, put on one after the other.
fn body_with_colliders(bodies: &mut RigidBodySet, colliders: &mut ColliderSet) -> RigidBody {
    let handle = bodies.insert(RigidBodyBuilder::dynamic().translation(Vector::Y * 2.0));
    for place in [Vector::X * 2.0, Vector::Y * -3.0, Vector::ZERO] {
        let ball = ColliderBuilder::ball(0.5).density(2.0).translation(place);
        colliders.insert_with_parent(ball, handle, bodies);
    }
    bodies[handle].clone()
}

#[test]
fn colliders_weigh_as_soon_as_they_are_attached() {
    let (mut bodies, mut colliders) = (RigidBodySet::new(), ColliderSet::new());
    let attached = body_with_colliders(&mut bodies, &mut colliders);
    let mut summed = attached.clone();
    summed.recompute_mass_properties_from_colliders(&colliders);
    let ball = ball_mass(Vector::ZERO).mass();
    assert!((attached.mass() / ball - 3.0).abs() < EPSILON);
    assert_near(attached.local_center_of_mass(), Vector::X * (2.0 / 3.0) - Vector::Y);
    assert!((summed.mass() - attached.mass()).abs() < EPSILON);
    assert_near(summed.center_of_mass(), attached.center_of_mass());
    let spin = |mut body: RigidBody| {
        body.apply_torque_impulse(about_z(1.0), true);
        body.angvel()
    };
    let difference = spin(summed) - spin(attached);
    assert!(ang_length_squared(difference) < EPSILON * EPSILON);
}

#[test]
fn the_extent_reaches_around_all_colliders() {
    let (mut bodies, mut colliders) = (RigidBodySet::new(), ColliderSet::new());
    let mut body = body_with_colliders(&mut bodies, &mut colliders);
    let farthest = (Vector::Y * -3.0).distance(body.local_center_of_mass()) + 0.5;
    assert!(body.extent >= farthest - EPSILON, "{} {farthest}", body.extent);
    body.recompute_mass_properties_from_colliders(&colliders);
    assert!((body.extent - farthest).abs() < EPSILON, "{} {farthest}", body.extent);
}

#[test]
fn disabled_and_removed_colliders_weigh_nothing() {
    let (mut bodies, mut colliders) = (RigidBodySet::new(), ColliderSet::new());
    let mut body = body_with_colliders(&mut bodies, &mut colliders);
    colliders[body.colliders()[0]].set_enabled(false);
    body.detach_collider(body.colliders()[1]);
    body.recompute_mass_properties_from_colliders(&colliders);
    assert!((body.mass() / ball_mass(Vector::ZERO).mass() - 1.0).abs() < EPSILON);
    assert_near(body.local_center_of_mass(), Vector::ZERO);
}
