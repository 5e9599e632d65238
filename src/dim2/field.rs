//! Rays and height fields.
//!
//! The ray goes from cell to cell, and tests a segment only where it comes down to the heights of its ends.

use super::math::Real;
use crate::base::parry_version::set_subshape;
use crate::base::walk::{Walk, range};
use parry::query::{Ray, RayCast, RayIntersection};
use parry::shape::HeightField;

/// The hit of a ray on a height field, in the field's frame.
pub fn ray_on_field(field: &HeightField, ray: &Ray, limit: Real) -> Option<RayIntersection> {
    let (start, end) = field.local_aabb().clip_ray_parameters(ray)?;
    let (mut start, end) = (start.max(0.0), end.min(limit));
    let scale = field.scale();
    let mut walk = Walk::new(ray.origin.x, ray.dir.x, start, scale.x.abs(), field.num_cells());
    // A scale below zero turns the order of the cells around.
    let oriented =
        |walk: &Walk, cell: usize| if scale.x < 0.0 { walk.count - 1 - cell } else { cell };
    loop {
        let cell = oriented(&walk, walk.cell);
        let times = [start, walk.leaves.min(end)];
        if may_meet(field, cell, ray, times) {
            // A ray along a border may miss the segment on its own side by rounding.
            let beside = walk.beside(ray.dir.x, times).map(|cell| oriented(&walk, cell));
            let hit = ray_on_cell(field, cell, ray, limit);
            if let Some(hit) = hit.or_else(|| ray_on_cell(field, beside?, ray, limit)) {
                return Some(hit);
            }
        }
        start = walk.leaves;
        if start > end || !walk.advance() {
            return None;
        }
    }
}

/// Returns whether the ray can meet the segment of a cell between two times. It cannot if it stays above or
/// below both ends.
fn may_meet(field: &HeightField, cell: usize, ray: &Ray, times: [Real; 2]) -> bool {
    let ends = [cell, cell + 1].map(|at| field.heights()[at] * field.scale().y);
    let [low, high] = range(&ends);
    let [bottom, top] = range(&times.map(|time| ray.origin.y + ray.dir.y * time));
    // The margin covers the rounding of the ray, and of its entry and exit times.
    let size = low.abs().max(high.abs()).max(bottom.abs()).max(top.abs());
    let margin = 16.0 * Real::EPSILON * (size + (ray.dir * times[1]).abs().max_element());
    bottom - margin <= high && low <= top + margin
}

fn ray_on_cell(
    field: &HeightField,
    cell: usize,
    ray: &Ray,
    limit: Real,
) -> Option<RayIntersection> {
    let mut hit = field.segment_at(cell)?.cast_local_ray_and_get_normal(ray, limit, true)?;
    set_subshape(&mut hit, cell as u32);
    Some(hit)
}
