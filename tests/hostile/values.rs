//! Invalid numbers, and some that may occur.

use crate::dim::vec;
use rapier::prelude::*;

/// The least number above zero.
pub const SUBNORMAL: Real = Real::MIN_POSITIVE * Real::EPSILON;

/// No numbers at all.
pub const NOT_FINITE: [Real; 3] = [Real::NAN, Real::INFINITY, Real::NEG_INFINITY];

/// Numbers at every edge of what a number can be.
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

/// A vector with `value` in each component, or in one of them.
pub fn vectors_of(value: Real) -> [Vector; 3] {
    [Vector::splat(value), vec(value, 0.0), vec(0.0, value)]
}

/// All vectors made of [`EDGES`].
pub fn edge_vectors() -> impl Iterator<Item = Vector> {
    EDGES.into_iter().flat_map(vectors_of)
}
