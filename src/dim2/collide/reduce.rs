//! At most two points of a manifold.

use super::RawPoint;
use crate::dim::math::Vector;
use arrayvec::ArrayVec;

/// Does nothing: in the plane two convex parts touch in two points at most.
pub fn reduce(_points: &mut ArrayVec<RawPoint, 2>, _normal: Vector) {}
