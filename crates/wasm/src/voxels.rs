//! Voxels of colliders: edits, and joints between two grids.

use crate::fault::{Fault, Kind};
use crate::handle::Handle;
use crate::memory;
use crate::rapier::geometry::{Collider, ColliderHandle, Voxels};
use crate::rapier::math::DIM;
use crate::rapier::parry::math::IVector;
use crate::registry::{collider, collider_mut, write};

fn voxels(collider: &mut Collider) -> Result<&mut Voxels, Fault> {
    let voxels = collider.shape_mut().as_shape_mut::<Voxels>();
    voxels.ok_or_else(|| {
        Fault::new(Kind::WrongShape, "the shape of the collider is not Voxels".to_string())
    })
}

/// Grid coordinates from the integers that JavaScript wrote.
fn coordinates(integers: &[u32]) -> Result<IVector, Fault> {
    let cell: Option<[u32; DIM]> = integers.get(..DIM).and_then(|cell| cell.try_into().ok());
    let cell = cell.ok_or_else(|| {
        Fault::number(
            "the number of grid coordinates",
            integers.len() as f64,
            "that of the dimensions",
        )
    })?;
    Ok(IVector::from_array(cell.map(|component| component as i32 as _)))
}

/// The voxels of two colliders.
fn pair(
    world: u32,
    handles: [f64; 2],
    work: impl FnOnce(&mut Voxels, &mut Voxels),
) -> Result<(), Fault> {
    for handle in handles {
        collider(world, handle)?;
    }
    let [first, second] = handles.map(ColliderHandle::of_number);
    let (Some(first), Some(second)) = write(world)?.colliders.get_pair_mut(first, second) else {
        return Err(Fault::invalid("the two colliders are the same"));
    };
    work(voxels(first)?, voxels(second)?);
    Ok(())
}

exports! {
    /// Fills or empties a voxel: grid coordinates and a flag.
    fn collider_set_voxel(world: u32, handle: f64) {
        let integers = memory::integers();
        let collider = collider_mut(world, handle)?;
        let is_filled = integers.get(DIM).is_some_and(|filled| *filled != 0);
        voxels(collider)?.set_voxel(coordinates(&integers)?, is_filled);
    }

    /// Reports the change of a voxel to its neighbours in another grid: grid coordinates and the shift of the
    /// grids.
    fn collider_propagate_voxel(world: u32, handle1: f64, handle2: f64) {
        let integers = memory::integers();
        let (cell, shift) = (coordinates(&integers)?, coordinates(integers.get(DIM..).unwrap_or(&[]))?);
        pair(world, [handle1, handle2], |first, second| {
            first.propagate_voxel_change(second, cell, shift);
        })?;
    }

    /// Joins the voxels of two grids: the shift of the grids.
    fn collider_combine_voxels(world: u32, handle1: f64, handle2: f64) {
        let shift = coordinates(&memory::integers())?;
        pair(world, [handle1, handle2], |first, second| first.combine_voxel_states(second, shift))?;
    }
}
