//! The axes along which a convex shape is narrowest, in 3D.
//!
//! As in `src/base/planar_width.rs` the minimum width of `K` is the radius of the largest ball about the
//! origin inside `K - K`. An inscribed polytope of `K - K` grows until its nearest face lies on the boundary.
//! Of a polyhedron that face is the difference of a face and a vertex, or of two edges. These are the two
//! kinds of pairs that can attain the minimum width (Houle and Toussaint, "Computing the Width of a Set",
//! 1988). The search evaluates a few dozen supports instead of all pairs.

use super::math::{Real, Rotation, Vector, tangents};
use crate::base::planar_width::{
    NarrowFrame, PlanarWidth, WIDTH_TOLERANCE, edge_normals, minimum_width,
};
use parry::shape::{Cone, ConvexPolyhedron, Cylinder, TypedShape};

/// Supports after which the search ends with the lower bound that it has. A ball takes 60 at the tolerance.
const SUPPORTS_MAX: usize = 128;
/// A vertex is beyond a face if it is farther from it than this part of its distance from the origin.
const ROUNDING: Real = 8.0 * Real::EPSILON;

/// Finds the frame of a convex shape from its support points. The second axis is the narrowest one across the
/// first.
pub fn narrow_frame(support: impl Fn(Vector) -> Vector) -> NarrowFrame {
    let difference = |along: Vector| support(along) - support(-along);
    let (axis, width, least) = narrowest(&difference);
    let [u, v] = tangents(axis);
    let PlanarWidth { axis: [x, y], least: second_width, .. } = minimum_width(|[x, y]| {
        let point = difference(u * x + v * y);
        [point.dot(u), point.dot(v)]
    });
    let second = u * x + v * y;
    let third = axis.cross(second);
    let axes = super::math::Matrix::from_cols(axis, second, third);
    let third_width = difference(third).dot(third);
    NarrowFrame {
        axes: Rotation::from_mat3(&axes).normalize(),
        widths: Vector::new(width, second_width, third_width),
        least,
    }
}

/// The direction of minimum width of a difference set, the width along it, and a lower bound of the minimum
/// width.
fn narrowest(difference: &impl Fn(Vector) -> Vector) -> (Vector, Real, Real) {
    let mut polytope = match Polytope::octahedron(difference) {
        Ok(polytope) => polytope,
        Err(normal) => return (normal, difference(normal).dot(normal).max(0.0), 0.0),
    };
    let mut best = (Vector::X, difference(Vector::X).dot(Vector::X), 0.0);
    for _ in 0..SUPPORTS_MAX {
        let Some(Face { normal, dist, .. }) = polytope.nearest_face() else { break };
        let found = difference(normal);
        best = (normal, found.dot(normal).max(dist), dist);
        let is_on_boundary = best.1 <= dist * (1.0 + WIDTH_TOLERANCE);
        if is_on_boundary || !(polytope.add(found) && polytope.add(-found)) {
            break;
        }
    }
    best
}

/// A face of an inscribed polytope.
#[derive(Copy, Clone)]
struct Face {
    corners: [u32; 3],
    /// Outward unit normal.
    normal: Vector,
    /// Distance of its plane from the origin.
    dist: Real,
}

/// A polytope around the origin with its corners on the boundary of a convex set.
struct Polytope {
    points: Vec<Vector>,
    faces: Vec<Face>,
    horizon: Vec<[u32; 2]>,
}

impl Polytope {
    /// An octahedron in a symmetric set; the normal of the set if that is flat.
    fn octahedron(difference: &impl Fn(Vector) -> Vector) -> Result<Self, Vector> {
        let longest = |points: &[Vector]| {
            let lengths =
                |a: &&Vector, b: &&Vector| a.length_squared().total_cmp(&b.length_squared());
            points.iter().max_by(lengths).copied().unwrap_or(Vector::X)
        };
        let a = longest(&[Vector::X, Vector::Y, Vector::Z].map(difference));
        let along = a.try_normalize().ok_or(Vector::X)?;
        let across = |p: Vector| p - along * p.dot(along);
        let [u, v] = tangents(along).map(difference);
        let b = if across(u).length_squared() >= across(v).length_squared() { u } else { v };
        let normal = along.cross(b).try_normalize().ok_or(tangents(along)[0])?;
        let c = difference(normal);
        let mut polytope =
            Self { points: vec![a, b, c, -a, -b, -c], faces: vec![], horizon: vec![] };
        for signs in 0..8 {
            let corner = |k: u32| if signs >> k & 1 == 0 { k } else { k + 3 };
            let [i, j, k] = [corner(0), corner(1), corner(2)];
            let is_mirrored = (signs as u32).count_ones() % 2 == 1;
            let corners = if is_mirrored { [i, k, j] } else { [i, j, k] };
            if !polytope.add_face(corners) {
                return Err(normal);
            }
        }
        Ok(polytope)
    }

    fn nearest_face(&self) -> Option<Face> {
        self.faces.iter().min_by(|a, b| a.dist.total_cmp(&b.dist)).copied()
    }

    /// Adds a corner. Returns whether the polytope is still closed.
    fn add(&mut self, point: Vector) -> bool {
        let Self { points, faces, horizon } = self;
        horizon.clear();
        let slack = ROUNDING * point.length();
        faces.retain(|face| {
            let is_beyond = face.normal.dot(point) > face.dist + slack;
            if is_beyond {
                let [a, b, c] = face.corners;
                for [from, to] in [[a, b], [b, c], [c, a]] {
                    // A side that two faces had that are gone is not on the horizon.
                    match horizon.iter().position(|side| *side == [to, from]) {
                        Some(at) => drop(horizon.swap_remove(at)),
                        None => horizon.push([from, to]),
                    }
                }
            }
            !is_beyond
        });
        let corner = points.len() as u32;
        points.push(point);
        let sides = core::mem::take(horizon);
        let is_closed = sides.iter().all(|&[from, to]| self.add_face([from, to, corner]));
        self.horizon = sides;
        is_closed
    }

    /// Returns whether the face has an area, and the origin on its inner side.
    fn add_face(&mut self, corners: [u32; 3]) -> bool {
        let [a, b, c] = corners.map(|corner| self.points[corner as usize]);
        let Some(normal) = (b - a).cross(c - a).try_normalize() else { return false };
        let dist = normal.dot(a).max(0.0);
        self.faces.push(Face { corners, normal, dist });
        dist > 0.0
    }
}

/// The corners of a hull and the layer around them, if the shape is one.
pub fn corners(shape: TypedShape<'_>) -> Option<(&[Vector], Real)> {
    match shape {
        TypedShape::ConvexPolyhedron(c) => Some((ConvexPolyhedron::points(c), 0.0)),
        TypedShape::RoundConvexPolyhedron(c) => Some((c.inner_shape.points(), c.border_radius)),
        _ => None,
    }
}

/// The axis-aligned frame of a shape of this dimension that has one: its centre of mass, its half extents,
/// and half its minimum width.
pub fn aligned(shape: TypedShape<'_>) -> Option<(Vector, Vector, Real)> {
    match shape {
        TypedShape::Cylinder(c) => Some(of_cylinder(c)),
        TypedShape::RoundCylinder(c) => {
            Some(with_layer(of_cylinder(&c.inner_shape), c.border_radius))
        }
        TypedShape::Cone(c) => Some(of_cone(c)),
        TypedShape::RoundCone(c) => Some(with_layer(of_cone(&c.inner_shape), c.border_radius)),
        _ => None,
    }
}

/// At an angle to the axis with sine `s` and cosine `c`, the width of a cylinder is `2 (r s + h c)`. The
/// minimum is at one of the ends.
fn of_cylinder(cylinder: &Cylinder) -> (Vector, Vector, Real) {
    let (r, h) = (cylinder.radius, cylinder.half_height);
    (Vector::ZERO, Vector::new(r, h, r), r.min(h))
}

/// The width of a cone of height `H` is `r s + max(H c, r s)`. The minimum is along its axis (`H`) or where
/// the two are equal, between a side and the opposite rim: `2 r H / √(r² + H²)`.
fn of_cone(cone: &Cone) -> (Vector, Vector, Real) {
    let (r, h) = (cone.radius, cone.half_height);
    let height = 2.0 * h;
    let across = r * (height / (r * r + height * height).sqrt());
    (Vector::new(0.0, -0.5 * h, 0.0), Vector::new(r, h, r), h.min(across))
}

fn with_layer(
    (center, half, thickness): (Vector, Vector, Real),
    layer: Real,
) -> (Vector, Vector, Real) {
    (center, half + Vector::splat(layer), thickness + layer)
}

/// The outward unit normals of all faces of a hull or triangle. Those of a cone are the base and one side,
/// which are sufficient; other shapes have none.
pub fn face_normals(shape: TypedShape<'_>) -> Vec<Vector> {
    let of_hull = |hull: &ConvexPolyhedron| hull.faces().iter().map(|face| face.normal).collect();
    match shape {
        TypedShape::ConvexPolyhedron(c) => of_hull(c),
        TypedShape::RoundConvexPolyhedron(c) => of_hull(&c.inner_shape),
        TypedShape::Triangle(t) => edge_normals(t),
        TypedShape::RoundTriangle(t) => edge_normals(&t.inner_shape),
        TypedShape::Cone(c) => normals_of_cone(c),
        TypedShape::RoundCone(c) => normals_of_cone(&c.inner_shape),
        _ => Vec::new(),
    }
}

fn normals_of_cone(cone: &Cone) -> Vec<Vector> {
    let side = Vector::new(2.0 * cone.half_height, cone.radius, 0.0);
    [-Vector::Y, side].into_iter().filter_map(Vector::try_normalize).collect()
}

/// Returns whether a triangle encloses an area.
pub const TRIANGLES_ARE_SOLID: bool = false;
