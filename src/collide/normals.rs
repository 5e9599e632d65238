//! Tolerances of normals.

use crate::dim::math::Real;

/// A contact normal with at least this cosine to the normal of a face (1.1 degrees) is the normal of the
/// face.
pub(super) const FACE_NORMAL_COSINE_MIN: Real = 0.9998;
/// A face is along a direction if their cosine is at least this.
pub(super) const FACE_COSINE_MIN: Real = 0.5;
/// Normals whose difference has at most this squared length (0.06 degrees) are the same.
pub(crate) const NORMAL_DISTANCE_SQUARED_MAX: Real = 1.0e-6;
