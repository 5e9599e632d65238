//! Shapes whose constructors have something for each axis of 2D space, or that exist in 2D alone.

use crate::dim::hull;
use crate::dim::math::{Real, Vector};
use crate::model::collider::{ColliderBuilder, check_points};
use parry::shape::{ConvexPolygon, Cuboid, HeightField, PolylineFlags, RoundShape, SharedShape};

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

impl ColliderBuilder {
    /// A convex polygon from its corners in order, either way round, without looking for the hull.
    ///
    /// `None` if a coordinate is not finite, or if the polygon is not convex or has no area.
    pub fn convex_polyline(points: Vec<Vector>) -> Option<Self> {
        convex_outline(points).map(|polygon| Self::new(SharedShape::new(polygon)))
    }

    /// A convex polygon as [`Self::convex_polyline`], enlarged and rounded by `border_radius` on all
    /// sides. `None` also if the border is negative or not finite.
    pub fn round_convex_polyline(points: Vec<Vector>, border_radius: Real) -> Option<Self> {
        Self::round(convex_outline(points), border_radius)
    }

    /// A chain of segments that is solid on one side: on the left of each segment, seen along its
    /// direction, so that a closed chain that goes round counter-clockwise is solid inside. Without
    /// indices, each vertex is joined to the next one.
    pub fn oriented_polyline(vertices: Vec<Vector>, indices: Option<Vec<[u32; 2]>>) -> Self {
        Self::polyline_with_flags(vertices, indices, PolylineFlags::ORIENTED)
    }

    /// A chain of segments over an interval of the x axis, from its heights at regular distances.
    /// `scale.x` is the length of the interval, whose centre is the origin; `scale.y` multiplies the
    /// heights.
    pub fn heightfield(heights: Vec<Real>, scale: Vector) -> Self {
        Self::of_heights(heights.len(), || HeightField::new(heights, scale))
    }
}

fn convex_outline(points: Vec<Vector>) -> Option<ConvexPolygon> {
    check_points("points", &points).ok()?;
    hull::convex_outline(points)
}
