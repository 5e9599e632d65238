//! How far a shape reaches.

use crate::dim::math::{DIM, Real, Vector};
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

/// How deep one can get into a shape at most, or not much less: 0 for surfaces, which have no inside, infinite for what does not
/// end.
pub(crate) fn thickness(shape: &dyn Shape) -> Real {
    match shape.as_typed_shape() {
        TypedShape::Compound(compound) => {
            let parts = compound.shapes().iter().map(|(_, part)| thickness(&**part));
            parts.fold(Real::INFINITY, Real::min)
        }
        TypedShape::HalfSpace(_) => Real::INFINITY,
        TypedShape::TriMesh(_) | TypedShape::Polyline(_) | TypedShape::HeightField(_) => 0.0,
        _ => match shape.ccd_thickness() {
            known if known > 0.0 => known,
            // Of triangles parry says that they have none, also in 2D, where they have an area.
            _ => {
                let radius = shape.compute_local_bounding_sphere().radius;
                let thickness =
                    shape.mass_properties(1.0).mass() / (4.0 * radius.powi(DIM as i32 - 1));
                if thickness > 0.0 { thickness } else { 0.0 }
            }
        },
    }
}
