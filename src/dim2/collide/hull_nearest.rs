//! The place on a convex polygon that is nearest to a point.
//!
//! Inside, it is on the side that is least deep; outside, on the nearest of the sides that the point is
//! beyond.
//!
//! parry makes one side of neighbours that are nearly in a line, and keeps the normal of one of them. The
//! place is therefore checked: no corner may be above the line through it. Otherwise a general closest-point
//! search is used.

use crate::base::feature;
use crate::base::nearest::{Nearest, direction_and_length};
use crate::dim::math::{Real, Vector};
use parry::shape::{ConvexPolygon, PackedFeatureId, TypedShape};

/// The nearest point, if the shape is a convex polygon with sufficiently exact normals. If it is surely
/// farther than `reach`, a place in whose line the polygon is apart from the point will do.
pub fn nearest_on_hull(shape: TypedShape<'_>, point: Vector, reach: Real) -> Option<Nearest> {
    let TypedShape::ConvexPolygon(polygon) = shape else { return None };
    nearest_by_sides(polygon, point, reach).filter(|nearest| nearest.is_proven_by(polygon.points()))
}

fn nearest_by_sides(polygon: &ConvexPolygon, point: Vector, reach: Real) -> Option<Nearest> {
    let (corners, normals) = (polygon.points(), polygon.normals());
    let heights = (0..corners.len()).map(|side| (side, normals[side].dot(point - corners[side])));
    let (top, height) = heights.clone().max_by(|a, b| a.1.total_cmp(&b.1))?;
    let normal = normals[top];
    if height <= 0.0 || height > reach {
        let feature = feature::face(top as u32);
        return Some(Nearest { point: point - normal * height, normal, dist: height, feature });
    }
    let beyond = heights.filter(|(_, height)| *height > 0.0);
    let places = beyond.map(|(side, _)| on_side(polygon, side, point));
    let distance = |place: &(Vector, PackedFeatureId)| place.0.distance_squared(point);
    let (place, feature) = places.min_by(|a, b| distance(a).total_cmp(&distance(b)))?;
    let (normal, dist) = direction_and_length(point - place, normal);
    Some(Nearest { point: place, normal, dist, feature })
}

/// The nearest place on a side, and its feature.
fn on_side(polygon: &ConvexPolygon, side: usize, point: Vector) -> (Vector, PackedFeatureId) {
    let corners = polygon.points();
    let next = (side + 1) % corners.len();
    let (start, along) = (corners[side], corners[next] - corners[side]);
    let fraction: Real = along.dot(point - start) / along.length_squared();
    match fraction {
        fraction if fraction >= 1.0 => (corners[next], feature::vertex(next as u32)),
        fraction if fraction > 0.0 => (start + along * fraction, feature::face(side as u32)),
        _ => (start, feature::vertex(side as u32)),
    }
}
