//! Convex polygons from points.
//!
//! parry's own constructors measure with absolute tolerances and merge neighbouring edges by their angle
//! alone, which dissolves a finely rounded outline. These measure relative to the size.

use super::math::{Real, Vector};
use crate::base::planar_hull;
use parry::shape::ConvexPolygon;

/// The type of convex hulls.
pub type ConvexShape = ConvexPolygon;

/// The reason why points have no hull.
pub const DEGENERATE_REASON: &str = "its points coincide";

/// Least height of a corner above the line through its neighbours, as a fraction of the size.
const CORNER_HEIGHT_FRACTION_MIN: Real = 1.0e-5;
/// Least area of a polygon, as a fraction of the squared size.
const AREA_MIN: Real = 1.0e-6;
/// Largest difference of the areas of a convex outline and its hull, as a fraction of the latter.
const DENT_MAX: Real = 1.0e-3;

/// The smallest convex polygon around finite points; `None` if they lie on a line.
pub fn convex_hull(points: &[Vector]) -> Option<ConvexPolygon> {
    polygon(hull_corners(points))
}

/// The polygon with the given finite corners, in order, in either orientation; `None` if it is not convex or
/// has no area.
pub fn convex_outline(mut corners: Vec<Vector>) -> Option<ConvexPolygon> {
    let hull_area = signed_area(&hull_corners(&corners));
    let area = signed_area(&corners);
    if area < 0.0 {
        corners.reverse();
    }
    if area.abs() < (1.0 - DENT_MAX) * hull_area { None } else { polygon(corners) }
}

fn polygon(mut corners: Vec<Vector>) -> Option<ConvexPolygon> {
    let lowest = corners.iter().copied().reduce(Vector::min)?;
    let highest = corners.iter().copied().reduce(Vector::max)?;
    let size = (highest - lowest).length();
    drop_flat_corners(&mut corners, CORNER_HEIGHT_FRACTION_MIN * size);
    if corners.len() < 3 || signed_area(&corners) < AREA_MIN * size * size {
        return None;
    }
    ConvexPolygon::from_convex_polyline_unmodified(corners)
}

/// The corners of the convex hull, counter-clockwise.
fn hull_corners(points: &[Vector]) -> Vec<Vector> {
    let plain: Vec<_> = points.iter().map(Vector::to_array).collect();
    planar_hull::hull_corners(&plain).into_iter().map(|i| points[i]).collect()
}

/// Drops corners that lie within `tolerance` of the line from the corner kept before to the next.
fn drop_flat_corners(corners: &mut Vec<Vector>, tolerance: Real) {
    let mut kept: Vec<Vector> = Vec::with_capacity(corners.len());
    for (i, &corner) in corners.iter().enumerate() {
        let next = corners[(i + 1) % corners.len()];
        let before = kept.last().copied().unwrap_or(corners[corners.len() - 1]);
        let chord = next - before;
        if chord.perp_dot(corner - before).abs() > tolerance * chord.length() {
            kept.push(corner);
        }
    }
    *corners = kept;
}

/// Area of a polygon, negative if its corners go round clockwise. Measured from one of its corners,
/// so that far from the origin no digits are lost.
pub fn signed_area(corners: &[Vector]) -> Real {
    let Some(&origin) = corners.first() else { return 0.0 };
    let fan = corners.windows(2).map(|side| (side[0] - origin).perp_dot(side[1] - origin));
    0.5 * fan.sum::<Real>()
}
