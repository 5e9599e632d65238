//! Tests of the parts of colliders and of their book-keeping, for every dimension and
//! precision. Dimension-specific functions are tested in `dim2/surface` and `dim3/surface`.

mod builder;
mod hulls;
mod mass;
mod set;
mod setters;
mod shapes;
mod widths;

use crate::dim::math::Real;

/// Numbers that are no length.
const NOT_LENGTHS: [Real; 5] = [0.0, -1.0, Real::NAN, Real::INFINITY, Real::NEG_INFINITY];
/// Numbers that are no coordinate.
const NOT_COORDINATES: [Real; 4] = [Real::NAN, Real::INFINITY, Real::NEG_INFINITY, Real::MAX];
