//! Shapes whose constructors have a parameter per axis of 2D space, and shapes that exist in 2D only.

use crate::base::parry_version::PolylineFlags;
use crate::dim::flat_hull::{FlatHull, flat_hull, rounded_flat_hull};
use crate::dim::hull;
use crate::dim::math::{Real, Vector};
use crate::model::collider::check::{check_margin, check_points};
use crate::model::collider::{ColliderBuilder, InvalidCollider};
use parry::shape::{ConvexPolygon, Cuboid, HeightField, RoundShape, SharedShape};

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
    /// A convex polygon from its corners in order, in either orientation, without a hull computation. Corners
    /// on a line make a segment.
    ///
    /// `None` if a coordinate is not finite, or if the polygon is not convex, or if its corners coincide.
    pub fn convex_polyline(points: Vec<Vector>) -> Option<Self> {
        Self::try_convex_polyline(points).ok()
    }

    /// A convex polygon as [`Self::convex_polyline`], or the reason why there is none.
    ///
    /// # Errors
    /// If a coordinate is not finite, or if the polygon is not convex, or if its corners coincide.
    pub fn try_convex_polyline(points: Vec<Vector>) -> Result<Self, InvalidCollider> {
        outline_with(points, SharedShape::new, SharedShape::new)
    }

    /// A convex polygon as [`Self::convex_polyline`], enlarged and rounded by `border_radius` on all
    /// sides: a capsule if the corners lie on a line. `None` also if the border is negative or not finite.
    pub fn round_convex_polyline(points: Vec<Vector>, border_radius: Real) -> Option<Self> {
        check_margin("border_radius", border_radius).ok()?;
        let solid = |inner_shape| SharedShape::new(RoundShape { inner_shape, border_radius });
        outline_with(points, solid, |flat| rounded_flat_hull(flat, border_radius)).ok()
    }

    /// A one-sided chain of segments: solid on the left of each segment, seen along its direction. A closed
    /// counter-clockwise chain is thus solid inside. Without indices, each vertex is joined to the next one.
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

/// A convex outline, finished by `solid` or, if its corners lie on a line, by `flat`.
fn outline_with(
    points: Vec<Vector>,
    solid: impl Fn(ConvexPolygon) -> SharedShape,
    flat: impl Fn(FlatHull) -> SharedShape,
) -> Result<ColliderBuilder, InvalidCollider> {
    check_points("points", &points)?;
    let line = flat_hull(&points).map(flat);
    let outline = hull::convex_outline(points).map(solid).or(line);
    outline.map(ColliderBuilder::new).ok_or(InvalidCollider::Degenerate {
        shape: "convex polygon",
        reason: "its corners are not those of a convex outline",
    })
}

#[cfg(test)]
mod tests {
    use crate::dim::math::{Real, Vector};
    use crate::model::collider::ColliderBuilder;

    const NOT_SIZES: [Real; 3] = [-1.0, Real::NAN, Real::INFINITY];

    #[track_caller]
    fn assert_impossible(builder: &ColliderBuilder, word: &str) {
        let reason = builder.try_build().map(|_| ()).expect_err("nothing was refused");
        assert!(reason.to_string().contains(word), "{reason:?} lacks `{word}`");
        assert!(!builder.build().is_enabled());
    }

    fn points(corners: &[[Real; 2]]) -> Vec<Vector> {
        corners.iter().copied().map(Vector::from_array).collect()
    }

    #[test]
    fn good_input_builds() {
        let square = points(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
        let all = [
            ColliderBuilder::cuboid(1.0, 2.0),
            ColliderBuilder::round_cuboid(1.0, 2.0, 0.0),
            ColliderBuilder::convex_polyline(square.clone()).expect("a square"),
            ColliderBuilder::round_convex_polyline(square.clone(), 0.1).expect("a square"),
            ColliderBuilder::oriented_polyline(square, None),
            ColliderBuilder::heightfield(vec![0.0, 1.0, 0.5], Vector::new(10.0, 2.0)),
        ];
        for builder in all {
            let collider = builder.try_build().expect("nothing is wrong with it");
            let mass = collider.mass();
            assert!(mass.is_finite() && mass >= 0.0, "{builder:?}");
        }
    }

    #[test]
    fn bad_lengths_are_refused_by_name() {
        for bad in NOT_SIZES {
            assert_impossible(&ColliderBuilder::cuboid(bad, 1.0), "half_extents");
            assert_impossible(&ColliderBuilder::cuboid(1.0, bad), "half_extents");
            assert_impossible(&ColliderBuilder::round_cuboid(1.0, bad, 0.1), "half_extents");
            assert_impossible(&ColliderBuilder::round_cuboid(1.0, 1.0, bad), "border_radius");
            let square = points(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]]);
            assert!(ColliderBuilder::round_convex_polyline(square, bad).is_none());
        }
        for bad in [0.0, Real::NAN, Real::INFINITY] {
            let field = ColliderBuilder::heightfield(vec![0.0, 1.0], Vector::new(bad, 1.0));
            assert_impossible(&field, "scale");
        }
    }

    #[test]
    fn height_fields_need_two_finite_heights() {
        for few in [vec![], vec![1.0]] {
            assert_impossible(&ColliderBuilder::heightfield(few, Vector::ONE), "at least 2");
        }
        for bad in [Real::NAN, Real::INFINITY, Real::MAX] {
            let field = ColliderBuilder::heightfield(vec![0.0, bad], Vector::ONE);
            assert_impossible(&field, "heights");
        }
    }

    #[test]
    fn outlines_may_go_round_either_way_but_must_be_convex() {
        let mut square = points(&[[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [2.0, 2.0], [0.0, 2.0]]);
        for _ in 0..2 {
            let polygon = ColliderBuilder::convex_polyline(square.clone()).expect("a square");
            let collider = polygon.build();
            assert!((collider.volume() - 4.0).abs() < 1.0e-5);
            let corners = collider.shape().as_convex_polygon().map(|p| p.points().len());
            assert_eq!(corners, Some(4), "the corner in the middle of a side is none");
            square.reverse();
        }
        let bad = [
            points(&[]),
            points(&[[1.0, 0.0], [1.0, 0.0]]),
            points(&[[0.0, 0.0], [2.0, 0.0], [1.0, 0.2], [1.0, 2.0]]),
            points(&[[0.0, 0.0], [1.0, Real::NAN], [1.0, 1.0]]),
        ];
        for outline in bad {
            assert!(ColliderBuilder::convex_polyline(outline.clone()).is_none(), "{outline:?}");
            assert!(ColliderBuilder::round_convex_polyline(outline, 0.1).is_none());
        }
    }

    #[test]
    fn a_finely_rounded_outline_keeps_its_shape() {
        let corner =
            |i: u32| Vector::from_angle(std::f64::consts::TAU as Real * i as Real / 2000.0);
        let circle: Vec<_> = (0..2000).map(corner).collect();
        let polygon = ColliderBuilder::convex_polyline(circle).expect("nearly a circle");
        let disc = ColliderBuilder::ball(1.0).build().volume();
        assert!((polygon.build().volume() / disc - 1.0).abs() < 1.0e-3);
    }

    #[test]
    fn triangles_are_turned_about_their_centre_of_mass() {
        let [a, b, c] = [[5.0, 5.0], [8.0, 5.0], [5.0, 9.0]].map(Vector::from_array);
        let found = ColliderBuilder::triangle(a, b, c).density(2.0).build().mass_properties();
        // Mass over 36 times the sum of the squared sides.
        let expected = 12.0 / 36.0 * (9.0 + 16.0 + 25.0);
        assert!((found.mass() - 12.0).abs() < 1.0e-4);
        assert!((found.principal_inertia() - expected).abs() < 1.0e-3, "{found:?}");
    }
}
