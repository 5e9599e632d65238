//! The saved form of a shape.
//!
//! parry's own format contains derived data (trees of boxes, topology, adjacency) and loads it unchecked: an
//! index out of range panics in some later query. Here, shapes made of many parts are saved as the lists that
//! they were made of, and built again. The same lists give the same tree. Convex hulls keep parry's form,
//! because another construction might number the faces differently: their indices are checked. (Of a compound
//! with pseudo-normals, the tolerance with which parry found neighbouring parts is not known: it is the
//! default.) The saved form is not recursive, so damaged data cannot exhaust the stack. Loaded shapes are
//! [checked](super::check) like shapes of the user.

use super::accept::accept_shape;
use super::check::{check_elements, check_parts, check_points};
use super::grid::filled_cells;
use super::shape_table::{self, OpenTable};
use super::{ColliderBuilder, ColliderSet, InvalidCollider};
use crate::base::fault::Fault;
use crate::base::parry_version::{
    CompoundFlags, PolylineFlags, compound, compound_flags, polyline, polyline_flags,
};
use crate::dim::math::{Pose, Vector};
use crate::dim::saved::{PlainShape, SavedField, check_hull};
use parry::math::IVector;
use parry::shape::{SharedShape, TriMeshFlags, TypedShape};
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

#[derive(Serialize, Deserialize)]
enum SavedShape {
    Plain(PlainShape),
    TriMesh {
        vertices: Vec<Vector>,
        indices: Vec<[u32; 3]>,
        flags: u16,
    },
    Polyline {
        vertices: Vec<Vector>,
        indices: Vec<[u32; 2]>,
        flags: u8,
    },
    HeightField(SavedField),
    Voxels {
        size: Vector,
        cells: Vec<IVector>,
    },
    Compound {
        parts: Vec<(Pose, PlainShape)>,
        flags: u8,
    },
    /// The same as an earlier [large](super::shape_table) shape of the set, with this number.
    Earlier(u32),
}

/// Saves a shape.
pub fn serialize<S: Serializer>(shape: &SharedShape, serializer: S) -> Result<S::Ok, S::Error> {
    if let Some(number) = shape_table::number_of(shape) {
        return SavedShape::Earlier(number).serialize(serializer);
    }
    let saved = SavedShape::of(shape).map_err(serde::ser::Error::custom)?;
    shape_table::enter(shape);
    saved.serialize(serializer)
}

/// Loads a shape.
pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<SharedShape, D::Error> {
    SavedShape::deserialize(deserializer)?.restore().map_err(D::Error::custom)
}

/// A shape that several colliders of a set use is saved once.
impl Serialize for ColliderSet {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let _table = OpenTable::new();
        // The associated function that the attribute `remote` derives.
        Self::serialize(self, serializer)
    }
}

impl<'de> Deserialize<'de> for ColliderSet {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let _table = OpenTable::new();
        Self::deserialize(deserializer)
    }
}

impl From<InvalidCollider> for Fault {
    fn from(invalid: InvalidCollider) -> Self {
        Self::new(format_args!("{invalid}"))
    }
}

impl SavedShape {
    fn of(shape: &SharedShape) -> Result<Self, Fault> {
        Ok(match shape.as_typed_shape() {
            TypedShape::TriMesh(mesh) => Self::TriMesh {
                vertices: mesh.vertices().to_vec(),
                indices: mesh.indices().to_vec(),
                flags: mesh.flags().bits(),
            },
            TypedShape::Polyline(line) => Self::Polyline {
                vertices: line.vertices().to_vec(),
                indices: line.indices().to_vec(),
                flags: polyline_flags(line).bits(),
            },
            TypedShape::HeightField(field) => Self::HeightField(SavedField::of(field)),
            TypedShape::Voxels(voxels) => {
                Self::Voxels { size: voxels.voxel_size(), cells: filled_cells(voxels) }
            }
            TypedShape::Compound(compound) => {
                let parts = compound.shapes().iter().map(|(pose, part)| Ok((*pose, plain(part)?)));
                let parts = parts.collect::<Result<_, Fault>>()?;
                Self::Compound { parts, flags: compound_flags(compound).bits() }
            }
            _ => Self::Plain(plain(shape)?),
        })
    }

    fn restore(self) -> Result<SharedShape, Fault> {
        let shape = match self {
            Self::Plain(shape) => restore_plain(shape)?,
            Self::TriMesh { vertices, indices, flags } => {
                let flags = TriMeshFlags::from_bits_truncate(flags);
                super::shapes::trimesh_shape(vertices, indices, flags)?
            }
            Self::Polyline { vertices, indices, flags } => {
                check_points("vertices", &vertices)?;
                check_elements("indices", &indices, vertices.len())?;
                let flags = PolylineFlags::from_bits_truncate(flags);
                SharedShape::new(polyline(vertices, Some(indices), flags))
            }
            Self::HeightField(field) => SharedShape::new(field.restore()?),
            Self::Voxels { size, cells } => {
                ColliderBuilder::voxels(size, &cells).try_build()?.shared_shape().clone()
            }
            Self::Compound { parts, flags } => {
                let parts = parts.into_iter().map(|(pose, part)| Ok((pose, restore_plain(part)?)));
                let parts = parts.collect::<Result<Vec<_>, Fault>>()?;
                check_parts(&parts)?;
                let flags = CompoundFlags::from_bits_truncate(flags);
                SharedShape::new(compound(parts, flags))
            }
            Self::Earlier(number) => {
                let missing = || Fault::new(format_args!("there is no earlier shape {number}"));
                return shape_table::shape_at(number).ok_or_else(missing);
            }
        };
        let shape = accept_shape(&shape)?;
        shape_table::enter(&shape);
        Ok(shape)
    }
}

/// # Errors
/// If the shape is user-defined: it has no saved form.
fn plain(shape: &SharedShape) -> Result<PlainShape, Fault> {
    let kind = shape.shape_type();
    PlainShape::of(shape.as_typed_shape())
        .ok_or_else(|| Fault::new(format_args!("a shape of type {kind:?} cannot be saved")))
}

/// # Errors
/// If the indices of a hull are out of range.
fn restore_plain(shape: PlainShape) -> Result<SharedShape, Fault> {
    let shape = shape.into_shared();
    check_hull(shape.as_typed_shape())?;
    Ok(shape)
}
