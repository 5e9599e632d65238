//! Sides of two parts without thickness.
//!
//! The overlap of two such parts is as small along the normal as against it, so their geometry cannot tell on
//! which side of each other they belong. The last normal can: they keep its side.

use crate::dim::collide::RawManifold;
use crate::dim::math::{Real, Vector};
use crate::dim::shapes::is_plate;
use parry::shape::{Shape, TypedShape};

/// A normal with a smaller cosine than minus this is against the last one.
const SIDE_COSINE_MIN: Real = 0.9;

/// Turns the contacts of two parts without thickness to the side of the last normal.
pub(super) fn keep_side(last_normal: Vector, raw: &mut RawManifold) {
    if raw.local_n1.dot(last_normal) < -SIDE_COSINE_MIN {
        (raw.local_n1, raw.local_n2) = (-raw.local_n1, -raw.local_n2);
        raw.points.iter_mut().for_each(|point| point.dist = -point.dist);
    }
}

/// Returns whether a part has no thickness.
pub(super) fn is_flat(shape: &dyn Shape) -> bool {
    match shape.as_typed_shape() {
        TypedShape::Ball(ball) => ball.radius == 0.0,
        TypedShape::Cuboid(cuboid) => cuboid.half_extents.min_element() == 0.0,
        TypedShape::Capsule(capsule) => capsule.radius == 0.0,
        TypedShape::Segment(_) => true,
        other => is_plate(other),
    }
}
