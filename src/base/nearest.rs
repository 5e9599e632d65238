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

/// Largest height of a corner above the plane of the nearest point, as a fraction of its distance from there.
const BULGE_RATIO_MAX: Real = 2.0e-3;

impl Nearest {
    /// Returns whether no corner of the hull lies above the plane through the nearest point.
    pub fn is_proven_by(&self, corners: &[Vector]) -> bool {
        corners.iter().all(|corner| {
            let from_place = *corner - self.point;
            let height = self.normal.dot(from_place);
            height <= 0.0
                || height * height
                    <= BULGE_RATIO_MAX * BULGE_RATIO_MAX * from_place.length_squared()
        })
    }
}

/// Unit vector and length; a zero vector points to `fallback`.
pub fn direction_and_length(vector: Vector, fallback: Vector) -> (Vector, Real) {
    let length = vector.length();
    if length > 0.0 { (vector / length, length) } else { (fallback, 0.0) }
}
