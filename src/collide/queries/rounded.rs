//! A moving point against round shapes: a ball, and a segment with a layer around it.
//!
//! The path is `origin + dir * time`, `dir` of any length. The nearest point is computed first, and the entry
//! relative to it. A quadratic equation about the origin would lose the radius among the digits of a large
//! distance. (Haines, Günther, Akenine-Möller, "Precision Improvements for Ray/Sphere Intersection", Ray
//! Tracing Gems, 2019.)

use crate::dim::math::{Real, Vector};

/// The times at which the path enters and leaves a ball; `None` if it misses.
///
/// `to_center` leads from the origin of the path to the centre of the ball.
#[inline]
pub fn chord(to_center: Vector, dir: Vector, radius: Real) -> Option<[Real; 2]> {
    let squared = dir.length_squared();
    let middle = to_center.dot(dir) / squared;
    let beside = to_center - dir * middle;
    let within = radius * radius - beside.length_squared();
    (within >= 0.0).then(|| {
        let half = (within / squared).sqrt();
        [middle - half, middle + half]
    })
}

/// The time at which the path enters the layer around a segment, and the nearest point of the segment there.
///
/// `None` if it never does. A negative time means that the path begins inside, or has left already.
pub fn enter_capsule(
    origin: Vector,
    dir: Vector,
    [a, b]: [Vector; 2],
    radius: Real,
) -> Option<(Real, Vector)> {
    let (along, from_a) = (b - a, origin - a);
    let length_squared = along.length_squared();
    let enter_end = |end: Vector| Some((chord(end - origin, dir, radius)?[0], end));
    if length_squared == 0.0 {
        return enter_end(a);
    }
    // Across the segment, the capsule is a ball.
    let across = |v: Vector| v - along * (v.dot(along) / length_squared);
    let dir_across = across(dir);
    // Shorter values are rounding: the path is parallel to the segment.
    if dir_across.length_squared() <= 64.0 * Real::EPSILON * Real::EPSILON * dir.length_squared() {
        return enter_end(if dir.dot(along) > 0.0 { a } else { b });
    }
    let [time, _] = chord(-across(from_a), dir_across, radius)?;
    let fraction = (from_a + dir * time).dot(along) / length_squared;
    if fraction < 0.0 {
        enter_end(a)
    } else if fraction > 1.0 {
        enter_end(b)
    } else {
        Some((time, a + along * fraction))
    }
}

/// The point of a segment that is nearest to a point.
pub fn nearest_on_segment(point: Vector, [a, b]: [Vector; 2]) -> Vector {
    let (along, from_a) = (b - a, point - a);
    let length_squared = along.length_squared();
    let fraction = if length_squared > 0.0 { from_a.dot(along) / length_squared } else { 0.0 };
    a + along * fraction.clamp(0.0, 1.0)
}
