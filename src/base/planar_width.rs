//! The minimum width of a convex set in the plane.
//!
//! The width of a convex set `K` along a unit vector `n` is the support function of its difference set:
//!
//! ```text
//! w(n) = h(n) + h(-n),  h(n) = max n·x over x in K;   w is the support function of K - K
//! ```
//!
//! So the minimum width is the radius of the largest disc about the origin inside `K - K`. An inscribed
//! polygon of `K - K` grows until its nearest side lies on the boundary. Each iteration inserts the vertex
//! where the difference set extends farthest beyond that side. (The expanding polytope algorithm of van den
//! Bergen, "Collision Detection in Interactive 3D Environments", 2003, run on one set.) Each nearest side is
//! a lower bound of the minimum width, so the result is never too large. The result is exact for a convex
//! polygon. The last side is the difference of one of its sides and a vertex, as in rotating calipers.

use parry::math::{Real, Rotation, Vector};
use parry::shape::Triangle;

/// Relative underestimate of a minimum width.
pub const WIDTH_TOLERANCE: Real = 0.02;
/// Vertices after which the search ends with the lower bound that it has: four times as many as a disc takes
/// at the tolerance.
const VERTICES_MAX: usize = 128;

/// A direction and a width along it.
#[derive(Copy, Clone, Debug)]
pub struct PlanarWidth {
    /// Unit vector.
    pub axis: [Real; 2],
    /// No more than the width along any direction (length units).
    pub least: Real,
    /// The width along the axis.
    pub width: Real,
}

/// An orthogonal frame whose first axis is the direction of minimum width, and widths along its axes.
#[derive(Copy, Clone, Debug)]
pub struct NarrowFrame {
    /// From the frame to the shape's.
    pub axes: Rotation,
    /// The widths along the axes (length units).
    pub widths: Vector,
    /// The minimum width, or a little less.
    pub least: Real,
}

/// Finds the minimum width of a set, given `difference(n)`: a point of its difference set that is farthest
/// along `n`.
pub fn minimum_width(difference: impl Fn([Real; 2]) -> [Real; 2]) -> PlanarWidth {
    let first = farther(difference([1.0, 0.0]), difference([0.0, 1.0]));
    let second = difference(perpendicular(first).unwrap_or([1.0, 0.0]));
    let mut polygon = vec![first, second, scaled(first, -1.0), scaled(second, -1.0)];
    let mut best = PlanarWidth { axis: [0.0, 1.0], least: 0.0, width: 0.0 };
    loop {
        let Some((at, normal, dist)) = nearest_side(&polygon) else { return best };
        let found = difference(normal);
        best = PlanarWidth { axis: normal, least: dist, width: dot(found, normal).max(dist) };
        let is_on_boundary = best.width <= dist * (1.0 + WIDTH_TOLERANCE);
        if is_on_boundary || polygon.len() >= VERTICES_MAX {
            return best;
        }
        // The set is symmetric, and the polygon stays symmetric: the vertices in its second half are the
        // negated vertices of the first.
        let half = polygon.len() / 2;
        polygon.insert(half + at + 1, scaled(found, -1.0));
        polygon.insert(at + 1, found);
    }
}

/// The side in the first half of a polygon that is nearest to the origin: its number, its outward normal and
/// its distance. `None` if the polygon is flat.
fn nearest_side(polygon: &[[Real; 2]]) -> Option<(usize, [Real; 2], Real)> {
    let sides = (0..polygon.len() / 2).map(|at| {
        let (from, to) = (polygon[at], polygon[at + 1]);
        let outward = perpendicular([from[0] - to[0], from[1] - to[1]])?;
        Some((at, outward, dot(outward, from)))
    });
    let flat: Option<Vec<_>> = sides.collect();
    let nearest = flat?.into_iter().min_by(|(.., dist1), (.., dist2)| dist1.total_cmp(dist2));
    nearest.filter(|(.., dist)| *dist > 0.0)
}

/// The outward unit normals of a triangle's edges, in its plane; fewer if it is degenerate.
pub fn edge_normals(triangle: &Triangle) -> Vec<Vector> {
    let Triangle { a, b, c } = *triangle;
    let normal = |[from, to, across]: [Vector; 3]| {
        let along = (to - from).try_normalize()?;
        let inward = across - from;
        (along * inward.dot(along) - inward).try_normalize()
    };
    [[a, b, c], [b, c, a], [c, a, b]].into_iter().filter_map(normal).collect()
}

fn farther(a: [Real; 2], b: [Real; 2]) -> [Real; 2] {
    if dot(a, a) >= dot(b, b) { a } else { b }
}

/// The unit vector a quarter turn ahead; `None` of zero.
fn perpendicular([x, y]: [Real; 2]) -> Option<[Real; 2]> {
    let length = (x * x + y * y).sqrt();
    let is_usable = length > 0.0 && length.is_finite();
    is_usable.then(|| [-y / length, x / length])
}

fn dot([ax, ay]: [Real; 2], [bx, by]: [Real; 2]) -> Real {
    ax * bx + ay * by
}

fn scaled([x, y]: [Real; 2], factor: Real) -> [Real; 2] {
    [x * factor, y * factor]
}
