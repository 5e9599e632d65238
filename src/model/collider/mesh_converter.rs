//! Conversions of a triangle mesh into one collider.

use super::decomposition::{decompose, decompose_closely};
use super::shapes::{hull_of, trimesh_shape};
use super::{ColliderBuilder, InvalidCollider};
use crate::dim::math::{Pose, Rotation, Vector};
use crate::dim::shapes;
use parry::bounding_volume::Aabb;
use parry::shape::{Cuboid, SharedShape, TriMeshFlags};
use parry::transformation::vhacd::VHACDParameters;

/// Conversion of a render mesh into a collider.
#[derive(Copy, Clone, Debug, Default, PartialEq)]
pub enum MeshConverter {
    /// A surface of the same triangles.
    #[default]
    TriMesh,
    /// A surface of the same triangles, with parry's options for it.
    TriMeshWithFlags(TriMeshFlags),
    /// An oriented bounding box of the mesh.
    Obb,
    /// The axis-aligned bounding box of the mesh.
    Aabb,
    /// Its convex hull.
    ConvexHull,
    /// A compound of convex parts, approximately: as `ColliderBuilder::convex_decomposition`.
    ConvexDecomposition,
    /// A compound of convex parts, computed with the given parameters.
    ConvexDecompositionWithParams(VHACDParameters),
}

impl MeshConverter {
    /// The shape, and its pose in the frame of the mesh.
    ///
    /// # Errors
    /// If a coordinate is not finite, an index is out of range, or the mesh is empty. If the mesh is flat and
    /// the result must have a volume.
    pub fn convert(
        &self,
        vertices: Vec<Vector>,
        indices: Vec<[u32; 3]>,
    ) -> Result<(SharedShape, Pose), InvalidCollider> {
        // An invalid mesh is invalid for all conversions, also for those that need no triangles.
        let flags =
            if let Self::TriMeshWithFlags(flags) = self { *flags } else { TriMeshFlags::empty() };
        let mesh = trimesh_shape(vertices.clone(), indices.clone(), flags)?;
        let shape = match self {
            Self::TriMesh | Self::TriMeshWithFlags(_) => mesh,
            Self::Obb => return box_around(&vertices, shapes::spread_directions(&vertices)),
            Self::Aabb => return box_around(&vertices, Rotation::IDENTITY),
            Self::ConvexHull => hull_of(&vertices)?,
            Self::ConvexDecomposition => {
                decompose_closely(&vertices, &shapes::surface_of(&indices), SharedShape::new)?
            }
            Self::ConvexDecompositionWithParams(params) => {
                decompose(&vertices, &shapes::surface_of(&indices), params, SharedShape::new)?
            }
        };
        Ok((shape, Pose::IDENTITY))
    }
}

/// The box around some points whose sides have the given rotation.
fn box_around(
    points: &[Vector],
    rotation: Rotation,
) -> Result<(SharedShape, Pose), InvalidCollider> {
    let into_box = rotation.inverse();
    let aabb = Aabb::from_points(points.iter().map(|point| into_box * *point));
    let cuboid = Cuboid::new(aabb.half_extents());
    super::check::check_shape(&cuboid)?;
    Ok((SharedShape::new(cuboid), Pose::from_parts(rotation * aabb.center(), rotation)))
}

impl ColliderBuilder {
    /// A collider that the `converter` makes of a triangle mesh.
    ///
    /// # Errors
    /// See [`MeshConverter::convert`].
    pub fn converted_trimesh(
        vertices: Vec<Vector>,
        indices: Vec<[u32; 3]>,
        converter: MeshConverter,
    ) -> Result<Self, InvalidCollider> {
        let (shape, pose) = converter.convert(vertices, indices)?;
        Ok(Self::new(shape).position(pose))
    }
}
