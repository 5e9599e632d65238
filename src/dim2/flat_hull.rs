//! Hulls of points on a line: segments, which have no area.

use super::math::{Real, Vector};
use crate::base::farthest::farthest_pair;
use parry::shape::{Capsule, Segment, SharedShape};

/// The type of flat hulls.
pub type FlatHull = Segment;

/// Largest distance of the points from their line, as a fraction of its length. Points this near to a line
/// span so small an area that they make no polygon.
const DISTANCE_FRACTION_MAX: Real = 1.0e-3;

/// The hull of finite points on a line; `None` if they coincide, or do not lie on a line.
pub fn flat_hull(points: &[Vector]) -> Option<FlatHull> {
    let [start, end] = farthest_pair(points)?;
    let along = (end - start).try_normalize()?;
    let tolerance = DISTANCE_FRACTION_MAX * (end - start).length();
    let is_near = |point: &Vector| along.perp_dot(*point - start).abs() <= tolerance;
    points.iter().all(is_near).then_some(Segment::new(start, end))
}

/// A flat hull, enlarged by a layer.
pub fn rounded_flat_hull(flat: FlatHull, border_radius: Real) -> SharedShape {
    SharedShape::new(Capsule::new(flat.a, flat.b, border_radius))
}
