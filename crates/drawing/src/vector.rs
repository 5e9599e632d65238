//! Vector arithmetic for drawing.

use crate::Point;

/// `a - b`.
pub fn sub(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// `a + b scale`.
pub fn add_scaled(a: Point, b: Point, scale: f32) -> Point {
    [a[0] + b[0] * scale, a[1] + b[1] * scale, a[2] + b[2] * scale]
}

/// The dot product.
pub fn dot(a: Point, b: Point) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The cross product.
pub fn cross(a: Point, b: Point) -> Point {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The unit vector along `a`, or zero if `a` has no length.
pub fn normalize(a: Point) -> Point {
    let length = dot(a, a).sqrt();
    if length > 0.0 { [a[0] / length, a[1] / length, a[2] / length] } else { [0.0; 3] }
}

/// From 0 below `low` to 1 above `high`, with level ends.
pub(crate) fn smoothstep(low: f32, high: f32, x: f32) -> f32 {
    let t = ((x - low) / (high - low).max(f32::MIN_POSITIVE)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// The vector rotated by a unit quaternion (x, y, z, w).
pub(crate) fn rotate([x, y, z, w]: [f32; 4], v: Point) -> Point {
    let q = [x, y, z];
    let t = cross(q, v).map(|c| 2.0 * c);
    add_scaled(add_scaled(v, t, w), cross(q, t), 1.0)
}
