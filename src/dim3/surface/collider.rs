//! Shapes whose constructors have something for each axis of 3D space, or that exist in 3D alone.

use crate::dim::hull;
use crate::dim::math::{Real, Vector};
use crate::model::collider::{ColliderBuilder, check_points};
use parry::shape::{
    Cone, ConvexPolyhedron, Cuboid, Cylinder, HeightField, HeightFieldFlags, RoundShape,
    SharedShape,
};
use parry::utils::Array2;

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

impl ColliderBuilder {
    /// A convex polyhedron from its corners and triangles, without looking for the hull. They must
    /// enclose a convex solid (that is not checked), all with the same winding, whichever it is.
    ///
    /// `None` if a coordinate is not finite, an index out of range, or if the triangles do not enclose
    /// a volume.
    pub fn convex_mesh(points: Vec<Vector>, indices: &[[u32; 3]]) -> Option<Self> {
        convex_mesh(points, indices).map(|solid| Self::new(SharedShape::new(solid)))
    }

    /// A convex polyhedron as [`Self::convex_mesh`], enlarged and rounded by `border_radius` on all
    /// sides. `None` also if the border is negative or not finite.
    pub fn round_convex_mesh(
        points: Vec<Vector>,
        indices: &[[u32; 3]],
        border_radius: Real,
    ) -> Option<Self> {
        Self::round(convex_mesh(points, indices), border_radius)
    }

    /// A surface over a rectangle of the x-z plane, from its heights on a regular grid, rows along z
    /// and columns along x. `scale.x` and `scale.z` are the sides of the rectangle, whose centre is the
    /// origin; `scale.y` multiplies the heights.
    pub fn heightfield(heights: Array2<Real>, scale: Vector) -> Self {
        Self::heightfield_with_flags(heights, scale, HeightFieldFlags::empty())
    }

    /// A surface as [`Self::heightfield`], with parry's options for it.
    pub fn heightfield_with_flags(
        heights: Array2<Real>,
        scale: Vector,
        flags: HeightFieldFlags,
    ) -> Self {
        let least = heights.nrows().min(heights.ncols());
        Self::of_heights(least, || HeightField::with_flags(heights, scale, flags))
    }
}

fn convex_mesh(points: Vec<Vector>, indices: &[[u32; 3]]) -> Option<ConvexPolyhedron> {
    check_points("points", &points).ok()?;
    hull::convex_mesh(points, indices)
}
