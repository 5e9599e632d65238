//! Small mathematical helpers.

use crate::math::{Real, Vector};

/// Number of coordinates less one.
pub const DIM_MINUS_ONE: usize = crate::math::DIM - 1;

/// The unit vector and the length of a vector that is longer than `threshold`.
pub fn try_normalize_and_get_length(v: Vector, threshold: Real) -> Option<(Vector, Real)> {
    let length = v.length();
    (length > threshold).then(|| (v / length, length))
}
