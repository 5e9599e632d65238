//! The point at which a line enters the difference of two convex shapes.
//!
//! The second shape touches the first after a path `s` along the unit vector `d` as soon as `s d` is in
//! `D = {a - b}`, for points `a` and `b` of the shapes. The smallest `s` is a linear program. Its variables
//! are the weights of the points of `D`. Their mean must lie on the line, and the cost is the place of the
//! mean on that line. The simplex method needs one point of `D` in each step, which the support functions of
//! the shapes return: the farthest along the normal of the plane through the points of the basis (Dantzig and
//! Wolfe, "Decomposition Principle for Linear Programs", 1960).
//!
//! Each step has two certain bounds. The mean of the basis is in `D`, so the touch is not later. The plane
//! through the new point separates the shapes, so the touch is not earlier. A search for closest points has
//! no such bounds, and fails for shapes that just touch.
//!
//! A small ball is added to `D`. Without it, the difference of a point and a segment had no inside, and
//! rounding decided whether a line meets that difference.

use crate::dim::math::{DIM, Matrix, Pose, Real, Vector};
use parry::shape::SupportMap;

/// Largest number of steps.
const STEPS_MAX: usize = 96;
/// Relative rounding error of a point of the difference.
const ROUNDING: Real = 4.0 * Real::EPSILON;
/// Smallest weight of a new point with regard to a point of the difference that it replaces. Smaller weights
/// are rounding errors of zero, where the line meets an edge of the basis; the next basis would be flat.
/// (The weights have the sum one, so one of them is large.) Points of the first basis are replaced in any
/// case: the difference may be as flat as rounding errors.
const PIVOT_MIN: Real = 1024.0 * Real::EPSILON;
/// The last axis.
const LAST: usize = DIM - 1;

/// Two convex shapes of which the second moves along a line.
pub(super) struct Line<'a> {
    pub shapes: [&'a dyn SupportMap; 2],
    /// The second shape in the frame of the first at the origin of the line.
    pub pose12: Pose,
    /// Unit vector.
    pub direction: Vector,
    /// The distance at which the shapes count as touching.
    pub distance: Real,
    /// Radius of the ball that is added to the difference. It exceeds the rounding error of the positions.
    pub rounding: Real,
    /// Largest distance of the two bounds.
    pub precision: Real,
    /// The sum of the largest coordinates of the two shapes.
    pub size: Real,
}

/// The first touch on a line.
#[derive(Copy, Clone, Debug)]
pub(super) struct Entry {
    /// The path until then. It is a lower bound.
    pub path: Real,
    /// Unit outward normal of the first shape.
    pub normal: Vector,
    /// The points that touch, each in the frame of its shape.
    pub points: [Vector; 2],
}

/// A point of the difference of the shapes, relative to the line, in units of their size. (The determinants
/// of small lengths would be no numbers.)
#[derive(Copy, Clone)]
struct Vertex {
    /// The coordinates across the line, and one.
    across: Vector,
    /// The place on the line.
    along: Real,
    /// The two points of which it is the difference.
    points: [Vector; 2],
    /// Whether the point is in the difference. Those of the first basis are artificial.
    is_real: bool,
}

/// A reflection that maps the last axis to the direction of the line or to the opposite direction.
struct Frame {
    mirror: Vector,
    /// The sign of the direction on the last axis.
    sign: Real,
}

impl Frame {
    fn new(direction: Vector) -> Self {
        let sign: Real = if direction[LAST] < 0.0 { -1.0 } else { 1.0 };
        let mut mirror = direction * sign;
        mirror[LAST] += 1.0;
        Self { mirror: mirror.normalize(), sign }
    }

    fn reflect(&self, v: Vector) -> Vector {
        v - self.mirror * (2.0 * self.mirror.dot(v))
    }
}

/// The basis of a step.
struct Basis {
    vertices: [Vertex; DIM],
    /// From the coordinates across the line to weights of the vertices.
    inverse: Matrix,
}

impl Basis {
    /// The corners of a simplex around the line, which are in no shape.
    fn around_line() -> Self {
        Self::new(core::array::from_fn(|k| {
            let mut across = if k == LAST { Vector::NEG_ONE } else { Vector::ZERO };
            if k < LAST {
                across[k] = 1.0;
            }
            across[LAST] = 1.0;
            Vertex { across, along: 0.0, points: [Vector::ZERO; 2], is_real: false }
        }))
    }

    fn new(vertices: [Vertex; DIM]) -> Self {
        let columns = vertices.map(|vertex| vertex.across.to_array());
        Self { vertices, inverse: Matrix::from_cols_array_2d(&columns).inverse() }
    }

    fn weights(&self, across: Vector) -> Vector {
        self.inverse * across
    }

    /// The weights of the vertices whose mean is on the line.
    fn mean(&self) -> Vector {
        self.weights(Vector::AXES[LAST])
    }

    /// Returns whether no vertex is artificial: the second phase of the simplex method.
    fn is_complete(&self) -> bool {
        self.vertices.iter().all(|vertex| vertex.is_real)
    }

    /// The affine function of the coordinates across the line that has the costs of the vertices. The cost
    /// is the place on the line. Until all vertices are points of the difference, it counts those that are
    /// not.
    fn costs(&self) -> Vector {
        let is_complete = self.is_complete();
        let cost = |vertex: &Vertex| match vertex.is_real {
            _ if is_complete => vertex.along,
            true => 0.0,
            false => 1.0,
        };
        self.inverse.transpose() * Vector::from_array(self.vertices.each_ref().map(cost))
    }

    /// The basis with a vertex in place of the one that would get the first negative weight.
    fn replaced(&self, vertex: Vertex) -> Self {
        let (mean, weights) = (self.mean(), self.weights(vertex.across));
        let ratio = |k: usize| {
            let pivot_min = if self.vertices[k].is_real { PIVOT_MIN } else { 0.0 };
            let may_leave = weights[k] > pivot_min;
            if may_leave { mean[k].max(0.0) / weights[k] } else { Real::INFINITY }
        };
        let order = |a: &usize, b: &usize| {
            ratio(*a).total_cmp(&ratio(*b)).then(weights[*b].total_cmp(&weights[*a]))
        };
        let mut vertices = self.vertices;
        if let Some(leaves) = (0..DIM).min_by(order) {
            vertices[leaves] = vertex;
        }
        Self::new(vertices)
    }

    fn points(&self) -> [Vector; 2] {
        let mean = self.mean();
        [0, 1].map(|side| (0..DIM).map(|k| self.vertices[k].points[side] * mean[k]).sum::<Vector>())
    }
}

impl Line<'_> {
    /// The first touch; `None` if there is none.
    pub fn enter(&self) -> Option<Entry> {
        let frame = Frame::new(self.direction);
        let mut basis = Basis::around_line();
        let mut best: Option<(Real, Vector)> = None;
        for _ in 0..STEPS_MAX {
            let (is_complete, costs) = (basis.is_complete(), basis.costs());
            let mut normal = costs;
            normal[LAST] = if is_complete { frame.sign } else { 0.0 };
            let (normal, slope) = frame.reflect(normal).normalize_and_length();
            if !normal.is_finite() {
                break; // The basis is flat within rounding.
            }
            let vertex = self.farthest(&frame, normal);
            let gain = costs.dot(vertex.across) - if is_complete { vertex.along } else { 0.0 };
            if !is_complete && gain <= 0.0 {
                return None; // The whole difference is on one side of the line.
            }
            if is_complete {
                // A plane that separates the shapes without the ball is reached that much later.
                let path = (costs[LAST] - gain) * self.size + self.rounding * slope;
                if best.is_none_or(|(last, _)| path > last) {
                    best = Some((path, normal));
                }
                let end = costs[LAST] * self.size - self.precision;
                let is_near = best.is_some_and(|(last, _)| last >= end);
                if is_near || gain <= ROUNDING * slope {
                    break;
                }
            }
            basis = basis.replaced(vertex);
        }
        let points = basis.points();
        best.map(|(path, normal)| Entry { path, normal, points })
    }

    /// The point of the difference that is farthest along a unit vector.
    fn farthest(&self, frame: &Frame, normal: Vector) -> Vertex {
        let [shape1, shape2] = self.shapes;
        let point1 = shape1.local_support_point(normal);
        let point2 = shape2.local_support_point(self.pose12.rotation.inverse() * -normal);
        let layer = normal * (self.distance + self.rounding);
        let mut across = frame.reflect((point1 - self.pose12 * point2 + layer) / self.size);
        let along = -frame.sign * across[LAST];
        across[LAST] = 1.0;
        Vertex { across, along, points: [point1, point2], is_real: true }
    }
}
