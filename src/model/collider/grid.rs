//! Grids: their limits, and voxels that are the same on every machine.

use super::InvalidCollider;
use super::check::check_length;
use crate::base::measure::GRID_COORDINATE_MAX;
use crate::dim::math::{DIM, Real, Vector};
use parry::math::IVector;
use parry::shape::Voxels;

/// Cells that a grid over a whole shape may have: some 300 megabytes while it is filled.
const CELLS_MAX: Real = 67_108_864.0;

/// Voxels whose tree of chunks is the same on every machine.
///
/// parry's constructors insert chunks in the order of a hash map, which depends on the machine. The iteration
/// order of voxels follows from it. Setting cells one by one inserts chunks in the order of the cells. The
/// cells are sorted, so voxels that are saved and loaded are visited in the same order as before.
pub(super) fn voxels_of(voxel_size: Vector, mut cells: Vec<IVector>) -> Voxels {
    cells.sort_unstable_by_key(IVector::to_array);
    let mut voxels = Voxels::new(voxel_size, &[]);
    for cell in cells {
        voxels.set_voxel(cell, true);
    }
    voxels
}

/// The cells of voxels that are filled.
pub(super) fn filled_cells(voxels: &Voxels) -> Vec<IVector> {
    let filled = voxels.voxels().filter(|voxel| !voxel.state.is_empty());
    filled.map(|voxel| voxel.grid_coords).collect()
}

/// Refuses an empty list of cells, cells without size, and cells too far from the origin.
pub(super) fn check_cells(
    voxel_size: Vector,
    cells: impl ExactSizeIterator<Item = Vector>,
) -> Result<(), InvalidCollider> {
    voxel_size.to_array().into_iter().try_for_each(|size| check_length("voxel_size", size))?;
    if cells.len() == 0 {
        return Err(InvalidCollider::TooFew { parameter: "voxels", count: 0, least: 1 });
    }
    for (position, cell) in cells.enumerate() {
        if cell.abs().max_element() > GRID_COORDINATE_MAX {
            return Err(InvalidCollider::Point {
                parameter: "grid coordinates",
                position,
                value: cell,
            });
        }
    }
    Ok(())
}

/// Refuses a grid over all vertices that would have too many cells, or cells too far from the origin.
pub(super) fn check_fineness(vertices: &[Vector], cell: Real) -> Result<(), InvalidCollider> {
    let lowest = vertices.iter().copied().fold(Vector::splat(Real::MAX), Vector::min);
    let highest = vertices.iter().copied().fold(Vector::splat(Real::MIN), Vector::max);
    let counts = ((highest - lowest) / cell).to_array();
    let cells: Real = counts.iter().map(|count| count.ceil().max(2.0) + 1.0).product();
    let reach = lowest.abs().max(highest.abs()).max_element() / cell;
    if cells <= CELLS_MAX && reach <= GRID_COORDINATE_MAX {
        return Ok(());
    }
    Err(InvalidCollider::TooFine { parameter: "voxel_size", cells, most: CELLS_MAX })
}

/// Refuses a resolution (cells along the longest side) whose grid would have too many cells.
pub(super) fn check_resolution(resolution: u32) -> Result<(), InvalidCollider> {
    let cells: Real = [resolution as Real; DIM].iter().product();
    if cells <= CELLS_MAX {
        return Ok(());
    }
    Err(InvalidCollider::TooFine { parameter: "resolution", cells, most: CELLS_MAX })
}
