//! Invalid numbers, and some valid ones.

use crate::dim::vec;
use rapier::prelude::*;

/// Smallest number above zero.
pub const SUBNORMAL: Real = Real::MIN_POSITIVE * Real::EPSILON;

/// Values that are not finite.
pub const NOT_FINITE: [Real; 3] = [Real::NAN, Real::INFINITY, Real::NEG_INFINITY];

/// Extreme and invalid numbers.
pub const EDGES: [Real; 16] = [
    Real::NAN,
    Real::INFINITY,
    Real::NEG_INFINITY,
    Real::MAX,
    Real::MIN,
    -1.0,
    0.0,
    -0.0,
    SUBNORMAL,
    Real::MIN_POSITIVE,
    1.0e-20,
    1.0e-9,
    1.0e9,
    1.0e15,
    1.0e18,
    1.0e30,
];

/// Largest coordinate of a shape.
pub const SHAPE_MAX: Real = if size_of::<Real>() == 4 { 1.0e9 } else { 1.0e15 };

/// Returns vectors with `value` in all components, or in one of them.
pub fn vectors_of(value: Real) -> [Vector; 3] {
    [Vector::splat(value), vec(value, 0.0), vec(0.0, value)]
}

/// Returns all vectors made of [`EDGES`].
pub fn edge_vectors() -> impl Iterator<Item = Vector> {
    EDGES.into_iter().flat_map(vectors_of)
}
