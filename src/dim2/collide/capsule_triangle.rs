//! A capsule and a triangle have no special algorithm in the plane.

use super::RawManifold;
use crate::dim::math::{Pose, Real};
use parry::shape::{Capsule, Triangle};

/// Computes nothing: the two use the algorithm of all polytopes.
pub fn capsule_triangle(
    _pos12: &Pose,
    _capsule: &Capsule,
    _triangle: &Triangle,
    _prediction: Real,
    _raw: &mut RawManifold,
) -> Option<Real> {
    None
}
