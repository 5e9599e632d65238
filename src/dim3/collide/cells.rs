//! The elements of surfaces: the cells of height fields, and what is flat.

use crate::dim::math::Vector;
use parry::bounding_volume::Aabb;
use parry::query::details::NormalConstraints;
use parry::shape::{HeightField, Shape};

/// Is called with a cell's number, its shape, and the normals that it may be hit along.
pub type CellVisitor<'a> = dyn FnMut(u32, &dyn Shape, Option<&dyn NormalConstraints>) + 'a;

/// Calls `f` with the number, shape and normal constraints of each triangle near `region`.
pub fn for_each_cell(field: &HeightField, region: &Aabb, f: &mut CellVisitor<'_>) {
    field.map_elements_in_local_aabb(region, &mut |id, triangle| {
        let normals = field.triangle_normal_constraints(id);
        f(id, triangle, normals.as_ref().map(|normals| normals as &dyn NormalConstraints));
    });
}

/// Calls `f` with the triangle of a number.
pub fn with_cell(field: &HeightField, id: u32, f: &mut dyn FnMut(&dyn Shape)) {
    if let Some(triangle) = field.triangle_at_id(id) {
        f(&triangle);
    }
}

/// The corners of a shape that is flat: a triangle.
pub fn flat_corners(shape: &dyn Shape) -> Option<[Vector; 3]> {
    shape.as_triangle().map(|triangle| [triangle.a, triangle.b, triangle.c])
}
