//! Sketches of 2D shapes: their borders. A ball also gets a radius, or else its rotation could not
//! be seen.

use crate::base::outline::{Detail, Outline};
use crate::dim::math::{Real, Vector, tangents};
use crate::dim::shapes::polyline_normals;
use core::f64::consts::{PI, TAU};
use parry::shape::{
    Capsule, ConvexPolygon, Cuboid, RoundConvexPolygon, RoundCuboid, RoundTriangle, TypedShape,
};

/// Half the length of the line that represents an infinite one (length units).
const PLANE_EXTENT: Real = 1000.0;

/// Adds the sketch of a shape whose kind exists in this dimension only, or is drawn in its own way. Returns
/// whether the shape is of such a kind.
pub(crate) fn add_shape(out: &mut Outline, shape: &TypedShape, detail: Detail) -> bool {
    let border_subdivisions = detail.border_subdivisions;
    match shape {
        TypedShape::Voxels(s) => *out = s.to_polyline().into(),
        TypedShape::HeightField(s) => s.segments().for_each(|piece| out.segment(piece.a, piece.b)),
        TypedShape::ConvexPolygon(s) => out.ring(s.points()),
        TypedShape::RoundCuboid(s) => round_cuboid(out, s, border_subdivisions),
        TypedShape::RoundTriangle(s) => round_triangle(out, s, border_subdivisions),
        TypedShape::RoundConvexPolygon(s) => round_polygon(out, s, border_subdivisions),
        _ => return false,
    }
    true
}

pub(crate) fn ball(out: &mut Outline, radius: Real, pieces: u32) {
    let axes = [Vector::X * radius, Vector::Y * radius];
    out.arc(Vector::ZERO, axes, [0.0, TAU as Real], pieces);
    out.segment(Vector::ZERO, axes[0]);
}

pub(crate) fn cuboid(out: &mut Outline, shape: &Cuboid, center: Vector) {
    let (x, y) = (Vector::X * shape.half_extents.x, Vector::Y * shape.half_extents.y);
    out.ring(&[center - x - y, center + x - y, center + x + y, center - x + y]);
}

pub(crate) fn capsule(out: &mut Outline, shape: &Capsule, pieces: u32) {
    let (a, b) = (shape.segment.a, shape.segment.b);
    let along = (b - a).normalize_or(Vector::Y) * shape.radius;
    let across = Vector::new(along.y, -along.x);
    out.arc(a, [across, -along], [0.0, PI as Real], pieces / 2);
    out.arc(b, [across, along], [0.0, PI as Real], pieces / 2);
    out.segment(a + across, b + across);
    out.segment(a - across, b - across);
}

fn round_cuboid(out: &mut Outline, shape: &RoundCuboid, pieces: u32) {
    if shape.border_radius > 0.0 {
        out.ring(&shape.to_polyline(pieces));
    } else {
        cuboid(out, &shape.inner_shape, Vector::ZERO);
    }
}

fn round_polygon(out: &mut Outline, shape: &RoundConvexPolygon, pieces: u32) {
    if shape.border_radius > 0.0 {
        out.ring(&shape.to_polyline(pieces));
    } else {
        out.ring(shape.inner_shape.points());
    }
}

fn round_triangle(out: &mut Outline, shape: &RoundTriangle, pieces: u32) {
    let corners = shape.inner_shape.vertices();
    match ConvexPolygon::from_convex_hull(corners) {
        Some(inner_shape) => {
            let border_radius = shape.border_radius;
            round_polygon(out, &RoundConvexPolygon { inner_shape, border_radius }, pieces);
        }
        // The corners are on one line.
        None => out.ring(corners),
    }
}

/// The border, and an arrow to the side that is empty.
pub(crate) fn plane(out: &mut Outline, normal: Vector) {
    let [along] = tangents(normal);
    out.segment(-along * PLANE_EXTENT, along * PLANE_EXTENT);
    out.segment(Vector::ZERO, normal);
}

/// Positions and directions of the normals by which a polyline decides its inside: those of its vertices and,
/// in 3D only, those of edges. Empty for shapes without normals.
pub(crate) fn pseudo_normals(shape: &TypedShape) -> [Vec<(Vector, Vector)>; 2] {
    let TypedShape::Polyline(line) = shape else { return Default::default() };
    let normals = polyline_normals(line).unwrap_or_default();
    [line.vertices().iter().copied().zip(normals.iter().copied()).collect(), Vec::new()]
}

#[cfg(test)]
pub(crate) mod samples {
    use super::Vector;
    use crate::dim::math::Pose;
    use parry::shape::{Polyline, SharedShape, TriMesh, Voxels};

    /// One shape of every kind that has an extent, and a few degenerate ones.
    pub fn shapes() -> Vec<SharedShape> {
        let corners = [Vector::ZERO, Vector::X * 2.0, Vector::Y];
        let [a, b, c] = corners;
        let part = (Pose::translation(1.0, 2.0), SharedShape::ball(1.0));
        vec![
            SharedShape::ball(0.5),
            SharedShape::cuboid(0.5, 1.0),
            SharedShape::capsule_y(1.0, 0.5),
            SharedShape::capsule(Vector::ONE, Vector::ONE * 3.0, 0.5),
            SharedShape::capsule(Vector::ONE, Vector::ONE, 0.5),
            SharedShape::segment(Vector::X, Vector::Y * 2.0),
            SharedShape::triangle(a, b, c),
            SharedShape::new(Polyline::new(corners.to_vec(), None)),
            SharedShape::new(TriMesh::new(corners.to_vec(), vec![[0, 1, 2]]).unwrap()),
            SharedShape::new(Voxels::from_points(Vector::ONE, &[Vector::ZERO, Vector::X * 4.0])),
            SharedShape::heightfield(vec![0.0, 0.5, 0.2, 0.9], Vector::new(8.0, 2.0)),
            SharedShape::compound(vec![part]),
            SharedShape::convex_hull(&corners).unwrap(),
            SharedShape::round_cuboid(0.5, 1.0, 0.1),
            SharedShape::round_cuboid(0.5, 1.0, 0.0),
            SharedShape::round_convex_hull(&corners, 0.1).unwrap(),
            SharedShape::round_convex_hull(&corners, 0.0).unwrap(),
            SharedShape::round_triangle(a, b, c, 0.1),
            SharedShape::round_triangle(a, b, b, 0.0),
        ]
    }
}
