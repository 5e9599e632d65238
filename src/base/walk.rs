//! From cell to cell along a ray (Amanatides, Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing", 1987).

use parry::math::Real;

/// Rounding error of a place on a wall between cells, as a fraction of the involved lengths.
const ROUNDING: Real = 8.0 * Real::EPSILON;

/// The path of a ray along one axis, from cell to cell.
#[derive(Debug)]
pub struct Walk {
    origin: Real,
    inv_dir: Real,
    /// Length of all cells (length units).
    size: Real,
    /// Number of cells.
    pub count: usize,
    /// The present cell of the ray.
    pub cell: usize,
    /// The time at which the ray leaves the cell (units of its direction).
    pub leaves: Real,
}

impl Walk {
    /// Begins at the cell nearest to the ray's point at time `start`. The middle of all cells is the origin.
    pub fn new(origin: Real, dir: Real, start: Real, size: Real, count: usize) -> Self {
        let fraction = (origin + dir * start) / size + 0.5;
        // Casts cut off at both ends.
        let cell = ((fraction * count as Real) as usize).min(count - 1);
        let inv_dir = if dir == 0.0 { 0.0 } else { 1.0 / dir };
        let mut walk = Self { origin, inv_dir, size, count, cell, leaves: 0.0 };
        walk.leaves = walk.leaving();
        walk
    }

    fn leaving(&self) -> Real {
        if self.inv_dir == 0.0 {
            return Real::INFINITY;
        }
        let wall = self.cell + usize::from(self.inv_dir > 0.0);
        ((wall as Real / self.count as Real - 0.5) * self.size - self.origin) * self.inv_dir
    }

    /// The cell on the other side of a wall, if the ray stays at that wall between two times. `dir` is the
    /// ray's direction along this axis. By rounding, such a ray is in either cell, or in none.
    pub fn beside(&self, dir: Real, times: [Real; 2]) -> Option<usize> {
        let tolerance = ROUNDING * (self.size + self.origin.abs());
        let is_at = |wall: usize| {
            let place = (wall as Real / self.count as Real - 0.5) * self.size;
            times.iter().all(|time| (self.origin + dir * time - place).abs() <= tolerance)
        };
        if is_at(self.cell) {
            return self.cell.checked_sub(1);
        }
        (is_at(self.cell + 1) && self.cell + 1 < self.count).then_some(self.cell + 1)
    }

    /// Moves to the next cell. Returns whether there is one.
    pub fn advance(&mut self) -> bool {
        let next = if self.inv_dir > 0.0 { self.cell + 1 } else { self.cell.wrapping_sub(1) };
        let is_inside = next < self.count;
        if is_inside {
            self.cell = next;
            self.leaves = self.leaving();
        }
        is_inside
    }
}

/// The least and the greatest of some numbers.
pub fn range(numbers: &[Real]) -> [Real; 2] {
    let (mut low, mut high) = (Real::INFINITY, Real::NEG_INFINITY);
    for &number in numbers {
        (low, high) = (low.min(number), high.max(number));
    }
    [low, high]
}
