//! Culling of contacts where two shapes touch in thousands of places.
//!
//! A body as large as the terrain that it lies on touches every triangle of it. Internal edges are found by
//! comparing contacts with each other, in quadratic time: 74 s for 500,000 triangles. A grid of cubic cells
//! over the region of contact bounds the number: a cell keeps the deepest items. Depth decides because the
//! deepest contacts carry the body; the grid spreads the items, so that the body keeps its support from side
//! to side.
//!
//! The selection depends on the items alone and not on their order. An item replaces a less deep one, and of
//! equals the one with the lower part numbers stays.

use super::pair::ShapePair;
use crate::base::measure::SHAPE_MAX;
use crate::dim::math::{DIM, Real, Vector};
use core::cmp::Ordering;
use parry::bounding_volume::{Aabb, BoundingVolume};

/// Number of cells.
pub(super) const CELLS_MAX: usize = 256;
/// Regions longer than this (length units) have one cell: half-spaces have no end.
const EXTENT_MAX: Real = 2.0 * SHAPE_MAX;

/// The order in which a cell prefers its items: the deepest first.
#[derive(Copy, Clone, Debug, PartialEq)]
pub(super) struct Rank {
    /// Distance of the two parts, negative where they overlap.
    pub dist: Real,
    /// Numbers of the two parts.
    pub parts: [u32; 2],
}

impl Rank {
    pub fn cmp(&self, other: &Self) -> Ordering {
        self.dist.total_cmp(&other.dist).then(self.parts.cmp(&other.parts))
    }

    pub fn is_before(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Less
    }
}

/// Cubic cells over a region, at most [`CELLS_MAX`].
#[derive(Copy, Clone, Debug, Default)]
pub(super) struct Grid {
    origin: Vector,
    /// One over the edge of a cell.
    inv_edge: Real,
    /// Cells along each axis.
    counts: [usize; DIM],
}

impl Grid {
    /// The largest number of cells over a region. A flat region has them side by side: 16 × 16 × 1.
    pub fn over(region: &Aabb) -> Self {
        let (origin, extents) = (region.mins, region.extents());
        let longest = extents.max_element();
        let one = Self { origin: Vector::ZERO, inv_edge: 0.0, counts: [1; DIM] };
        // Written so that NaN has one cell.
        if !(longest > 0.0 && longest < EXTENT_MAX) {
            return one;
        }
        let with_cells = |along_longest: usize| {
            let inv_edge = along_longest as Real / longest;
            let count = |axis: usize| (extents[axis] * inv_edge).ceil().max(1.0) as usize;
            let counts: [usize; DIM] = core::array::from_fn(count);
            Self { origin, inv_edge, counts }
        };
        let is_small = |grid: &Self| grid.len() <= CELLS_MAX;
        (1..=CELLS_MAX).rev().map(with_cells).find(is_small).unwrap_or(one)
    }

    /// The grid over the region in which two shapes can touch, in the frame of the first.
    pub fn between(pair: &ShapePair<'_>) -> Self {
        let [first, second] = pair.shapes;
        let own = first.compute_local_aabb();
        let other = second.compute_aabb(&pair.pos12).loosened(pair.prediction);
        own.intersection(&other).map_or_else(|| Self::over(&own), |region| Self::over(&region))
    }

    /// Number of cells.
    pub fn len(&self) -> usize {
        self.counts.iter().product()
    }

    /// The cell of a point; outside the region, the nearest one.
    pub fn cell(&self, point: Vector) -> usize {
        let at = (point - self.origin) * self.inv_edge;
        (0..DIM).rev().fold(0, |cell, axis| {
            // The cast saturates, and takes NaN for 0.
            let along = (at[axis].max(0.0) as usize).min(self.counts[axis] - 1);
            cell * self.counts[axis] + along
        })
    }
}

/// The direction, of six (in the plane four), that is nearest to a normal.
pub(super) fn main_direction(normal: Vector) -> usize {
    let sizes = normal.abs();
    let axis = (1..DIM).fold(0, |best, axis| if sizes[axis] > sizes[best] { axis } else { best });
    2 * axis + usize::from(normal[axis] < 0.0)
}

#[cfg(test)]
mod tests {
    use super::{CELLS_MAX, Grid, Rank, main_direction};
    use crate::base::random::Random;
    use crate::dim::collide::samples;
    use crate::dim::math::{DIM, Real, Vector};
    use parry::bounding_volume::Aabb;

    #[test]
    fn cells_are_few_and_all_over_the_region() {
        for extents in [Vector::ONE, Vector::X, Vector::splat(0.3) + Vector::Y * 90.0] {
            let region = Aabb::new(-extents, extents);
            let grid = Grid::over(&region);
            assert!((CELLS_MAX / 2..=CELLS_MAX).contains(&grid.len()), "{grid:?}");
            let mut found = vec![false; grid.len()];
            let mut random = Random(5);
            for _ in 0..200 * CELLS_MAX {
                let point = samples::vector(&mut random, 1.0);
                found[grid.cell(point * extents)] = true;
            }
            let fraction =
                found.iter().filter(|&&found| found).count() as Real / grid.len() as Real;
            assert!(fraction > 0.95, "{fraction} of the cells are used: {grid:?}");
        }
    }

    #[test]
    fn no_point_and_no_region_is_without_a_cell() {
        for size in [0.0, 1.0, 1.0e30, Real::INFINITY, Real::NAN] {
            let grid = Grid::over(&Aabb::new(Vector::splat(-size), Vector::splat(size)));
            for place in [0.0, -2.0, 2.0, Real::MAX, Real::NAN, Real::NEG_INFINITY] {
                assert!(grid.cell(Vector::splat(place)) < grid.len().max(1));
            }
        }
    }

    #[test]
    fn ranks_are_a_total_order() {
        let rank = |dist: Real, first: u32| Rank { dist, parts: [first, 0] };
        assert!(rank(-1.0, 9).is_before(&rank(0.0, 1)));
        assert!(rank(0.0, 1).is_before(&rank(0.0, 2)) && !rank(0.0, 1).is_before(&rank(0.0, 1)));
    }

    #[test]
    fn directions_are_those_of_axes() {
        for (axis, unit) in Vector::AXES.into_iter().enumerate() {
            let lean = Vector::splat(0.1);
            assert_eq!(
                [unit, -unit].map(|unit| main_direction(unit + lean)),
                [2 * axis, 2 * axis + 1]
            );
        }
        assert!(main_direction(Vector::splat(Real::NAN)) < 2 * DIM);
    }
}
