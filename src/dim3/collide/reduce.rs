//! At most four points of a manifold.

use super::RawPoint;
use crate::dim::math::{MAX_MANIFOLD_POINTS, Real, Vector, tangents};

/// Points whose depths differ by less than this fraction of the manifold's size count as equally deep.
const DEPTH_TOLERANCE: Real = 5.0e-3;

/// Keeps the deepest point and the three others that span the largest area with it.
///
/// Bodies on many points need four of them for stability. The first is the deepest, to prevent penetration,
/// and the second the one farthest from it. The third is the one farthest from the line through these two.
/// The fourth is the one farthest from the third on the other side of that line. If all are equally deep,
/// rounding must not choose: then the first is the one that is farthest along a fixed direction.
///
/// On a face all points count equally. On a bumpy surface load-carrying points count: lengths are weighted
/// with the distance below `reach`, the deepest point with 1. An infinite `reach` weights nothing.
pub fn reduce(points: &mut Vec<RawPoint>, normal: Vector, reach: Real) {
    if points.len() <= MAX_MANIFOLD_POINTS {
        return;
    }
    let Some(first) = first_point(points, normal) else { return };
    let p = points[first].local_p1;
    let deepest = points.iter().map(|point| point.dist).fold(Real::INFINITY, Real::min);
    let weight = |point: &RawPoint| {
        let fraction = (reach - point.dist) / (reach - deepest);
        if fraction.is_finite() { fraction } else { 1.0 }
    };
    let away = |point: &RawPoint| point.local_p1.distance(p) * weight(point);
    let Some(second) = best(points, away) else { return };
    let side = normal.cross(points[second].local_p1 - p);
    let height = |point: &RawPoint| side.dot(point.local_p1 - p);
    let Some(third) = best(points, |point| height(point).abs() * weight(point)) else { return };
    let sign = if height(&points[third]) < 0.0 { 1.0 } else { -1.0 };
    let fourth = best(points, |point| sign * height(point) * weight(point));

    let mut kept = [first, second, third, fourth.unwrap_or(third)];
    kept.sort_unstable();
    let mut index = 0;
    points.retain(|_| {
        index += 1;
        kept.contains(&(index - 1))
    });
}

/// The deepest point, or an outermost one if none is.
fn first_point(points: &[RawPoint], normal: Vector) -> Option<usize> {
    let origin = points.first()?.local_p1;
    let size_squared =
        points.iter().map(|point| point.local_p1.distance_squared(origin)).fold(0.0, Real::max);
    let depths = points.iter().map(|point| point.dist);
    let (low, high) = depths.fold((Real::INFINITY, Real::NEG_INFINITY), |(low, high), dist| {
        (low.min(dist), high.max(dist))
    });
    if high - low > DEPTH_TOLERANCE * size_squared.sqrt() {
        return best(points, |point| -point.dist);
    }
    let [tangent1, tangent2] = tangents(normal);
    // Not along an axis, where whole edges would be equally far.
    let direction = tangent1 + tangent2 * 0.3;
    best(points, |point| direction.dot(point.local_p1))
}

/// The first of the points with the highest score.
fn best(points: &[RawPoint], score: impl Fn(&RawPoint) -> Real) -> Option<usize> {
    let mut best = (None, Real::NEG_INFINITY);
    for (index, point) in points.iter().enumerate() {
        let score = score(point);
        if score > best.1 {
            best = (Some(index), score);
        }
    }
    best.0
}
