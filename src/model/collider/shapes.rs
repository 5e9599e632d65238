//! One constructor for each shape.
//!
//! Those whose parameters depend on the dimension (cuboids, for one) stand in `dim2/surface` and
//! `dim3/surface`.

use super::ColliderBuilder;
use crate::dim::math::{Real, Vector};
use parry::shape::{Ball, Capsule, HalfSpace, Segment, SharedShape, Triangle};

/// Simple shapes.
impl ColliderBuilder {
    /// A ball around the origin.
    pub fn ball(radius: Real) -> Self {
        Self::new(SharedShape::new(Ball::new(radius)))
    }

    /// Everything below a plane through the origin. `outward_normal` is the unit normal of the plane,
    /// pointing out of the solid side.
    pub fn halfspace(outward_normal: Vector) -> Self {
        Self::new(SharedShape::new(HalfSpace::new(outward_normal)))
    }

    /// A capsule along the x axis: all points at most `radius` from the segment between the two points
    /// at `half_height` from the origin.
    pub fn capsule_x(half_height: Real, radius: Real) -> Self {
        Self::capsule_along(Vector::X, half_height, radius)
    }

    /// A capsule along the y axis: all points at most `radius` from the segment between the two points
    /// at `half_height` from the origin.
    pub fn capsule_y(half_height: Real, radius: Real) -> Self {
        Self::capsule_along(Vector::Y, half_height, radius)
    }

    pub(crate) fn capsule_along(axis: Vector, half_height: Real, radius: Real) -> Self {
        let end = axis * half_height;
        let shape = SharedShape::new(Capsule::new(-end, end, radius));
        Self::of(super::check::check_margin("half_height", half_height).map(|()| shape))
    }

    /// A capsule: all points at most `radius` from the segment from `a` to `b`.
    pub fn capsule_from_endpoints(a: Vector, b: Vector, radius: Real) -> Self {
        Self::new(SharedShape::new(Capsule::new(a, b, radius)))
    }

    /// The segment from `a` to `b`. It has no volume and so no mass from a density.
    pub fn segment(a: Vector, b: Vector) -> Self {
        Self::new(SharedShape::new(Segment::new(a, b)))
    }

    /// A triangle. In 3D it has no volume and so no mass from a density.
    pub fn triangle(a: Vector, b: Vector, c: Vector) -> Self {
        Self::new(SharedShape::new(Triangle::new(a, b, c)))
    }
}
