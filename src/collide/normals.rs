//! Tolerances of normals.

use crate::dim::math::Real;

/// Least cosine of a contact normal and the normal of a face that count as equal (1.1 degrees).
pub(super) const FACE_NORMAL_COSINE_MIN: Real = 0.9998;
/// Least cosine of a direction and the normal of a face along it.
pub(super) const FACE_COSINE_MIN: Real = 0.5;
/// Largest squared distance of equal normals (0.06 degrees).
pub(crate) const NORMAL_DISTANCE_SQUARED_MAX: Real = 1.0e-6;
