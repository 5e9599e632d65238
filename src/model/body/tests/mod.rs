//! Tests of the mathematics and the book-keeping of bodies, for every dimension and precision.

mod builder;
mod mass;
mod motion;
mod pushes;
mod set;

use super::{RigidBody, RigidBodyBuilder};
use crate::dim::math::{AngVector, Pose, Real, Vector, torque};
use parry::mass_properties::MassProperties;
use parry::shape::{Ball, Shape};

/// The allowance for rounding in either precision.
const EPSILON: Real = 1.0e-4;

/// An angular vector of a given size: about Z in 3D.
fn about_z(size: Real) -> AngVector {
    torque(Vector::X, Vector::Y) * size
}

/// A ball of radius ½ and density 2, whose centre is at `center` in the body's frame.
fn ball_mass(center: Vector) -> MassProperties {
    Ball::new(0.5).mass_properties(2.0).transform_by(&Pose::from_translation(center))
}

/// A dynamic body, off the origin and turned, whose centre of mass is far from its own origin.
fn off_center_body() -> RigidBody {
    RigidBodyBuilder::dynamic()
        .translation(Vector::X * 3.0 + Vector::Y)
        .rotation(about_z(0.8))
        .additional_mass_properties(ball_mass(Vector::X * 2.0))
        .build()
}

#[track_caller]
fn assert_near(a: Vector, b: Vector) {
    assert!(a.abs_diff_eq(b, EPSILON), "{a} is not near {b}");
}
