//! Rays and height fields.
//!
//! The ray visits the cells below it in sequence, and tests triangles only where it descends to the heights
//! of the cell's corners.

use super::math::Real;
use crate::base::parry_version::set_subshape;
use crate::base::walk::{Walk, range};
use parry::query::{PointQuery, Ray, RayCast, RayIntersection};
use parry::shape::{FeatureId, HeightField};

/// Largest distance between a triangle and a ray at its border, as a fraction of the involved lengths.
const BORDER: Real = 16.0 * Real::EPSILON;

/// The hit of a ray on a height field, in the field's frame.
pub fn ray_on_field(field: &HeightField, ray: &Ray, limit: Real) -> Option<RayIntersection> {
    let (start, end) = field.local_aabb().clip_ray_parameters(ray)?;
    let (mut start, end) = (start.max(0.0), end.min(limit));
    let size = field.scale().abs();
    let (rows, columns) = field.num_cells_ij();
    let mut walks = [
        Walk::new(ray.origin.x, ray.dir.x, start, size.x, columns),
        Walk::new(ray.origin.z, ray.dir.z, start, size.z, rows),
    ];
    // A scale below zero turns the order of the cells around.
    let oriented = |walk: &Walk, cell: usize, scale: Real| {
        if scale < 0.0 { walk.count - 1 - cell } else { cell }
    };
    let row = |walks: &[Walk; 2], cell| oriented(&walks[1], cell, field.scale().z);
    let column = |walks: &[Walk; 2], cell| oriented(&walks[0], cell, field.scale().x);
    loop {
        let (i, j) = (row(&walks, walks[1].cell), column(&walks, walks[0].cell));
        let next = walks[0].leaves.min(walks[1].leaves);
        let times = [start, next.min(end)];
        if may_meet(field, (i, j), ray, times) {
            let here = ray_on_cell(field, (i, j), ray, limit);
            let i2 = walks[1].beside(ray.dir.z, times).map_or(i, |cell| row(&walks, cell));
            let j2 = walks[0].beside(ray.dir.x, times).map_or(j, |cell| column(&walks, cell));
            if let Some(hit) = here.or_else(|| ray_at_border(field, [i, i2], [j, j2], ray, limit)) {
                return Some(hit);
            }
        }
        let first = usize::from(walks[1].leaves < walks[0].leaves);
        if next > end || !walks[first].advance() {
            return None;
        }
        start = next;
    }
}

/// Returns whether the ray can meet a triangle of the cell between two times. It cannot if it stays above or
/// below all corners.
fn may_meet(field: &HeightField, (i, j): (usize, usize), ray: &Ray, times: [Real; 2]) -> bool {
    let heights = field.heights();
    let corners = [(i, j), (i + 1, j), (i, j + 1), (i + 1, j + 1)];
    let corners = corners.map(|at| heights[at] * field.scale().y);
    let ends = times.map(|time| ray.origin.y + ray.dir.y * time);
    let [low, high] = range(&corners);
    let [bottom, top] = range(&ends);
    // The margin covers the rounding of the ray, and of its entry and exit times.
    let size = low.abs().max(high.abs()).max(bottom.abs()).max(top.abs());
    let margin = 16.0 * Real::EPSILON * (size + (ray.dir * times[1]).abs().max_element());
    bottom - margin <= high && low <= top + margin
}

/// The hit of a ray that stays at a border between cells, in these rows and columns. By rounding, such a ray
/// may pass between the triangles on both sides: the nearest one that the ray misses by less is hit.
fn ray_at_border(
    field: &HeightField,
    rows: [usize; 2],
    columns: [usize; 2],
    ray: &Ray,
    limit: Real,
) -> Option<RayIntersection> {
    if rows[0] == rows[1] && columns[0] == columns[1] {
        return None;
    }
    let tolerance = BORDER * (field.scale().abs().max_element() + ray.origin.abs().max_element());
    let cells = rows.into_iter().flat_map(|i| columns.map(|j| (i, j)));
    let hits = cells.flat_map(|(i, j)| {
        let (left, right) = field.triangles_at(i, j);
        [(left, true), (right, false)].into_iter().filter_map(move |(triangle, is_left)| {
            let triangle = triangle?;
            let normal = triangle.normal()?;
            let time = (triangle.a - ray.origin).dot(normal) / ray.dir.dot(normal);
            let point = ray.point_at(time);
            let miss = triangle.project_local_point(point, true).point - point;
            if !(0.0..=limit).contains(&time) || miss.length() > tolerance {
                return None;
            }
            let normal = if ray.dir.dot(normal) > 0.0 { -normal } else { normal };
            let mut hit = RayIntersection::new(time, normal, FeatureId::Face(0));
            set_subshape(&mut hit, subshape(field, (i, j), is_left));
            Some(hit)
        })
    });
    hits.min_by(|a, b| a.time_of_impact.total_cmp(&b.time_of_impact))
}

/// The index of a triangle. Left triangles are numbered first, column by column.
fn subshape(field: &HeightField, (i, j): (usize, usize), is_left: bool) -> u32 {
    let (rows, columns) = field.num_cells_ij();
    let first = if is_left { 0 } else { rows * columns };
    (first + j * rows + i) as u32
}

fn ray_on_cell(
    field: &HeightField,
    (i, j): (usize, usize),
    ray: &Ray,
    limit: Real,
) -> Option<RayIntersection> {
    let (left, right) = field.triangles_at(i, j);
    let hit = |triangle: Option<parry::shape::Triangle>, is_left| {
        let mut hit = triangle?.cast_local_ray_and_get_normal(ray, limit, true)?;
        set_subshape(&mut hit, subshape(field, (i, j), is_left));
        Some(hit)
    };
    match (hit(left, true), hit(right, false)) {
        (Some(left), Some(right)) => {
            Some(if left.time_of_impact < right.time_of_impact { left } else { right })
        }
        (left, right) => left.or(right),
    }
}

#[cfg(test)]
mod tests {
    use super::ray_on_field;
    use crate::base::random::Random;
    use crate::dim::math::{Real, Vector};
    use parry::query::{Ray, RayCast};
    use parry::shape::HeightField;
    use parry::utils::Array2;

    /// Rays down at the borders between cells, and within rounding of them, pass no field.
    #[test]
    fn no_ray_passes_between_two_cells() {
        let mut random = Random(5);
        for cells in [3, 7, 40, 400] {
            let heights = Array2::new(cells + 1, cells + 1, vec![0.25; (cells + 1) * (cells + 1)]);
            let field = HeightField::new(heights, Vector::new(16.0, 1.0, 5.0));
            for round in 0..2000 {
                let mut place = |size: Real, is_border: bool| {
                    let border = random.within(1.0, cells as f64).floor();
                    let by_rounding = random.within(-4.0, 4.0).round() * Real::EPSILON;
                    let beside = if is_border { 0.0 } else { random.within(0.0, 0.9) };
                    ((border + beside) / cells as Real - 0.5) * size * (1.0 + by_rounding)
                        + by_rounding
                };
                let x = place(16.0, round % 3 != 0);
                let origin = Vector::new(x, 1.0, place(5.0, round % 3 != 1));
                let hit = ray_on_field(&field, &Ray::new(origin, -Vector::Y), 2.0);
                let time = hit.map(|hit| hit.time_of_impact);
                assert!(
                    time.is_some_and(|time| (time - 0.75).abs() < 1.0e-5),
                    "{cells} cells at {origin}: {time:?}"
                );
            }
        }
    }

    /// All triangles in turn find nothing nearer, and nothing where the walk finds nothing. Along borders
    /// between triangles either of two answers is right, so times are compared, to the rounding of
    /// coordinates up to 30.
    #[test]
    fn a_walk_finds_the_same_as_a_test_of_all_triangles() {
        let mut random = Random(4);
        let (mut hits, mut tried) = (0, 0);
        for scale in [Vector::new(20.0, 2.0, 12.0), Vector::new(3.0, 30.0, 40.0)] {
            let heights: Vec<_> = (0..9 * 14).map(|_| random.within(-1.0, 1.0)).collect();
            let field = HeightField::new(Array2::new(9, 14, heights), scale);
            let triangles: Vec<_> = field.triangles().collect();
            for round in 0..4000 {
                let mut point = |size: Real| {
                    let mut point = Vector::ZERO;
                    (0..3).for_each(|axis| {
                        point[axis] = random.within(-1.0, 1.0) * size * scale[axis]
                    });
                    point
                };
                let (origin, target) = (point(1.0), point(0.5));
                let mut ray = Ray::new(origin, target - origin);
                if round % 5 == 0 {
                    ray.dir[round % 3] = 0.0;
                }
                let limit = random.within(0.0, 3.0);
                let found = ray_on_field(&field, &ray, limit).map(|hit| hit.time_of_impact);
                let all = triangles
                    .iter()
                    .filter_map(|triangle| triangle.cast_local_ray(&ray, limit, true));
                let nearest = all.min_by(Real::total_cmp);
                tried += 1;
                hits += usize::from(found.is_some());
                let tolerance = 1.0e3 * Real::EPSILON;
                let is_same = match (found, nearest) {
                    (Some(found), Some(nearest)) => (found - nearest).abs() <= tolerance,
                    (None, None) => true,
                    _ => false,
                };
                assert!(is_same, "{found:?} but {nearest:?}: {ray:?} up to {limit}");
            }
        }
        assert!(hits > tried / 5 && hits < tried - tried / 20, "{hits} of {tried}");
    }
}
