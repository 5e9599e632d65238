//! Best-first search in a grid of cells.
//!
//! The grid is its own tree: a block of cells is halved along its longest side, down to single cells. No node
//! is stored.

use parry::math::{Int, Real};

/// First cell and the one after the last, for each axis.
pub type Block<const N: usize> = [[Int; 2]; N];

/// Calls `visit` with the cells of a block whose lower bound of the cost is below the limit, cheap halves
/// first.
///
/// `lower` returns a lower bound of the costs in a block; infinity if the block is irrelevant. `visit`
/// receives a cell and the current limit, and returns the new limit.
pub fn search<const N: usize>(
    block: Block<N>,
    limit: &mut Real,
    lower: &dyn Fn(&Block<N>) -> Real,
    visit: &mut dyn FnMut([Int; N], Real) -> Real,
) {
    let length = |axis: usize| block[axis][1].saturating_sub(block[axis][0]);
    let longest = (0..N).max_by_key(|&axis| length(axis)).unwrap_or(0);
    if length(longest) <= 1 {
        if (0..N).all(|axis| length(axis) == 1) {
            *limit = visit(block.map(|[first, _]| first), *limit);
        }
        return;
    }
    let middle = Int::midpoint(block[longest][0], block[longest][1]);
    let (mut first, mut second) = (block, block);
    (first[longest][1], second[longest][0]) = (middle, middle);
    let mut halves = [(lower(&first), first), (lower(&second), second)];
    if halves[1].0 < halves[0].0 {
        halves.swap(0, 1);
    }
    for (cost, half) in halves {
        if cost < *limit {
            search(half, limit, lower, visit);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::random::Random;

    /// Costs of cells are their distances from a point; a block's bound is that of its box.
    #[test]
    fn the_search_finds_the_cell_of_least_cost() {
        let mut random = Random(3);
        let (mut visited, rounds) = (0, 500);
        for _ in 0..rounds {
            let size = [1 + random.below(40) as Int, 1 + random.below(40) as Int];
            let origin = [random.below(9) as Int - 4, random.below(9) as Int - 4];
            let whole = [0, 1].map(|axis| [origin[axis], origin[axis] + size[axis]]);
            let point = [random.within(-9.0, 45.0), random.within(-9.0, 45.0)];
            let lower = |block: &Block<2>| {
                let outside = |axis: usize| {
                    let [first, end] = block[axis].map(|cell| cell as Real);
                    (first - point[axis]).max(point[axis] - (end - 1.0)).max(0.0)
                };
                outside(0).hypot(outside(1))
            };
            let cost = |cell: [Int; 2]| lower(&cell.map(|at| [at, at + 1]));
            let (mut limit, mut found) = (Real::INFINITY, None);
            search(whole, &mut limit, &lower, &mut |cell, limit| {
                visited += 1;
                if cost(cell) < limit {
                    found = Some(cell);
                }
                cost(cell).min(limit)
            });
            let cells = (whole[0][0]..whole[0][1])
                .flat_map(|i| (whole[1][0]..whole[1][1]).map(move |j| [i, j]));
            let least = cells.map(cost).fold(Real::INFINITY, Real::min);
            assert_eq!(found.map(cost), Some(least));
        }
        assert!(visited < 20 * rounds, "{visited} cells visited in {rounds} searches");
    }
}
