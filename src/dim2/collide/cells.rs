//! The cells of height fields.

use super::flat::FlatShape;
use parry::bounding_volume::Aabb;
use parry::query::details::NormalConstraints;
use parry::shape::{HeightField, Shape};

/// Is called with a cell's number, its shape, and the normals that it may be hit along.
pub type CellVisitor<'a> = dyn FnMut(u32, &dyn Shape, Option<&dyn NormalConstraints>) + 'a;

/// Number of segments.
pub fn cell_count(field: &HeightField) -> usize {
    field.num_cells()
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
