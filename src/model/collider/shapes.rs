//! One constructor for each shape.
//!
//! Constructors whose parameters depend on the dimension (cuboids, for example) are in `dim2/surface` and
//! `dim3/surface`. Values on which parry's constructor panics are checked before the call. The numbers of a
//! shape without parts are checked when the collider is built.

use super::accept::{accept_parts, accept_shape};
use super::check::{check_elements, check_length, check_margin, check_points};
use super::{ColliderBuilder, InvalidCollider, grid};
use crate::base::guard::guarded;
use crate::base::parry_version::{PolylineFlags, polyline};
use crate::dim::flat_hull::{FlatHull, flat_hull, rounded_flat_hull};
use crate::dim::hull;
use crate::dim::math::{DIM, Pose, Real, Vector};
use parry::math::{IVector, ivect_to_vect};
use parry::shape::{
    Ball, Capsule, Compound, HalfSpace, HeightField, RoundShape, Segment, SharedShape, TriMesh,
    TriMeshBuilderError, TriMeshFlags, Triangle, Voxels,
};
use parry::transformation::voxelization::FillMode;

/// Simple shapes.
impl ColliderBuilder {
    /// A ball around the origin.
    pub fn ball(radius: Real) -> Self {
        Self::new(SharedShape::new(Ball::new(radius)))
    }

    /// The half-space below a plane through the origin. `outward_normal` is the unit normal of the plane, and
    /// points out of the solid side.
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
        Self::of(check_margin("half_height", half_height).map(|()| shape))
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

    /// A triangle, enlarged and rounded by `border_radius` on all sides.
    pub fn round_triangle(a: Vector, b: Vector, c: Vector, border_radius: Real) -> Self {
        let inner_shape = Triangle::new(a, b, c);
        Self::new(SharedShape::new(RoundShape { inner_shape, border_radius }))
    }
}

/// Shapes made of others.
impl ColliderBuilder {
    /// Several shapes as one rigid shape, each with its pose in the frame of the compound. The parts cannot
    /// be composite themselves (compounds, meshes, polylines, height fields).
    pub fn compound(shapes: Vec<(Pose, SharedShape)>) -> Self {
        let accepted = accept_parts(&shapes);
        Self::of(accepted.map(|copies| SharedShape::new(Compound::new(copies.unwrap_or(shapes)))))
    }

    /// A chain of segments. Without indices, each vertex is joined to the next vertex.
    pub fn polyline(vertices: Vec<Vector>, indices: Option<Vec<[u32; 2]>>) -> Self {
        Self::polyline_with_flags(vertices, indices, PolylineFlags::empty())
    }

    /// A chain of segments, with parry's options for it. Without indices, each vertex is joined to the
    /// next one.
    pub fn polyline_with_flags(
        vertices: Vec<Vector>,
        indices: Option<Vec<[u32; 2]>>,
        flags: PolylineFlags,
    ) -> Self {
        let checked = check_points("vertices", &vertices).and_then(|()| match &indices {
            Some(indices) => check_elements("indices", indices, vertices.len()),
            None if vertices.len() < 2 => {
                let count = vertices.len();
                Err(InvalidCollider::TooFew { parameter: "vertices", count, least: 2 })
            }
            None => Ok(()),
        });
        let shape = checked.map(|()| polyline(vertices, indices, flags));
        Self::of(shape.map(SharedShape::new))
    }

    /// A height field with `least` samples along its shorter side; less than two make none.
    pub(crate) fn of_heights(least: usize, make: impl FnOnce() -> HeightField) -> Self {
        if least < 2 {
            let parameter = "heights along one side";
            Self::of(Err(InvalidCollider::TooFew { parameter, count: least, least: 2 }))
        } else {
            Self::new(SharedShape::new(make()))
        }
    }

    /// A surface of triangles. It is hollow: in 3D, contacts do not push out a body that is completely
    /// inside.
    ///
    /// # Errors
    /// If there is no triangle, an index is out of range, a coordinate is not finite, or all triangles
    /// are degenerate.
    pub fn trimesh(vertices: Vec<Vector>, indices: Vec<[u32; 3]>) -> Result<Self, InvalidCollider> {
        Self::trimesh_with_flags(vertices, indices, TriMeshFlags::empty())
    }

    /// A surface of triangles, with parry's options for it.
    ///
    /// # Errors
    /// As for [`Self::trimesh`], and if no triangle is left after the requested deletions.
    pub fn trimesh_with_flags(
        vertices: Vec<Vector>,
        indices: Vec<[u32; 3]>,
        flags: TriMeshFlags,
    ) -> Result<Self, InvalidCollider> {
        trimesh_shape(vertices, indices, flags).map(Self::new)
    }
}

pub(super) fn trimesh_shape(
    vertices: Vec<Vector>,
    indices: Vec<[u32; 3]>,
    flags: TriMeshFlags,
) -> Result<SharedShape, InvalidCollider> {
    check_points("vertices", &vertices)?;
    if indices.is_empty() {
        return Err(TriMeshBuilderError::EmptyIndices.into());
    }
    check_elements("indices", &indices, vertices.len())?;
    let mesh = TriMesh::with_flags(vertices, indices, flags)?;
    if mesh.indices().is_empty() {
        return Err(TriMeshBuilderError::EmptyIndices.into());
    }
    accept_shape(&SharedShape::new(mesh))
}

/// Convex shapes from points.
impl ColliderBuilder {
    /// The smallest convex shape around some points. Points in a plane make a flat plate in 3D, points on a
    /// line make a segment in 2D.
    ///
    /// `None` if a coordinate is not finite, or if the points lie on a line (in 2D: coincide).
    pub fn convex_hull(points: &[Vector]) -> Option<Self> {
        Self::try_convex_hull(points).ok()
    }

    /// A shape as [`Self::convex_hull`], or the reason why there is none.
    ///
    /// # Errors
    /// If a coordinate is not finite, or if the points lie on a line (in 2D: coincide).
    pub fn try_convex_hull(points: &[Vector]) -> Result<Self, InvalidCollider> {
        hull_of(points).map(Self::new)
    }

    /// The smallest convex shape around some points, enlarged and rounded by `border_radius` on all
    /// sides. In 2D, points on a line make a capsule.
    ///
    /// `None` if a number is not finite, the border negative, or if the points lie on a line (in 2D:
    /// coincide).
    pub fn round_convex_hull(points: &[Vector], border_radius: Real) -> Option<Self> {
        Self::try_round_convex_hull(points, border_radius).ok()
    }

    /// A shape as [`Self::round_convex_hull`], or the reason why there is none.
    ///
    /// # Errors
    /// If a number is not finite, the border negative, or if the points lie on a line (in 2D: coincide).
    pub fn try_round_convex_hull(
        points: &[Vector],
        border_radius: Real,
    ) -> Result<Self, InvalidCollider> {
        check_margin("border_radius", border_radius)?;
        let solid = |inner_shape| SharedShape::new(RoundShape { inner_shape, border_radius });
        hull_with(points, solid, |flat| rounded_flat_hull(flat, border_radius)).map(Self::new)
    }
}

/// The convex hull of some points.
pub(super) fn hull_of(points: &[Vector]) -> Result<SharedShape, InvalidCollider> {
    hull_with(points, SharedShape::new, SharedShape::new)
}

/// The convex hull of some points, finished by `solid` or, if it is flat, by `flat`.
fn hull_with(
    points: &[Vector],
    solid: impl Fn(hull::ConvexShape) -> SharedShape,
    flat: impl Fn(FlatHull) -> SharedShape,
) -> Result<SharedShape, InvalidCollider> {
    check_points("points", points)?;
    if points.len() < DIM {
        let count = points.len();
        return Err(InvalidCollider::TooFew { parameter: "points", count, least: DIM });
    }
    let degenerate =
        InvalidCollider::Degenerate { shape: "convex hull", reason: hull::DEGENERATE_REASON };
    let hull = hull::convex_hull(points).map(solid);
    hull.or_else(|| flat_hull(points).map(flat)).ok_or(degenerate)
}

/// Shapes made of equal boxes.
impl ColliderBuilder {
    /// Boxes of one size at integer positions of a grid: the one at `(0, 0, …)` reaches from the origin
    /// to `voxel_size`.
    pub fn voxels(voxel_size: Vector, grid_coordinates: &[IVector]) -> Self {
        Self::of(
            grid::check_cells(voxel_size, grid_coordinates.iter().map(|c| ivect_to_vect(*c)))
                .map(|()| SharedShape::new(grid::voxels_of(voxel_size, grid_coordinates.to_vec()))),
        )
    }

    /// The boxes of a grid that contain at least one of the points.
    pub fn voxels_from_points(voxel_size: Vector, points: &[Vector]) -> Self {
        let checked = check_points("points", points).and_then(|()| {
            grid::check_cells(voxel_size, points.iter().map(|point| *point / voxel_size))
        });
        Self::of(checked.map(|()| {
            let voxels = Voxels::new(voxel_size, &[]);
            let cells = points.iter().map(|&point| voxels.voxel_at_point(point)).collect();
            SharedShape::new(grid::voxels_of(voxel_size, cells))
        }))
    }

    /// The boxes of a grid that a surface passes through and, depending on `fill_mode`, those that it
    /// encloses. The surface consists of segments in 2D and of triangles in 3D.
    pub fn voxelized_mesh(
        vertices: &[Vector],
        indices: &[[u32; DIM]],
        voxel_size: Real,
        fill_mode: FillMode,
    ) -> Self {
        let checked = check_surface(vertices, indices)
            .and_then(|()| check_length("voxel_size", voxel_size))
            .and_then(|()| grid::check_fineness(vertices, voxel_size));
        Self::of(checked.and_then(|()| {
            let shape =
                guarded(|| SharedShape::voxelized_mesh(vertices, indices, voxel_size, fill_mode));
            let voxels = shape.as_ref().and_then(|shape| shape.as_voxels());
            let voxels = voxels.ok_or(InvalidCollider::Degenerate {
                shape: "mesh",
                reason: "the geometry library cannot turn it into voxels",
            })?;
            let cells = grid::filled_cells(voxels);
            Ok(SharedShape::new(grid::voxels_of(voxels.voxel_size(), cells)))
        }))
    }
}

/// Refuses invalid surfaces of elements (segments in 2D, triangles in 3D).
pub(super) fn check_surface(
    vertices: &[Vector],
    indices: &[[u32; DIM]],
) -> Result<(), InvalidCollider> {
    check_points("vertices", vertices)?;
    check_elements("indices", indices, vertices.len())
}
