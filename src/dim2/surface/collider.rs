//! Shapes whose constructors have something for each axis of 2D space, or that exist in 2D alone.

use crate::dim::math::{Real, Vector};
use crate::model::collider::ColliderBuilder;
use parry::shape::{Cuboid, RoundShape, SharedShape};

impl ColliderBuilder {
    /// A box around the origin, from its half extents along the axes.
    pub fn cuboid(hx: Real, hy: Real) -> Self {
        Self::new(SharedShape::new(Cuboid::new(Vector::new(hx, hy))))
    }

    /// A box, enlarged and rounded by `border_radius` on all sides.
    pub fn round_cuboid(hx: Real, hy: Real, border_radius: Real) -> Self {
        let inner_shape = Cuboid::new(Vector::new(hx, hy));
        Self::new(SharedShape::new(RoundShape { inner_shape, border_radius }))
    }
}
