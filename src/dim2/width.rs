//! The axes along which a convex shape is narrowest, in 2D.

use super::math::{Real, Rotation, Vector};
use crate::base::planar_width::{NarrowFrame, edge_normals, minimum_width};
use parry::shape::{ConvexPolygon, TypedShape};

/// Finds the frame of a convex shape from its support points.
pub fn narrow_frame(support: impl Fn(Vector) -> Vector) -> NarrowFrame {
    let difference = |along: Vector| support(along) - support(-along);
    let found = minimum_width(|along| difference(Vector::from_array(along)).to_array());
    let [x, y] = found.axis;
    let second = Vector::new(-y, x);
    NarrowFrame {
        axes: Rotation::from_cos_sin_unchecked(x, y),
        widths: Vector::new(found.width, difference(second).dot(second)),
        least: found.least,
    }
}

/// The corners of a hull and the layer around them, if the shape is one.
pub fn corners(shape: TypedShape<'_>) -> Option<(&[Vector], Real)> {
    match shape {
        TypedShape::ConvexPolygon(c) => Some((ConvexPolygon::points(c), 0.0)),
        TypedShape::RoundConvexPolygon(c) => Some((c.inner_shape.points(), c.border_radius)),
        _ => None,
    }
}

/// The axis-aligned frame of a shape of this dimension that has one: its centre of mass, its half extents,
/// and half its minimum width.
pub fn aligned(_: TypedShape<'_>) -> Option<(Vector, Vector, Real)> {
    None
}

/// The outward unit normals of all faces of a hull or triangle; none of other shapes.
pub fn face_normals(shape: TypedShape<'_>) -> Vec<Vector> {
    match shape {
        TypedShape::ConvexPolygon(c) => c.normals().to_vec(),
        TypedShape::RoundConvexPolygon(c) => c.inner_shape.normals().to_vec(),
        TypedShape::Triangle(t) => edge_normals(t),
        TypedShape::RoundTriangle(t) => edge_normals(&t.inner_shape),
        _ => Vec::new(),
    }
}

/// Returns whether this triangle encloses an area.
pub const TRIANGLES_ARE_SOLID: bool = true;
