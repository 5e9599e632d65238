//! Shapes whose constructors have something for each axis of 3D space, or that exist in 3D alone.

use crate::dim::math::{Real, Vector};
use crate::model::collider::ColliderBuilder;
use parry::shape::{Cone, Cuboid, Cylinder, RoundShape, SharedShape};

impl ColliderBuilder {
    /// A box around the origin, from its half extents along the axes.
    pub fn cuboid(hx: Real, hy: Real, hz: Real) -> Self {
        Self::new(SharedShape::new(Cuboid::new(Vector::new(hx, hy, hz))))
    }

    /// A box, enlarged and rounded by `border_radius` on all sides.
    pub fn round_cuboid(hx: Real, hy: Real, hz: Real, border_radius: Real) -> Self {
        let inner_shape = Cuboid::new(Vector::new(hx, hy, hz));
        Self::new(SharedShape::new(RoundShape { inner_shape, border_radius }))
    }

    /// A capsule along the z axis: all points at most `radius` from the segment between the two points
    /// at `half_height` from the origin.
    pub fn capsule_z(half_height: Real, radius: Real) -> Self {
        Self::capsule_along(Vector::Z, half_height, radius)
    }

    /// A cylinder around the y axis.
    pub fn cylinder(half_height: Real, radius: Real) -> Self {
        Self::new(SharedShape::new(Cylinder { half_height, radius }))
    }

    /// A cylinder around the y axis, enlarged and rounded by `border_radius` on all sides.
    pub fn round_cylinder(half_height: Real, radius: Real, border_radius: Real) -> Self {
        let inner_shape = Cylinder { half_height, radius };
        Self::new(SharedShape::new(RoundShape { inner_shape, border_radius }))
    }

    /// A cone around the y axis, its tip up, its base of radius `radius` at `-half_height`.
    pub fn cone(half_height: Real, radius: Real) -> Self {
        Self::new(SharedShape::new(Cone { half_height, radius }))
    }

    /// A cone around the y axis, enlarged and rounded by `border_radius` on all sides.
    pub fn round_cone(half_height: Real, radius: Real, border_radius: Real) -> Self {
        let inner_shape = Cone { half_height, radius };
        Self::new(SharedShape::new(RoundShape { inner_shape, border_radius }))
    }
}
