//! Hulls of points in a plane: plates, which have two faces and no volume.

use super::math::{Real, Vector};
use crate::base::farthest::farthest_pair;
use crate::base::guard::guarded;
use crate::base::planar_hull::hull_corners;
use parry::shape::{ConvexPolyhedron, RoundShape, SharedShape};

/// The type of flat hulls.
pub type FlatHull = ConvexPolyhedron;

/// Largest distance of the points from their plane, as a fraction of their extent. Points this near to a
/// plane span so small a volume that they make no solid.
const DISTANCE_FRACTION_MAX: Real = 1.0e-3;
/// Least distance of a corner from the line through its neighbours, as a fraction of the extent: more than
/// rounding.
const CORNER_HEIGHT_FRACTION_MIN: Real = 1.0e-5;
/// Least distance of the points from their longest line, as a fraction of its length.
const WIDTH_FRACTION_MIN: Real = 1.0e-6;

/// The hull of finite points in a plane; `None` if they lie on a line, or do not lie in a plane.
pub fn flat_hull(points: &[Vector]) -> Option<FlatHull> {
    let [start, along, across] = plane_frame(points)?;
    let normal = along.cross(across);
    let extent = points.iter().map(|point| (*point - start).length()).fold(0.0, Real::max);
    let is_near =
        |point: &Vector| (*point - start).dot(normal).abs() <= DISTANCE_FRACTION_MAX * extent;
    if !points.iter().all(is_near) {
        return None;
    }
    let in_plane = |point: &Vector| [along, across].map(|axis| (*point - start).dot(axis));
    let seen: Vec<[Real; 2]> = points.iter().map(in_plane).collect();
    let corners: Vec<Vector> = hull_corners(&seen).into_iter().map(|i| points[i]).collect();
    let corners = without_straight(corners, start, CORNER_HEIGHT_FRACTION_MIN * extent);
    let triangles = both_sides(corners.len() as u32);
    let plate = guarded(|| ConvexPolyhedron::from_convex_mesh(corners, &triangles)).flatten();
    plate.filter(|plate| plate.faces().len() == 2)
}

/// The corners of a convex polygon without those near the line through their neighbours. Rounding makes such
/// corners of points on the sides, as of a grid. `start` is a corner in any case.
fn without_straight(mut corners: Vec<Vector>, start: Vector, height_min: Real) -> Vec<Vector> {
    let first = corners.iter().position(|corner| *corner == start).unwrap_or(0);
    corners.rotate_left(first);
    let mut kept: Vec<Vector> = Vec::with_capacity(corners.len() + 1);
    for &corner in corners.iter().chain(corners.first()) {
        while let [.., a, b] = kept[..] {
            let along = (corner - a).normalize_or_zero();
            let height = (b - a) - along * (b - a).dot(along);
            if height.length() > height_min {
                break;
            }
            kept.pop();
        }
        kept.push(corner);
    }
    kept.pop(); // The first corner closes the polygon.
    kept
}

/// A flat hull, enlarged by a layer.
pub fn rounded_flat_hull(inner_shape: FlatHull, border_radius: Real) -> SharedShape {
    SharedShape::new(RoundShape { inner_shape, border_radius })
}

/// A point, and two orthogonal unit vectors along the longest extent of points in a plane and across it.
fn plane_frame(points: &[Vector]) -> Option<[Vector; 3]> {
    let [start, end] = farthest_pair(points)?;
    let (along, length) = (end - start).normalize_and_length();
    let aside = |point: Vector| {
        let offset = point - start;
        offset - along * offset.dot(along)
    };
    let widest = points.iter().map(|point| aside(*point));
    let widest =
        widest.max_by(|p, q| p.length_squared().total_cmp(&q.length_squared())).unwrap_or_default();
    let is_wide = widest.length() > WIDTH_FRACTION_MIN * length;
    is_wide.then_some([start, along, widest.normalize_or_zero()])
}

/// The triangles of both sides of a convex polygon with this many corners. They begin at different corners,
/// so that two triangles share each edge.
fn both_sides(count: u32) -> Vec<[u32; 3]> {
    let front = (1..count.saturating_sub(1)).map(|corner| [0, corner, corner + 1]);
    let back = (0..count.saturating_sub(2)).map(|corner| [count - 1, corner + 1, corner]);
    front.chain(back).collect()
}
