//! Surfaces with a solid inside: oriented meshes and polylines.
//!
//! The parts of such a surface are one-dimensional or two-dimensional, so a shape that is entirely inside
//! touches no part. A shape without contact is inside if any of its points is.

use super::pair_query::Found;
use crate::dim::collide::has_inside;
use crate::dim::math::{Pose, Real, Vector};
use parry::query::ShapeCastStatus;
use parry::shape::Shape;

/// The way out of a solid for a convex shape that is inside: the cost is the negative depth.
///
/// It leads through the nearest point of the surface from a point in the middle of the shape. `None` if the
/// shape `solid` has no inside, or if that point is outside.
pub(super) fn way_out(pose12: &Pose, solid: &dyn Shape, other: &dyn Shape) -> Option<Found> {
    let support = other.as_support_map().filter(|_| has_inside(solid))?;
    let ends = [Vector::X, -Vector::X].map(|along| support.local_support_point(along));
    let inner = pose12 * ends[0].midpoint(ends[1]);
    let is_near = inner.is_finite() && solid.compute_local_aabb().contains_local_point(inner);
    if !is_near || !solid.contains_local_point(inner) {
        return None;
    }
    let surface = solid.project_local_point(inner, false).point;
    let normal1 = (surface - inner).try_normalize().unwrap_or(Vector::Y);
    let normal2 = pose12.rotation.inverse() * -normal1;
    let deepest = support.local_support_point(normal2);
    let depth = (surface - pose12 * deepest).dot(normal1);
    Some(Found {
        cost: -depth.max(Real::MIN_POSITIVE),
        points: [surface, deepest],
        normals: [normal1, normal2],
        ids: [0; 2],
        status: ShapeCastStatus::PenetratingOrWithinTargetDist,
    })
}
