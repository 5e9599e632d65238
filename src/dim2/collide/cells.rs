//! The cells of height fields.

use super::flat::FlatShape;
use crate::base::blocks::Block;
use crate::base::walk::range;
use crate::dim::math::{Int, Real, Vector};
use parry::bounding_volume::Aabb;
use parry::query::details::NormalConstraints;
use parry::shape::{HeightField, Shape};

/// Is called with a cell's number, its shape, and the normals that it may be hit along.
pub type CellVisitor<'a> = dyn FnMut(u32, &dyn Shape, Option<&dyn NormalConstraints>) + 'a;

/// Number of segments.
pub fn cell_count(field: &HeightField) -> usize {
    field.num_cells()
}

/// All cells.
pub fn all_cells(field: &HeightField) -> Block<1> {
    [[0, field.num_cells() as Int]]
}

/// A box around the segments of some cells. The heights are those of the whole field unless it is one cell.
pub fn box_of_cells(field: &HeightField, [cells]: &Block<1>) -> Aabb {
    let [first, end] = cells.map(|cell| cell as usize);
    let (mut low, mut high) = (field.local_aabb().mins.y, field.local_aabb().maxs.y);
    if end - first == 1 {
        [low, high] = range(&[first, end].map(|at| field.heights()[at] * field.scale().y));
    }
    let width = 1.0 / field.num_cells() as Real;
    let place = |cell: usize| (-0.5 + width * cell as Real) * field.scale().x;
    let [left, right] = range(&[place(first), place(end)]);
    Aabb::new(Vector::new(left, low), Vector::new(right, high))
}

/// Calls `f` with the number and shape of the segment of a cell.
pub fn for_each_of_cell(field: &HeightField, [cell]: [Int; 1], f: &mut dyn FnMut(u32, &dyn Shape)) {
    if let Some(segment) = field.segment_at(cell as usize) {
        f(cell as u32, &segment);
    }
}

/// Calls `f` with the number, shape and normal constraints of each segment near `region`.
pub fn for_each_cell(field: &HeightField, region: &Aabb, f: &mut CellVisitor<'_>) {
    field.map_elements_in_local_aabb(region, &mut |id, segment| f(id, segment, None));
}

/// Returns whether the segments are two-sided.
pub fn has_free_cells(_field: &HeightField) -> bool {
    true
}

/// Calls `f` with the number and shape of each segment near `region`.
pub fn for_each_free_cell(field: &HeightField, region: &Aabb, mut f: impl FnMut(u32, &FlatShape)) {
    field.map_elements_in_local_aabb(region, &mut f);
}

/// Calls `f` with the segment of a number.
pub fn with_cell(field: &HeightField, id: u32, f: &mut dyn FnMut(&dyn Shape)) {
    if let Some(segment) = field.segment_at(id as usize) {
        f(&segment);
    }
}
