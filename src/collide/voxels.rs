//! Voxels as boxes whose contacts leave through free faces only.

use super::part::Part;
use crate::dim::math::{DIM, Pose, Vector};
use parry::bounding_volume::Aabb;
use parry::query::details::NormalConstraints;
use parry::shape::{AxisMask, Cuboid, VoxelType, Voxels};

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
