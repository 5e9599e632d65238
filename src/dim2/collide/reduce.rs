//! At most two points of a manifold.

use super::RawPoint;
use crate::dim::math::{MAX_MANIFOLD_POINTS, Real, Vector, tangents};

/// Points whose depths differ by less than this fraction of the manifold's size count as equally deep.
const DEPTH_TOLERANCE: Real = 5.0e-3;

/// Keeps the deepest point and the one that is farthest from it. If all are equally deep, rounding must not
/// choose: then the first is the one that is farthest to one side.
///
/// Two convex parts touch in two points at most, but several parts of a chain may meet the same body. On a
/// bumpy chain, load-carrying points count: lengths are weighted with the distance below `reach`, the deepest
/// point with 1. An infinite `reach` weights nothing.
pub fn reduce(points: &mut Vec<RawPoint>, normal: Vector, reach: Real) {
    if points.len() <= MAX_MANIFOLD_POINTS {
        return;
    }
    let [tangent] = tangents(normal);
    let along = |point: &RawPoint| tangent.dot(point.local_p1);
    let (low, high) = range(points.iter().map(|point| point.dist));
    let (left, right) = range(points.iter().map(along));
    let first = if high - low > DEPTH_TOLERANCE * (right - left) {
        points.iter().min_by(|a, b| a.dist.total_cmp(&b.dist)).copied()
    } else {
        points.iter().min_by(|a, b| along(a).total_cmp(&along(b))).copied()
    };
    let Some(first) = first else { return };
    let weight = |point: &RawPoint| {
        let fraction = (reach - point.dist) / (reach - low);
        if fraction.is_finite() { fraction } else { 1.0 }
    };
    let away = |point: &RawPoint| (along(point) - along(&first)).abs() * weight(point);
    let second = points.iter().max_by(|a, b| away(a).total_cmp(&away(b))).copied();
    points.clear();
    points.push(first);
    points.extend(second);
}

fn range(values: impl Iterator<Item = Real>) -> (Real, Real) {
    values.fold((Real::INFINITY, Real::NEG_INFINITY), |(low, high), value| {
        (low.min(value), high.max(value))
    })
}
