//! The cells of height fields.

use super::flat::FlatShape;
use crate::base::blocks::Block;
use crate::base::walk::range;
use crate::dim::math::{Int, Vector};
use parry::bounding_volume::Aabb;
use parry::query::details::NormalConstraints;
use parry::shape::{HeightField, HeightFieldFlags, Shape};

/// Is called with a cell's number, its shape, and the normals that it may be hit along.
pub type CellVisitor<'a> = dyn FnMut(u32, &dyn Shape, Option<&dyn NormalConstraints>) + 'a;

/// Number of triangles.
pub fn cell_count(field: &HeightField) -> usize {
    2 * field.nrows() * field.ncols()
}

/// All cells, by rows and columns.
pub fn all_cells(field: &HeightField) -> Block<2> {
    [[0, field.nrows() as Int], [0, field.ncols() as Int]]
}

/// A box around the triangles of some cells. The heights are those of the whole field unless it is one cell.
pub fn box_of_cells(field: &HeightField, cells: &Block<2>) -> Aabb {
    let [[i, i_end], [j, j_end]] = cells.map(|ends| ends.map(|end| end as usize));
    let (mut low, mut high) = (field.local_aabb().mins.y, field.local_aabb().maxs.y);
    if (i_end - i, j_end - j) == (1, 1) {
        let corners = [(i, j), (i_end, j), (i, j_end), (i_end, j_end)];
        let heights = corners.map(|at| field.heights()[at] * field.scale().y);
        [low, high] = range(&heights);
    }
    let corners = [
        Vector::new(field.x_at(j), low, field.z_at(i)),
        Vector::new(field.x_at(j_end), high, field.z_at(i_end)),
    ];
    Aabb::new(corners[0].min(corners[1]), corners[0].max(corners[1]))
}

/// Calls `f` with the number and shape of each triangle of a cell.
pub fn for_each_of_cell(field: &HeightField, [i, j]: [Int; 2], f: &mut dyn FnMut(u32, &dyn Shape)) {
    let (i, j) = (i as usize, j as usize);
    let (left, right) = field.triangles_at(i, j);
    // Left triangles are numbered first, column by column.
    let (rows, columns) = (field.nrows(), field.ncols());
    for (triangle, first) in [(left, 0), (right, rows * columns)] {
        if let Some(triangle) = triangle {
            f((first + j * rows + i) as u32, &triangle);
        }
    }
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
