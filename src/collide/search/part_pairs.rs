//! Pairs of parts of two shapes that both have several: mesh against mesh, compound against terrain.
//!
//! The number of pairs of parts that are near each other has no bound but the product of the two numbers of
//! parts. Contacts are computed for a bounded number of pairs: beyond it, a [grid](super::culling) chooses
//! those whose boxes overlap most. Choosing them takes a second walk through the trees, which only crowded
//! pairs of shapes pay for.

use super::Search;
use crate::collide::culling::{CELLS_MAX, Grid, Rank};
use crate::collide::part::Part;
use crate::collide::parts::Near;
use crate::dim::math::{Real, Vector};
use parry::bounding_volume::{Aabb, BoundingVolume};

/// Largest number of pairs of parts with computed contacts.
const PAIRS_VISITED_MAX: usize = 16_384;
/// Largest number of pairs of a cell.
const PAIRS_PER_CELL_MAX: usize = PAIRS_VISITED_MAX / CELLS_MAX;
/// Most pairs from which the visited ones are chosen. Each part of the first shape offers an equal fraction
/// of them, in the order of the second shape's tree.
const CANDIDATES_MAX: usize = 1 << 21;
/// Products of numbers of parts up to this are not counted first.
const PRODUCT_MAX: usize = PAIRS_VISITED_MAX;

/// The pairs of one cell: the best ones, and some more until these are dropped.
#[derive(Clone, Default)]
struct Cell(Vec<Rank>);

impl Cell {
    fn add(&mut self, rank: Rank) {
        self.0.push(rank);
        if self.0.len() >= 2 * PAIRS_PER_CELL_MAX {
            self.drop_surplus();
        }
    }

    fn drop_surplus(&mut self) {
        if self.0.len() > PAIRS_PER_CELL_MAX {
            self.0.select_nth_unstable_by(PAIRS_PER_CELL_MAX, Rank::cmp);
            self.0.truncate(PAIRS_PER_CELL_MAX);
        }
    }
}

impl Search<'_> {
    /// Visits the pairs of near parts, up to the maximum.
    pub(super) fn visit_parts_of_both(&mut self) {
        let counts = self.parts.map(|parts| parts.len());
        let product = counts[0].saturating_mul(counts[1]);
        let mut pairs = 0;
        let mut near_parts = 0_usize;
        if product > PRODUCT_MAX {
            self.for_each_first_part(&mut |search, part1| {
                near_parts += 1;
                if pairs <= PAIRS_VISITED_MAX {
                    search.for_each_second_part(&part1, &mut |_, _| pairs += 1);
                }
            });
        }
        if pairs <= PAIRS_VISITED_MAX {
            self.visit_pairs(|_| true);
            return;
        }
        *self.are_parts_culled = true;
        let chosen = self.choose_pairs(CANDIDATES_MAX / near_parts.max(1) + 1);
        self.visit_pairs(|ids| chosen.binary_search(&ids).is_ok());
    }

    fn visit_pairs(&mut self, is_selected: impl Fn([u32; 2]) -> bool) {
        let ([parts1, parts2], pos21) = (self.parts, self.pair.pos12.inverse());
        let prediction = self.pair.prediction;
        let near1 = Near::of(parts2.shape(), &self.pair.pos12, prediction);
        parts1.for_each_part(&near1, &mut |part1| {
            let near2 = Near::of(part1.shape, &(pos21 * part1.pose()), prediction);
            parts2.for_each_part(&near2, &mut |part2| {
                if is_selected([part1.id, part2.id]) {
                    self.search(part1, part2);
                }
            });
        });
    }

    /// Chooses the pairs that are visited, in ascending order.
    fn choose_pairs(&self, quota: usize) -> Vec<[u32; 2]> {
        let grid = Grid::over(&self.region_of_second());
        let mut cells = vec![Cell::default(); grid.len()];
        self.for_each_first_part(&mut |search, part1| {
            let mut offered = 0;
            search.for_each_second_part(&part1, &mut |around1, part2| {
                offered += 1;
                if offered <= quota {
                    let around2 = box_of(&part2);
                    let (dist, middle) = overlap(around1, &around2);
                    let rank = Rank { dist, parts: [part1.id, part2.id] };
                    cells[grid.cell(middle)].add(rank);
                }
            });
        });
        cells.iter_mut().for_each(Cell::drop_surplus);
        let mut chosen: Vec<_> =
            cells.iter().flat_map(|cell| &cell.0).map(|rank| rank.parts).collect();
        chosen.sort_unstable();
        chosen
    }

    /// The region in which the second shape can touch the first, in the frame of the second.
    fn region_of_second(&self) -> Aabb {
        let [shape1, shape2] = self.pair.shapes;
        let own = shape2.compute_local_aabb();
        let other = shape1.compute_aabb(&self.pair.pos12.inverse());
        own.intersection(&other.loosened(self.pair.prediction)).unwrap_or(own)
    }

    fn for_each_first_part(&self, f: &mut dyn FnMut(&Self, Part<'_>)) {
        let near = Near::of(self.parts[1].shape(), &self.pair.pos12, self.pair.prediction);
        self.parts[0].for_each_part(&near, &mut |part1| f(self, part1));
    }

    /// Calls `f` with the box of a part of the first shape, and with each part of the second that may reach
    /// into it. All in the frame of the second.
    fn for_each_second_part(&self, part1: &Part<'_>, f: &mut dyn FnMut(&Aabb, Part<'_>)) {
        let pose = self.pair.pos12.inverse() * part1.pose();
        let near = Near::of(part1.shape, &pose, self.pair.prediction);
        let around = near.bounds().unwrap_or_else(|| self.region_of_second());
        self.parts[1].for_each_part(&near, &mut |part2| f(&around, part2));
    }
}

fn box_of(part: &Part<'_>) -> Aabb {
    part.pose.map_or_else(|| part.shape.compute_local_aabb(), |pose| part.shape.compute_aabb(pose))
}

/// Distance of two boxes (negative where they overlap), and the middle of their common region.
fn overlap(a: &Aabb, b: &Aabb) -> (Real, Vector) {
    let (mins, maxs) = (a.mins.max(b.mins), a.maxs.min(b.maxs));
    (-(maxs - mins).min_element(), mins.midpoint(maxs))
}
