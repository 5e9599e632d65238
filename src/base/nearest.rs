//! The place on a surface that is nearest to a point.

use parry::math::{Real, Vector};
use parry::shape::PackedFeatureId;

/// The place on a surface that is nearest to a point.
#[derive(Copy, Clone, Debug)]
pub struct Nearest {
    /// The place.
    pub point: Vector,
    /// Unit outward normal there.
    pub normal: Vector,
    /// Distance of the point from the surface, negative inside.
    pub dist: Real,
    /// The feature on which the place lies.
    pub feature: PackedFeatureId,
}

/// Unit vector and length; a zero vector points to `fallback`.
pub fn direction_and_length(vector: Vector, fallback: Vector) -> (Vector, Real) {
    let length = vector.length();
    if length > 0.0 { (vector / length, length) } else { (fallback, 0.0) }
}
