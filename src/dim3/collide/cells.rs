//! The cells of height fields.

use super::flat::FlatShape;
use parry::bounding_volume::Aabb;
use parry::query::details::NormalConstraints;
use parry::shape::{HeightField, HeightFieldFlags, Shape};

/// Is called with a cell's number, its shape, and the normals that it may be hit along.
pub type CellVisitor<'a> = dyn FnMut(u32, &dyn Shape, Option<&dyn NormalConstraints>) + 'a;

/// Number of triangles.
pub fn cell_count(field: &HeightField) -> usize {
    2 * field.nrows() * field.ncols()
}

/// Calls `f` with the number, shape and normal constraints of each triangle near `region`.
pub fn for_each_cell(field: &HeightField, region: &Aabb, f: &mut CellVisitor<'_>) {
    field.map_elements_in_local_aabb(region, &mut |id, triangle| {
        let normals = field.triangle_normal_constraints(id);
        f(id, triangle, normals.as_ref().map(|normals| normals as &dyn NormalConstraints));
    });
}

/// Returns whether the triangles are two-sided.
pub fn has_free_cells(field: &HeightField) -> bool {
    !field.flags().contains(HeightFieldFlags::FIX_INTERNAL_EDGES)
}

/// Calls `f` with the number and shape of each triangle near `region`.
pub fn for_each_free_cell(field: &HeightField, region: &Aabb, mut f: impl FnMut(u32, &FlatShape)) {
    field.map_elements_in_local_aabb(region, &mut f);
}

/// Calls `f` with the triangle of a number.
pub fn with_cell(field: &HeightField, id: u32, f: &mut dyn FnMut(&dyn Shape)) {
    if let Some(triangle) = field.triangle_at_id(id) {
        f(&triangle);
    }
}
