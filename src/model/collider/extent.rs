//! Extent of a shape.

use crate::dim::math::{Real, Vector};
use crate::dim::shapes;
use parry::shape::{Shape, TypedShape};

/// An upper bound of the distance from `center` to any point of the shape, both in the shape's frame.
/// Infinite for half-spaces; exact for all but height fields, voxels, and the rarer round shapes.
pub(crate) fn farthest(shape: &dyn Shape, center: Vector) -> Real {
    let typed = shape.as_typed_shape();
    match typed {
        TypedShape::HalfSpace(_) => Real::INFINITY,
        TypedShape::Ball(b) => center.length() + b.radius,
        TypedShape::Cuboid(c) => (center.abs() + c.half_extents).length(),
        TypedShape::RoundCuboid(c) => {
            (center.abs() + c.inner_shape.half_extents).length() + c.border_radius
        }
        TypedShape::Capsule(c) => of_points([c.segment.a, c.segment.b], center) + c.radius,
        TypedShape::Segment(s) => of_points([s.a, s.b], center),
        TypedShape::Triangle(t) => of_points([t.a, t.b, t.c], center),
        TypedShape::TriMesh(m) => of_points(m.vertices().iter().copied(), center),
        TypedShape::Polyline(p) => of_points(p.vertices().iter().copied(), center),
        TypedShape::Compound(c) => c
            .shapes()
            .iter()
            .map(|(pose, part)| farthest(&**part, pose.inverse_transform_point(center)))
            .fold(0.0, Real::max),
        _ => shapes::farthest(typed, center).unwrap_or_else(|| of_box(shape, center)),
    }
}

fn of_points(points: impl IntoIterator<Item = Vector>, center: Vector) -> Real {
    points.into_iter().map(|p| p.distance_squared(center)).fold(0.0, Real::max).sqrt()
}

/// The farthest corner of the box around the shape.
fn of_box(shape: &dyn Shape, center: Vector) -> Real {
    let aabb = shape.compute_local_aabb();
    (center - aabb.mins).abs().max((aabb.maxs - center).abs()).length()
}
