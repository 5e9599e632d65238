//! The cells of a height field.

use parry::bounding_volume::Aabb;
use parry::query::details::NormalConstraints;
use parry::shape::{HeightField, Shape};

/// Calls `f` with the number, shape and normal constraints of each segment near `region`.
pub fn for_each_cell(
    field: &HeightField,
    region: &Aabb,
    f: &mut dyn FnMut(u32, &dyn Shape, Option<&dyn NormalConstraints>),
) {
    field.map_elements_in_local_aabb(region, &mut |id, segment| f(id, segment, None));
}
