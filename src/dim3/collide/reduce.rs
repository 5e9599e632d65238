//! At most four points of a manifold.

use super::RawPoint;
use crate::dim::math::{MAX_MANIFOLD_POINTS, Real, Vector};

/// Keeps the deepest point and the three others that span the largest area with it.
///
/// Bodies that rest on many points need no more than four to stand as firmly: the deepest, so that
/// nothing sinks in, the one farthest from it, the one farthest from the line through these two, and
/// the one farthest from the third on the other side of that line. Equal candidates: the first wins,
/// so that the choice does not flicker.
pub fn reduce(points: &mut Vec<RawPoint>, normal: Vector) {
    if points.len() <= MAX_MANIFOLD_POINTS {
        return;
    }
    let Some(first) = best(points, |point| -point.dist) else { return };
    let p = points[first].local_p1;
    let Some(second) = best(points, |point| point.local_p1.distance_squared(p)) else { return };
    let side = normal.cross(points[second].local_p1 - p);
    let height = |point: &RawPoint| side.dot(point.local_p1 - p);
    let Some(third) = best(points, |point| height(point).abs()) else { return };
    let sign = if height(&points[third]) < 0.0 { 1.0 } else { -1.0 };
    let fourth = best(points, |point| sign * height(point));

    let mut kept = [first, second, third, fourth.unwrap_or(third)];
    kept.sort_unstable();
    let mut index = 0;
    points.retain(|_| {
        index += 1;
        kept.contains(&(index - 1))
    });
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
