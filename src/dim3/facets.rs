//! Convex shapes with flat faces, as a moving point meets them: planes, and the edges between them.

use super::math::{Real, Vector};
use super::shapes::is_plate;
use parry::shape::{ConvexPolyhedron, Triangle, TypedShape};

/// Largest distance of corners from the plane of their face, as a fraction of the size of the hull. It is the
/// rounding error of coordinates and of their normal.
const PLANE_DISTANCE_FRACTION_MAX: Real = 256.0 * Real::EPSILON;

/// A hull, or a triangle, which is a hull of no thickness.
#[derive(Copy, Clone)]
pub enum Facets<'a> {
    /// A convex hull.
    Hull(&'a ConvexPolyhedron),
    /// A triangle and its unit normal.
    Triangle(&'a Triangle, Vector),
}

/// A face. The product of an inside point and the normal is at most `offset`.
#[derive(Copy, Clone)]
pub struct Facet {
    /// Unit outward normal.
    pub normal: Vector,
    /// Distance (length units) of the face from the origin along the normal.
    pub offset: Real,
}

impl<'a> Facets<'a> {
    /// The facets of a shape, and how thick (length units) the layer around them is. `None` if it has none,
    /// or they are not flat.
    pub fn of(shape: TypedShape<'a>) -> Option<(Self, Real)> {
        Some(match shape {
            TypedShape::ConvexPolyhedron(hull) if has_flat_faces(hull) => (Self::Hull(hull), 0.0),
            TypedShape::RoundConvexPolyhedron(round) if has_flat_faces(&round.inner_shape) => {
                (Self::Hull(&round.inner_shape), round.border_radius)
            }
            TypedShape::Triangle(triangle) => (Self::Triangle(triangle, triangle.normal()?), 0.0),
            TypedShape::RoundTriangle(round) => {
                let triangle = &round.inner_shape;
                (Self::Triangle(triangle, triangle.normal()?), round.border_radius)
            }
            _ => return None,
        })
    }

    /// Returns whether the shape has no interior, so that it consists of the layer around it.
    pub fn is_flat(&self) -> bool {
        match self {
            Self::Triangle(..) => true,
            // Its two planes alone enclose an unlimited plane.
            Self::Hull(hull) => is_plate(TypedShape::ConvexPolyhedron(hull)),
        }
    }

    /// Number of faces.
    pub fn len(&self) -> usize {
        match self {
            Self::Hull(hull) => hull.faces().len(),
            Self::Triangle(..) => 2,
        }
    }

    /// A face by its number.
    #[inline]
    pub fn facet(&self, index: usize) -> Facet {
        let (normal, point) = match self {
            // The two normals differ by rounding, and a path between two planes would pass the plate.
            Self::Hull(_) if index == 1 && self.is_flat() => {
                let Facet { normal, offset } = self.facet(0);
                return Facet { normal: -normal, offset: -offset };
            }
            Self::Hull(hull) => {
                let face = &hull.faces()[index];
                let vertex = hull.vertices_adj_to_face()[face.first_vertex_or_edge as usize];
                (face.normal, hull.points()[vertex as usize])
            }
            Self::Triangle(triangle, normal) => {
                (if index == 0 { *normal } else { -*normal }, triangle.a)
            }
        };
        Facet { normal, offset: normal.dot(point) }
    }

    /// Returns whether a point is right above or below a face.
    pub fn is_over(&self, index: usize, point: Vector) -> bool {
        match self {
            Self::Hull(hull) => {
                let face = &hull.faces()[index];
                let first = face.first_vertex_or_edge as usize;
                let count = face.num_vertices_or_edges as usize;
                let vertices = &hull.vertices_adj_to_face()[first..first + count];
                let corner = |at: usize| hull.points()[vertices[at % count] as usize];
                (0..count).all(|at| is_left(corner(at), corner(at + 1), face.normal, point))
            }
            Self::Triangle(Triangle { a, b, c }, normal) => {
                let edges = [(*a, *b), (*b, *c), (*c, *a)];
                edges.into_iter().all(|(from, to)| is_left(from, to, *normal, point))
            }
        }
    }

    /// Number of borders between faces.
    pub fn border_count(&self) -> usize {
        match self {
            Self::Hull(hull) => hull.edges().len(),
            Self::Triangle(..) => 3,
        }
    }

    /// The ends of a border between faces: an edge.
    pub fn border(&self, index: usize) -> [Vector; 2] {
        match self {
            Self::Hull(hull) => hull.edges()[index].vertices.map(|end| hull.points()[end as usize]),
            Self::Triangle(triangle, _) => {
                let points = [triangle.a, triangle.b, triangle.c];
                [points[index], points[(index + 1) % 3]]
            }
        }
    }
}

/// Returns whether all faces are flat within rounding. parry merges triangles that are nearly in a plane, up
/// to more than a degree, into one face.
fn has_flat_faces(hull: &ConvexPolyhedron) -> bool {
    let points = hull.points();
    // By Euler's formula, all faces are triangles if this holds.
    if hull.faces().len() + 4 == 2 * points.len() {
        return true;
    }
    if has_hidden_corners(hull) {
        return false;
    }
    hull.faces().iter().filter(|face| face.num_vertices_or_edges > 3).all(|face| {
        let first = face.first_vertex_or_edge as usize;
        let count = face.num_vertices_or_edges as usize;
        let corners = &hull.vertices_adj_to_face()[first..first + count];
        let origin = points[corners[0] as usize];
        corners[1..].iter().all(|&corner| {
            let along = points[corner as usize] - origin;
            let size = along.abs().max_element() + origin.abs().max_element();
            face.normal.dot(along).abs() <= PLANE_DISTANCE_FRACTION_MAX * size
        })
    })
}

/// Returns whether corners of a hull belong to no face, by Euler's formula. A corner all of whose triangles
/// parry merged into one face is above that face.
fn has_hidden_corners(hull: &ConvexPolyhedron) -> bool {
    let sides: usize = hull.faces().iter().map(|face| face.num_vertices_or_edges as usize).sum();
    hull.points().len() + hull.faces().len() != sides / 2 + 2
}

/// Returns whether a point is to the left of an edge, seen against the normal.
fn is_left(from: Vector, to: Vector, normal: Vector, point: Vector) -> bool {
    normal.cross(to - from).dot(point - from) >= 0.0
}
