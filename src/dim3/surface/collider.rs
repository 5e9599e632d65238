//! Shapes whose constructors have a parameter per axis of 3D space, and shapes that exist in 3D only.

use crate::dim::hull;
use crate::dim::math::{Real, Vector};
use crate::model::collider::check::{check_elements, check_margin, check_points};
use crate::model::collider::{ColliderBuilder, InvalidCollider};
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
    /// A convex polyhedron from its corners and triangles, without a computation of the hull. The triangles
    /// must enclose a convex solid, which is not checked, and must all have the same winding. Points in a
    /// plane make a flat plate.
    ///
    /// `None` if a coordinate is not finite, an index is out of range, or the triangles are not closed.
    pub fn convex_mesh(points: Vec<Vector>, indices: &[[u32; 3]]) -> Option<Self> {
        Self::try_convex_mesh(points, indices).ok()
    }

    /// A convex polyhedron as [`Self::convex_mesh`], or the reason why there is none.
    ///
    /// # Errors
    /// If a coordinate is not finite, an index is out of range, or the triangles are not closed.
    pub fn try_convex_mesh(
        points: Vec<Vector>,
        indices: &[[u32; 3]],
    ) -> Result<Self, InvalidCollider> {
        convex_mesh(points, indices).map(|solid| Self::new(SharedShape::new(solid)))
    }

    /// A convex polyhedron as [`Self::convex_mesh`], enlarged and rounded by `border_radius` on all
    /// sides. `None` also if the border is negative or not finite.
    pub fn round_convex_mesh(
        points: Vec<Vector>,
        indices: &[[u32; 3]],
        border_radius: Real,
    ) -> Option<Self> {
        check_margin("border_radius", border_radius).ok()?;
        let round = RoundShape { inner_shape: convex_mesh(points, indices).ok()?, border_radius };
        Some(Self::new(SharedShape::new(round)))
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

fn convex_mesh(
    points: Vec<Vector>,
    indices: &[[u32; 3]],
) -> Result<ConvexPolyhedron, InvalidCollider> {
    check_points("points", &points)?;
    check_elements("indices", indices, points.len())?;
    hull::convex_mesh(points, indices).ok_or(InvalidCollider::Degenerate {
        shape: "convex mesh",
        reason: "its triangles are not closed, or their windings differ",
    })
}

#[cfg(test)]
mod tests {
    use crate::dim::math::{Real, Vector};
    use crate::model::collider::ColliderBuilder;
    use parry::shape::{Cuboid, HeightFieldFlags};
    use parry::utils::Array2;

    const NOT_SIZES: [Real; 3] = [-1.0, Real::NAN, Real::INFINITY];

    #[track_caller]
    fn assert_impossible(builder: &ColliderBuilder, word: &str) {
        let reason = builder.try_build().map(|_| ()).expect_err("nothing was refused");
        assert!(reason.to_string().contains(word), "{reason:?} lacks `{word}`");
        assert!(!builder.build().is_enabled());
    }

    fn heights(rows: usize, columns: usize) -> Array2<Real> {
        Array2::from_fn(rows, columns, |i, j| (i * j) as Real)
    }

    #[test]
    fn good_input_builds() {
        let (points, indices) = Cuboid::new(Vector::ONE).to_trimesh();
        let scale = Vector::new(10.0, 2.0, 20.0);
        let flags = HeightFieldFlags::FIX_INTERNAL_EDGES;
        let all = [
            ColliderBuilder::cuboid(1.0, 2.0, 3.0),
            ColliderBuilder::round_cuboid(1.0, 2.0, 3.0, 0.0),
            ColliderBuilder::capsule_z(1.0, 0.5),
            ColliderBuilder::cylinder(1.0, 0.5),
            ColliderBuilder::round_cylinder(1.0, 0.5, 0.1),
            ColliderBuilder::cone(1.0, 0.5),
            ColliderBuilder::round_cone(1.0, 0.5, 0.1),
            ColliderBuilder::convex_mesh(points.clone(), &indices).expect("a box"),
            ColliderBuilder::round_convex_mesh(points, &indices, 0.1).expect("a box"),
            ColliderBuilder::heightfield(heights(2, 5), scale),
            ColliderBuilder::heightfield_with_flags(heights(5, 2), scale, flags),
        ];
        for builder in all {
            let collider = builder.try_build().expect("nothing is wrong with it");
            let mass = collider.mass();
            assert!(mass.is_finite() && mass >= 0.0, "{builder:?}");
            let reach = collider.bounding_radius_about(Vector::ZERO);
            let aabb = collider.compute_aabb();
            let size = aabb.maxs.abs().max(aabb.mins.abs());
            let bounds = 0.999 * size.max_element()..=1.001 * size.length();
            assert!(bounds.contains(&reach), "{builder:?}");
        }
    }

    #[test]
    fn bad_lengths_are_refused_by_name() {
        for bad in NOT_SIZES {
            for builder in [
                ColliderBuilder::cuboid(bad, 1.0, 1.0),
                ColliderBuilder::cuboid(1.0, bad, 1.0),
                ColliderBuilder::cuboid(1.0, 1.0, bad),
                ColliderBuilder::round_cuboid(1.0, 1.0, bad, 0.1),
            ] {
                assert_impossible(&builder, "half_extents");
            }
            for builder in [
                ColliderBuilder::cylinder(1.0, bad),
                ColliderBuilder::cone(1.0, bad),
                ColliderBuilder::capsule_z(1.0, bad),
                ColliderBuilder::round_cylinder(1.0, bad, 0.1),
                ColliderBuilder::round_cone(1.0, bad, 0.1),
            ] {
                assert_impossible(&builder, "radius");
            }
            for builder in [
                ColliderBuilder::cylinder(bad, 1.0),
                ColliderBuilder::cone(bad, 1.0),
                ColliderBuilder::round_cylinder(bad, 1.0, 0.1),
                ColliderBuilder::round_cone(bad, 1.0, 0.1),
            ] {
                assert_impossible(&builder, "half_height");
            }
            let round = ColliderBuilder::round_cone(1.0, 1.0, bad);
            assert_impossible(&round, "border_radius");
            let round = ColliderBuilder::round_cuboid(1.0, 1.0, 1.0, bad);
            assert_impossible(&round, "border_radius");
        }
        for bad in [0.0, Real::NAN, Real::INFINITY] {
            let field = ColliderBuilder::heightfield(heights(2, 2), Vector::new(1.0, 1.0, bad));
            assert_impossible(&field, "scale");
        }
    }

    #[test]
    fn height_fields_need_two_finite_rows_and_columns() {
        for (rows, columns) in [(0, 0), (1, 5), (5, 1)] {
            let field = ColliderBuilder::heightfield(heights(rows, columns), Vector::ONE);
            assert_impossible(&field, "at least 2");
        }
        for bad in [Real::NAN, Real::INFINITY, Real::MAX] {
            let heights = Array2::from_fn(3, 3, |i, j| if i == j { bad } else { 0.0 });
            let field = ColliderBuilder::heightfield(heights, Vector::ONE);
            assert_impossible(&field, "heights");
        }
        let high = Array2::from_fn(2, 2, |_, _| 1.0e12);
        let field = ColliderBuilder::heightfield(high, Vector::splat(1.0e12));
        assert_impossible(&field, "bounding box");
    }

    #[test]
    fn convex_meshes_may_be_wound_either_way_but_must_be_closed() {
        let (points, indices) = Cuboid::new(Vector::ONE).to_trimesh();
        let reversed: Vec<_> = indices.iter().map(|t| [t[0], t[2], t[1]]).collect();
        for triangles in [&indices, &reversed] {
            let solid = ColliderBuilder::convex_mesh(points.clone(), triangles).expect("a box");
            assert!((solid.build().volume() - 8.0).abs() < 1.0e-4);
        }
        let mut more = points.clone();
        more.push(Vector::splat(50.0));
        let solid = ColliderBuilder::convex_mesh(more, &indices).expect("a box").build();
        assert_eq!(solid.compute_aabb().maxs, Vector::ONE, "the unused corner is none");
        let mut mixed = indices.clone();
        mixed[0].swap(0, 1);
        let mut endless = points.clone();
        endless[3].y = Real::NAN;
        let bad = [
            (points.clone(), mixed),
            (points.clone(), indices[1..].to_vec()),
            (points.clone(), vec![]),
            (points[..7].to_vec(), indices.clone()),
            (vec![], indices.clone()),
            (endless, indices.clone()),
        ];
        for (points, triangles) in bad {
            assert!(ColliderBuilder::convex_mesh(points.clone(), &triangles).is_none());
            assert!(ColliderBuilder::round_convex_mesh(points, &triangles, 0.1).is_none());
        }
        assert!(ColliderBuilder::round_convex_mesh(points, &indices, -0.1).is_none());
    }

    #[test]
    fn a_finely_rounded_convex_mesh_keeps_its_faces_apart() {
        let (points, indices) = parry::shape::Ball::new(1.0).to_trimesh(200, 100);
        let solid = ColliderBuilder::convex_mesh(points, &indices).expect("nearly a ball");
        let volume = solid.build().volume();
        let ball = ColliderBuilder::ball(1.0).build().volume();
        assert!((0.85..1.0).contains(&(volume / ball)), "{volume}");
    }
}
