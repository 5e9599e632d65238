//! Building bodies, from good values and bad ones.

use super::about_z;
use crate::dim::math::{Pose, Real, Vector};
use crate::model::body::{RigidBody, RigidBodyBuilder};

#[test]
fn builders_set_all_properties() {
    let body = RigidBodyBuilder::kinematic_velocity_based()
        .translation(Vector::Y)
        .rotation(about_z(0.5))
        .linvel(Vector::X)
        .dominance_group(-3)
        .can_sleep(false)
        .ccd_enabled(true)
        .user_data(u128::MAX)
        .build();
    assert_eq!((body.translation(), body.linvel()), (Vector::Y, Vector::X));
    assert_eq!(body.next_position(), body.position());
    assert_eq!((body.dominance_group(), body.effective_dominance_group()), (-3, 128));
    assert!(body.activation().normalized_linear_threshold < 0.0);
    assert!(body.is_ccd_enabled());
    assert_eq!((body.user_data, body.user_data()), (u128::MAX, u128::MAX));
}

#[test]
fn a_bad_value_becomes_the_default_or_an_error_that_names_it() {
    let good = || RigidBodyBuilder::dynamic().linvel(Vector::X);
    let nan = Real::NAN;
    for (field, builder) in [
        ("position", good().translation(Vector::Y * nan)),
        ("position", good().rotation(about_z(nan))),
        ("position", good().pose(Pose::from_translation(Vector::Y * nan))),
        ("angvel", good().angvel(about_z(nan))),
        ("gravity_scale", good().gravity_scale(nan)),
        ("linear_damping", good().linear_damping(-1.0)),
        ("angular_damping", good().angular_damping(Real::INFINITY)),
        ("soft_ccd_prediction", good().soft_ccd_prediction(nan)),
        ("additional_mass", good().additional_mass(-1.0)),
    ] {
        let error = builder.try_build().expect_err(field);
        assert_eq!(error.field, field);
        assert!(error.to_string().contains(&error.value));
        let (mended, default) = (builder.build(), good().build());
        assert_eq!(format!("{mended:?}"), format!("{default:?}"), "{field}");
    }
    assert!(good().try_build().is_ok());
    let error = good().gravity_scale(nan).try_build().expect_err("gravity_scale");
    assert_eq!(error.to_string(), "the gravity_scale of a rigid body is NaN, which is invalid");
}

/// If it did, a body of a high group would fall through the ground.
#[test]
fn dominance_does_not_move_fixed_bodies() {
    let body = |group| RigidBodyBuilder::dynamic().dominance_group(group).build();
    let (low, high, fixed) = (body(-1), body(i8::MAX), RigidBodyBuilder::fixed().build());
    let dominance = RigidBody::dominance_of;
    assert!(dominance(Some(&high)) > dominance(Some(&low)));
    assert!(dominance(Some(&fixed)) > dominance(Some(&high)));
    assert!(dominance(None) > dominance(Some(&high)), "a collider without a body");
}
