//! Voxels as boxes whose contacts leave through free faces only.

use super::part::Part;
use crate::base::blocks::Block;
use crate::dim::math::{DIM, Int, Pose, Vector};
use parry::bounding_volume::Aabb;
use parry::math::IVector;
use parry::query::details::NormalConstraints;
use parry::shape::{AxisMask, Cuboid, VoxelType, Voxels};

/// Length of the storage's chunks (voxels). In larger blocks, a search for a voxel is cheap.
const CHUNK_LENGTH: Int = 8;

/// Calls `f` with each voxel in `region` that has a free face.
///
/// The grid would be sufficient to find neighbours, but a box sliding over many voxels must not catch on the
/// faces between them. Such normals are limited to the free faces, or refused.
pub(super) fn for_each_voxel(voxels: &Voxels, region: &Aabb, f: &mut dyn FnMut(Part<'_>)) {
    let cube = Cuboid::new(voxels.voxel_size() * 0.5);
    for voxel in voxels.voxels_intersecting_local_aabb(region) {
        if matches!(voxel.state.voxel_type(), VoxelType::Empty | VoxelType::Interior) {
            continue;
        }
        let faces = FreeFaces(voxel.state.free_faces());
        f(Part {
            id: voxel.linear_id.flat_id() as u32,
            pose: Some(&Pose::from_translation(voxel.center)),
            shape: &cube,
            constraints: Some(&faces),
        });
    }
}

/// The cells among which all voxels are.
pub(super) fn all_voxels(voxels: &Voxels) -> Block<DIM> {
    let [first, end] = voxels.domain().map(|corner| corner.to_array());
    // The domain is computed from coordinates, whose rounding may hide the last cells.
    core::array::from_fn(|axis| [first[axis].saturating_sub(1), end[axis].saturating_add(1)])
}

/// A box around some cells.
pub(super) fn box_of_voxels(voxels: &Voxels, cells: &Block<DIM>) -> Aabb {
    let [first, end] = corners(cells);
    voxels.voxel_range_aabb(first, end)
}

/// Returns whether some cells may contain a voxel. Only large blocks are searched.
pub(super) fn may_have_voxels(voxels: &Voxels, cells: &Block<DIM>) -> bool {
    let is_large = cells.iter().any(|[first, end]| end.saturating_sub(*first) > CHUNK_LENGTH);
    let [first, end] = corners(cells);
    !is_large || voxels.voxels_in_range(first, end).next().is_some()
}

fn corners(cells: &Block<DIM>) -> [IVector; 2] {
    [0, 1].map(|side| IVector::from_array(cells.map(|ends| ends[side])))
}

/// Calls `f` with the voxel of a cell, as if it stood alone. No effect if the cell is empty.
pub(super) fn with_voxel_at(voxels: &Voxels, cell: [Int; DIM], f: &mut dyn FnMut(Part<'_>)) {
    let key = IVector::from_array(cell);
    let is_filled = voxels.voxel_state(key).is_some_and(|state| !state.is_empty());
    let Some(index) = voxels.linear_index(key).filter(|_| is_filled) else { return };
    f(Part {
        id: index.flat_id() as u32,
        pose: Some(&Pose::from_translation(voxels.voxel_center(key))),
        shape: &Cuboid::new(voxels.voxel_size() * 0.5),
        constraints: None,
    });
}

/// Calls `f` with the voxel of a number, as if it stood alone.
pub(super) fn with_voxel(voxels: &Voxels, id: u32, f: &mut dyn FnMut(Part<'_>)) {
    let Some(key) = voxels.voxel_at_flat_id(id) else { return };
    f(Part {
        id,
        pose: Some(&Pose::from_translation(voxels.voxel_center(key))),
        shape: &Cuboid::new(voxels.voxel_size() * 0.5),
        constraints: None,
    });
}

/// The faces of a voxel that no other voxel covers.
struct FreeFaces(AxisMask);

impl NormalConstraints for FreeFaces {
    fn project_local_normal_mut(&self, normal: &mut Vector) -> bool {
        for axis in 0..DIM {
            // The bits of the mask are +x, -x, +y, -y, …
            let bit = 2 * axis + usize::from(normal[axis] < 0.0);
            if self.0.bits() & (1 << bit) == 0 {
                normal[axis] = 0.0;
            }
        }
        match normal.try_normalize() {
            Some(unit) => {
                *normal = unit;
                true
            }
            None => false,
        }
    }
}
