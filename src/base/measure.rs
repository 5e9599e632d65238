//! The numbers that a shape is made of, and which of them are usable.

use parry::math::{Real, Vector};

/// Smallest usable length. The square of a length and its inverse must stay normal numbers in single
/// precision, or a direction could turn into NaN.
pub const SIZE_MIN: Real = 1.0e-15;
/// Largest usable length or coordinate, for the same reason as [`SIZE_MIN`].
pub const SIZE_MAX: Real = 1.0e15;

/// Whether numbers have single precision.
const IS_SINGLE: bool = size_of::<Real>() == size_of::<f32>();
/// Largest coordinate of a shape's bounding box, in its frame. Contact generation computes fourth powers of
/// lengths, and those of larger numbers leave the range of `f32`.
pub const SHAPE_MAX: Real = if IS_SINGLE { 1.0e9 } else { SIZE_MAX };
/// The range of these coordinates, as a part of messages.
pub const SHAPE_RANGE: &str =
    if IS_SINGLE { "finite and at most 1e9" } else { "finite and at most 1e15" };
/// Largest distance, along an axis, of the frames of two shapes that touch: twice the size of a shape.
pub const FRAME_DISTANCE_MAX: Real = 2.0 * SHAPE_MAX;
/// Largest coordinate of a box in the trees. They compute products of three such lengths and the number of
/// leaves, which stay within the range of numbers.
pub const BOX_COORDINATE_MAX: Real = 10.0 * SHAPE_MAX;
/// Largest coordinate of a voxel in its grid: cells beyond it coincide with their neighbours.
pub const GRID_COORDINATE_MAX: Real = 0.5 / Real::EPSILON;

const _: () = assert!(SIZE_MIN * SIZE_MIN > 0.0 && 1.0 / (SIZE_MIN * SIZE_MIN) < Real::MAX);
const _: () = assert!(SIZE_MAX * SIZE_MAX < Real::MAX);

/// Velocities, displacements, masses and motor stiffnesses up to this one are moderate. A diverging value
/// passes this limit before it overflows, and a free fall of a day stays below it.
pub const MODERATE_MAX: Real = 1.0e6;
/// A body at most this far away with a moderate velocity stays in the world within a step.
pub const COORDINATE_MODERATE_MAX: Real = 0.5 * SIZE_MAX;

/// A number or list of numbers that a shape is made of, under the name that its constructor gives it.
#[derive(Copy, Clone, Debug, PartialEq)]
pub enum Measure<'a> {
    /// A size: a usable length, or zero. A shape with a size of zero is flat, a line or a point.
    Size(&'static str, Real),
    /// The thickness of a layer, which may be zero.
    Margin(&'static str, Real),
    /// Sizes along the axes.
    Sizes(&'static str, Vector),
    /// Lengths along the axes of a grid: positive.
    Lengths(&'static str, Vector),
    /// A point.
    Point(&'static str, Vector),
    /// Points.
    Points(&'static str, &'a [Vector]),
    /// Coordinates along one axis.
    Coordinates(&'static str, &'a [Real]),
}

/// Returns whether the value is a usable positive length.
#[inline]
pub fn is_length(value: Real) -> bool {
    (SIZE_MIN..=SIZE_MAX).contains(&value)
}

/// Returns whether the value is zero or a usable positive length, far from the smallest numbers.
#[inline]
pub fn is_size(value: Real) -> bool {
    value == 0.0 || is_length(value)
}

/// Returns whether the value is zero or a usable positive length.
#[inline]
pub fn is_margin(value: Real) -> bool {
    (0.0..=SIZE_MAX).contains(&value)
}

/// Returns whether the value is a usable coordinate.
#[inline]
pub fn is_coordinate(value: Real) -> bool {
    value.abs() <= SIZE_MAX
}

/// Returns whether all coordinates are usable.
#[inline]
pub fn is_point(point: Vector) -> bool {
    point.abs().max_element() <= SIZE_MAX && point.is_finite()
}
