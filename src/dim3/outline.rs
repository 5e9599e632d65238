//! Sketches of 3D shapes: edges of polyhedra, a few circles of round shapes.

use crate::base::outline::{Detail, Outline};
use crate::dim::math::{Real, Vector, tangents};
use core::f64::consts::{PI, TAU};
use parry::shape::{
    Capsule, Cone, ConvexPolyhedron, Cuboid, Cylinder, HeightField, HeightFieldCellStatus,
    RoundTriangle, Triangle, TypedShape,
};

/// Half the side of the square that represents an infinite plane (length units).
const PLANE_EXTENT: Real = 50.0;
/// Lines across that square, in each direction.
const PLANE_CELLS: i32 = 10;

/// Adds the sketch of a shape whose kind exists in this dimension only, or is drawn in its own way. Returns
/// whether the shape is of such a kind.
pub(crate) fn add_shape(out: &mut Outline, shape: &TypedShape, detail: Detail) -> bool {
    let Detail { subdivisions, border_subdivisions } = detail;
    match shape {
        TypedShape::Voxels(s) => *out = s.to_outline().into(),
        TypedShape::HeightField(s) => height_field(out, s),
        TypedShape::ConvexPolyhedron(s) => *out = polyhedron(s),
        TypedShape::Cylinder(s) => cylinder(out, s, subdivisions),
        TypedShape::Cone(s) => cone(out, s, subdivisions),
        TypedShape::RoundCuboid(s) if s.border_radius > 0.0 => {
            *out = s.to_outline(border_subdivisions).into();
        }
        TypedShape::RoundCuboid(s) => cuboid(out, &s.inner_shape, Vector::ZERO),
        TypedShape::RoundTriangle(s) => round_triangle(out, s, border_subdivisions),
        TypedShape::RoundCylinder(s) if s.border_radius > 0.0 => {
            *out = s.to_outline(subdivisions, border_subdivisions).into();
        }
        TypedShape::RoundCylinder(s) => cylinder(out, &s.inner_shape, subdivisions),
        TypedShape::RoundCone(s) if s.border_radius > 0.0 => {
            *out = s.to_outline(subdivisions, border_subdivisions).into();
        }
        TypedShape::RoundCone(s) => cone(out, &s.inner_shape, subdivisions),
        TypedShape::RoundConvexPolyhedron(s) if s.border_radius > 0.0 => {
            *out = s.to_outline(border_subdivisions).into();
        }
        TypedShape::RoundConvexPolyhedron(s) => *out = polyhedron(&s.inner_shape),
        _ => return false,
    }
    true
}

/// A full circle.
fn circle(out: &mut Outline, center: Vector, axes: [Vector; 2], pieces: u32) {
    out.arc(center, axes, [0.0, TAU as Real], pieces);
}

pub(crate) fn ball(out: &mut Outline, radius: Real, pieces: u32) {
    let [x, y, z] = Vector::AXES.map(|axis| axis * radius);
    for axes in [[x, y], [y, z], [z, x]] {
        circle(out, Vector::ZERO, axes, pieces);
    }
}

pub(crate) fn cuboid(out: &mut Outline, shape: &Cuboid, center: Vector) {
    let h = shape.half_extents;
    let corner = |x: Real, y: Real, z: Real| center + h * Vector::new(x, y, z);
    let side = |z| {
        [corner(-1.0, -1.0, z), corner(1.0, -1.0, z), corner(1.0, 1.0, z), corner(-1.0, 1.0, z)]
    };
    let (back, front) = (side(-1.0), side(1.0));
    out.ring(&back);
    out.ring(&front);
    for (&a, &b) in back.iter().zip(&front) {
        out.segment(a, b);
    }
}

pub(crate) fn capsule(out: &mut Outline, shape: &Capsule, pieces: u32) {
    let (a, b) = (shape.segment.a, shape.segment.b);
    let axis = (b - a).normalize_or(Vector::Y);
    let [u, v] = tangents(axis).map(|tangent| tangent * shape.radius);
    let w = axis * shape.radius;
    for (center, w) in [(a, -w), (b, w)] {
        circle(out, center, [u, v], pieces);
        out.arc(center, [u, w], [0.0, PI as Real], pieces / 2);
        out.arc(center, [v, w], [0.0, PI as Real], pieces / 2);
    }
    for side in [u, v, -u, -v] {
        out.segment(a + side, b + side);
    }
}

fn cylinder(out: &mut Outline, shape: &Cylinder, pieces: u32) {
    let top = Vector::Y * shape.half_height;
    let sides = [Vector::X * shape.radius, Vector::Z * shape.radius];
    circle(out, top, sides, pieces);
    circle(out, -top, sides, pieces);
    for side in [sides[0], sides[1], -sides[0], -sides[1]] {
        out.segment(side - top, side + top);
    }
}

fn cone(out: &mut Outline, shape: &Cone, pieces: u32) {
    let top = Vector::Y * shape.half_height;
    let sides = [Vector::X * shape.radius, Vector::Z * shape.radius];
    circle(out, -top, sides, pieces);
    for side in [sides[0], sides[1], -sides[0], -sides[1]] {
        out.segment(side - top, top);
    }
}

fn polyhedron(shape: &ConvexPolyhedron) -> Outline {
    let lines = shape.edges().iter().map(|edge| edge.vertices).collect();
    (shape.points().to_vec(), lines).into()
}

/// Both sides of the slab around the triangle, joined by half circles at the corners.
fn round_triangle(out: &mut Outline, shape: &RoundTriangle, pieces: u32) {
    let Triangle { a, b, c } = shape.inner_shape;
    let normal = (b - a).cross(c - a).normalize_or_zero() * shape.border_radius;
    out.ring(&[a + normal, b + normal, c + normal]);
    out.ring(&[a - normal, b - normal, c - normal]);
    let middle = (a + b + c) / 3.0;
    for corner in [a, b, c] {
        let outward = (corner - middle).normalize_or_zero() * shape.border_radius;
        out.arc(corner, [normal, outward], [0.0, PI as Real], 2 * pieces);
    }
}

/// The sides of the cells that are there; diagonals would only clutter.
fn height_field(out: &mut Outline, field: &HeightField) {
    let (rows, columns) = (field.nrows(), field.ncols());
    let scale = field.scale();
    for j in 0..=columns {
        for i in 0..=rows {
            let height = field.heights()[(i, j)] * scale.y;
            out.points.push(Vector::new(field.x_at(j), height, field.z_at(i)));
        }
    }
    let id = |i: usize, j: usize| (j * (rows + 1) + i) as u32;
    for j in 0..columns {
        for i in 0..rows {
            if !field.cell_status(i, j).contains(HeightFieldCellStatus::CELL_REMOVED) {
                let ring = [id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)];
                out.lines.extend((0..4).map(|side| [ring[side], ring[(side + 1) % 4]]));
            }
        }
    }
    *out = core::mem::take(out).without_repeats();
}

/// A net of squares on the plane, and an arrow to the side that is empty.
pub(crate) fn plane(out: &mut Outline, normal: Vector) {
    let [u, v] = tangents(normal);
    for i in -PLANE_CELLS..=PLANE_CELLS {
        let offset = PLANE_EXTENT * i as Real / PLANE_CELLS as Real;
        for (along, across) in [(u, v), (v, u)] {
            let (end, side) = (along * PLANE_EXTENT, across * offset);
            out.segment(side - end, side + end);
        }
    }
    out.segment(Vector::ZERO, normal);
}

/// Places and directions of a mesh's pseudo-normals, which define its inside: those of its vertices and those
/// of its edges. Empty for shapes that have none.
pub(crate) fn pseudo_normals(shape: &TypedShape) -> [Vec<(Vector, Vector)>; 2] {
    let TypedShape::TriMesh(mesh) = shape else { return Default::default() };
    let Some(normals) = mesh.pseudo_normals() else { return Default::default() };
    let vertices = mesh.vertices();
    let at_vertices = vertices.iter().copied().zip(normals.vertices_pseudo_normal.iter().copied());
    let at_edges = mesh.indices().iter().zip(&normals.edges_pseudo_normal).flat_map(
        |(&[a, b, c], &normals)| {
            let middle = |i: u32, j: u32| (vertices[i as usize] + vertices[j as usize]) * 0.5;
            [middle(a, b), middle(b, c), middle(c, a)].into_iter().zip(normals)
        },
    );
    [at_vertices.collect(), at_edges.collect()]
}

#[cfg(test)]
pub(crate) mod samples {
    use super::Vector;
    use crate::dim::math::Pose;
    use parry::shape::{Polyline, SharedShape, TriMesh, Voxels};
    use parry::utils::Array2;

    /// One shape of every kind that has an extent, and a few degenerate ones.
    pub fn shapes() -> Vec<SharedShape> {
        let corners = [Vector::ZERO, Vector::X * 2.0, Vector::Y, Vector::Z * 3.0];
        let faces = vec![[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
        let (a, b, c) = (corners[1], corners[2], corners[3]);
        let heights = Array2::new(3, 2, vec![0.0, 0.5, 0.2, 0.1, 0.3, 0.9]);
        let part = (Pose::translation(1.0, 2.0, 3.0), SharedShape::ball(1.0));
        vec![
            SharedShape::ball(0.5),
            SharedShape::cuboid(0.5, 1.0, 2.0),
            SharedShape::capsule_y(1.0, 0.5),
            SharedShape::capsule(Vector::ONE, Vector::ONE * 3.0, 0.5),
            SharedShape::capsule(Vector::ONE, Vector::ONE, 0.5),
            SharedShape::segment(Vector::X, Vector::Y * 2.0),
            SharedShape::triangle(a, b, c),
            SharedShape::new(Polyline::new(corners.to_vec(), None)),
            SharedShape::new(TriMesh::new(corners.to_vec(), faces).unwrap()),
            SharedShape::new(Voxels::from_points(Vector::ONE, &[Vector::ZERO, Vector::X * 4.0])),
            SharedShape::heightfield(heights, Vector::new(8.0, 2.0, 6.0)),
            SharedShape::compound(vec![part]),
            SharedShape::convex_hull(&corners).unwrap(),
            SharedShape::cylinder(1.0, 0.5),
            SharedShape::cone(1.0, 0.5),
            SharedShape::round_cuboid(0.5, 1.0, 2.0, 0.1),
            SharedShape::round_cuboid(0.5, 1.0, 2.0, 0.0),
            SharedShape::round_cylinder(1.0, 0.5, 0.1),
            SharedShape::round_cylinder(1.0, 0.5, 0.0),
            SharedShape::round_cone(1.0, 0.5, 0.1),
            SharedShape::round_cone(1.0, 0.5, 0.0),
            SharedShape::round_convex_hull(&corners, 0.1).unwrap(),
            SharedShape::round_convex_hull(&corners, 0.0).unwrap(),
            SharedShape::round_triangle(a, b, c, 0.01),
        ]
    }
}
