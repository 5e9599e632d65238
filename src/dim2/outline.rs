//! Sketches of 2D shapes: their borders. A ball also gets a radius, or else its rotation could not
//! be seen.

use crate::base::outline::{Detail, Outline};
use crate::dim::math::{Pose, Real, Vector, tangents};
use core::f64::consts::{PI, TAU};
use parry::shape::{
    Capsule, Compound, ConvexPolygon, Cuboid, RoundConvexPolygon, RoundCuboid, RoundTriangle,
    TypedShape,
};

/// Half the length of the line that represents an infinite one (length units).
const PLANE_EXTENT: Real = 1000.0;

/// The sketch of a shape, in the shape's frame. Shapes of the user's own are drawn as their box.
pub(crate) fn outline(shape: &TypedShape, detail: Detail) -> Outline {
    let Detail { subdivisions, border_subdivisions } = detail;
    let mut out = Outline::default();
    match shape {
        TypedShape::Ball(s) => ball(&mut out, s.radius, subdivisions),
        TypedShape::Cuboid(s) => cuboid(&mut out, s, Vector::ZERO),
        TypedShape::Capsule(s) => capsule(&mut out, s, subdivisions),
        TypedShape::Segment(s) => out.segment(s.a, s.b),
        TypedShape::Triangle(s) => out.ring(&[s.a, s.b, s.c]),
        TypedShape::Voxels(s) => return s.to_polyline().into(),
        TypedShape::TriMesh(s) => return mesh(s.vertices(), s.indices()),
        TypedShape::Polyline(s) => {
            return (s.vertices().to_vec(), s.indices().to_vec()).into();
        }
        TypedShape::HalfSpace(s) => plane(&mut out, s.normal),
        TypedShape::HeightField(s) => s.segments().for_each(|piece| out.segment(piece.a, piece.b)),
        TypedShape::Compound(s) => compound(&mut out, s, detail),
        TypedShape::ConvexPolygon(s) => out.ring(s.points()),
        TypedShape::RoundCuboid(s) => round_cuboid(&mut out, s, border_subdivisions),
        TypedShape::RoundTriangle(s) => round_triangle(&mut out, s, border_subdivisions),
        TypedShape::RoundConvexPolygon(s) => round_polygon(&mut out, s, border_subdivisions),
        TypedShape::Custom(s) => {
            let aabb = s.compute_local_aabb();
            cuboid(&mut out, &Cuboid::new(aabb.half_extents()), aabb.center());
        }
    }
    out
}

fn ball(out: &mut Outline, radius: Real, pieces: u32) {
    let axes = [Vector::X * radius, Vector::Y * radius];
    out.arc(Vector::ZERO, axes, [0.0, TAU as Real], pieces);
    out.segment(Vector::ZERO, axes[0]);
}

fn cuboid(out: &mut Outline, shape: &Cuboid, center: Vector) {
    let (x, y) = (Vector::X * shape.half_extents.x, Vector::Y * shape.half_extents.y);
    out.ring(&[center - x - y, center + x - y, center + x + y, center - x + y]);
}

fn capsule(out: &mut Outline, shape: &Capsule, pieces: u32) {
    let (a, b) = (shape.segment.a, shape.segment.b);
    let along = (b - a).normalize_or(Vector::Y) * shape.radius;
    let across = Vector::new(along.y, -along.x);
    out.arc(a, [across, -along], [0.0, PI as Real], pieces / 2);
    out.arc(b, [across, along], [0.0, PI as Real], pieces / 2);
    out.segment(a + across, b + across);
    out.segment(a - across, b - across);
}

fn mesh(vertices: &[Vector], triangles: &[[u32; 3]]) -> Outline {
    let lines = triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]).collect();
    Outline { points: vertices.to_vec(), lines }.without_repeats()
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
fn plane(out: &mut Outline, normal: Vector) {
    let [along] = tangents(normal);
    out.segment(-along * PLANE_EXTENT, along * PLANE_EXTENT);
    out.segment(Vector::ZERO, normal);
}

fn compound(out: &mut Outline, shape: &Compound, detail: Detail) {
    for (pose, part) in shape.shapes() {
        out.append(&outline(&part.as_typed_shape(), detail), pose);
    }
}

/// The edges of a box with the given half extents and pose.
pub(crate) fn box_outline(half_extents: Vector, pose: &Pose) -> Outline {
    let (mut local, mut out) = (Outline::default(), Outline::default());
    cuboid(&mut local, &Cuboid::new(half_extents), Vector::ZERO);
    out.append(&local, pose);
    out
}

/// Places and directions of the normals with which a polyline decides what is inside: those of its
/// vertices and, in 3D only, those of edges. Empty for shapes that have none.
pub(crate) fn pseudo_normals(shape: &TypedShape) -> [Vec<(Vector, Vector)>; 2] {
    let TypedShape::Polyline(line) = shape else { return Default::default() };
    let normals = line.pseudo_normals().unwrap_or_default();
    [line.vertices().iter().copied().zip(normals.iter().copied()).collect(), Vec::new()]
}

#[cfg(test)]
mod tests {
    use super::*;
    use parry::shape::{Polyline, SharedShape, TriMesh, Voxels};

    /// One shape of every kind that has an extent, and a few degenerate ones.
    fn shapes() -> Vec<SharedShape> {
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

    #[test]
    fn every_sketch_fills_the_box_of_its_shape() {
        for detail in [Detail::new(0, 0), Detail::new(32, 5)] {
            // With 4 pieces a circle is a square that touches the box at its corners only.
            let tolerance = if detail.subdivisions < 8 { 0.35 } else { 0.05 };
            for shape in shapes() {
                let sketch = outline(&shape.as_typed_shape(), detail);
                let aabb = shape.compute_local_aabb();
                let kind = shape.shape_type();
                assert!(!sketch.lines.is_empty(), "{kind:?} is drawn");
                let (mut low, mut high) = (Vector::MAX, Vector::MIN);
                for &id in sketch.lines.as_flattened() {
                    low = low.min(sketch.points[id as usize]);
                    high = high.max(sketch.points[id as usize]);
                }
                let size = (aabb.maxs - aabb.mins).max_element();
                let near = |a: Vector, b: Vector| (a - b).abs().max_element() < tolerance * size;
                assert!(near(low, aabb.mins), "{kind:?}: {low} in {aabb:?}");
                // The box of voxels is that of the blocks in which they are stored.
                if let Some(voxels) = shape.as_voxels() {
                    assert_eq!(high, voxels.voxel_aabb(voxels.voxel_at_point(high * 0.999)).maxs);
                } else {
                    assert!(near(high, aabb.maxs), "{kind:?}: {high} in {aabb:?}");
                }
            }
        }
    }
}
