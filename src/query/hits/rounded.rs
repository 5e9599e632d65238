//! A point on its way to something round: a ball, and a segment with a layer around it.
//!
//! The way is `origin + dir * time`, `dir` of any length. Where it comes nearest is found first, and from there when
//! it enters: a quadratic equation about the origin loses the radius among the digits of a distant one's distance
//! (Haines, Günther, Akenine-Möller, "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems, 2019).

use crate::dim::math::{Real, Vector};

/// When the way enters a ball and when it leaves; `None` if it never comes by.
///
/// `to_center` leads from the origin of the way to the centre of the ball.
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

/// When the way enters the layer around a segment, and the point of the segment that is nearest there.
///
/// `None` if it never does. A time below zero says that the way begins inside, or has left already.
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
    // Shorter than this it is nothing but rounding: the way is parallel to the segment.
    if dir_across.length_squared() <= 64.0 * Real::EPSILON * Real::EPSILON * dir.length_squared() {
        return enter_end(if dir.dot(along) > 0.0 { a } else { b });
    }
    let [time, _] = chord(-across(from_a), dir_across, radius)?;
    let share = (from_a + dir * time).dot(along) / length_squared;
    if share < 0.0 {
        enter_end(a)
    } else if share > 1.0 {
        enter_end(b)
    } else {
        Some((time, a + along * share))
    }
}

/// The point of a segment that is nearest to a point.
pub fn nearest_on_segment(point: Vector, [a, b]: [Vector; 2]) -> Vector {
    let (along, from_a) = (b - a, point - a);
    let length_squared = along.length_squared();
    let share = if length_squared > 0.0 { from_a.dot(along) / length_squared } else { 0.0 };
    a + along * share.clamp(0.0, 1.0)
}
