//! The matrix of one component: put together, factorised, solved.
//!
//! Numbers are of double precision whatever the engine's are: a chain of light links under a weight a
//! thousand times as heavy loses three digits here, and single precision has seven.

use super::memory::RowMemory;
use super::pattern::{Component, Member};
use crate::base::disjoint::DisjointMut;
use crate::base::wide::Lane;
use crate::dim::math::{Real, SPATIAL_DIM};
use crate::dim::state::BodyState;

/// A pivot below this share of what stood there before elimination is rounding: other rows hold what this one
/// would. A row that differs from the others by the rounding of its numbers alone has a pivot of the square of that.
const PIVOT_MIN: f64 = 64.0 * (Real::EPSILON as f64) * (Real::EPSILON as f64) + 16.0 * f64::EPSILON;

/// By what share of itself each diagonal element is enlarged (Levenberg and Marquardt's damping). Without it, long
/// chains under 10⁵ times the mass of a link answer to the rounding of velocities with impulses that throw their links
/// about. It slows the correction of errors down, and adds none: at rest, nothing is left to correct.
const DAMPING: f64 = 2.0 * Real::EPSILON as f64;

/// One row of `J` or of `M⁻¹ Jᵀ`, for both bodies.
type BodyRow = [[f64; SPATIAL_DIM]; 2];

/// The matrix of a component, and the buffers to solve it.
#[derive(Default)]
pub(super) struct Factor {
    /// By member: its first row, and one more at the end.
    first_row: Vec<usize>,
    rows: Vec<BodyRow>,
    responses: Vec<BodyRow>,
    /// By member: its diagonal block (row by row), then `L` with the inverse pivots on the diagonal.
    diagonal: Vec<f64>,
    first_diagonal: Vec<usize>,
    /// By row: `J M⁻¹ Jᵀ` of the row itself.
    diagonals: Vec<f64>,
    /// By column, the blocks below the diagonal.
    below: Vec<f64>,
    /// By column: where each of its blocks begins in `below`.
    first_below: Vec<Vec<usize>>,
    /// Right-hand side, then solution.
    x: Vec<f64>,
    /// The sum of the yields with which the matrix was made; `None` if the bodies are elsewhere by now.
    made_with: Option<f64>,
}

impl Factor {
    /// Solves a component for the changes of its impulses, and gives its bodies what these do.
    ///
    /// # Safety
    /// Nobody else may touch the states of the component's movable bodies meanwhile.
    pub unsafe fn solve(
        &mut self,
        component: Component<'_>,
        memory: &[RowMemory],
        states: &DisjointMut<'_, BodyState>,
    ) {
        let yields = component.members.iter().map(|member| yields_of(member, memory)).sum();
        if self.made_with != Some(yields) {
            self.load(component, memory);
            self.assemble(component, memory);
            self.eliminate(component);
            self.made_with = Some(yields);
        }
        self.load_rates(component, memory);
        self.substitute(component);
        // SAFETY: the caller's promise.
        unsafe { self.push_bodies(component, states) };
    }

    /// The bodies have moved: the matrix must be made anew.
    pub fn forget(&mut self) {
        self.made_with = None;
    }

    /// Reads the rows, and lays out the blocks.
    fn load(&mut self, component: Component<'_>, memory: &[RowMemory]) {
        self.first_row.clear();
        self.rows.clear();
        self.responses.clear();
        for member in component.members {
            self.first_row.push(self.rows.len());
            let from = &memory[member.block as usize];
            let lane = member.lane as usize;
            for axis in locked_axes(member) {
                let row = body_row(&from.rows[axis], lane);
                let [first, second] = &member.inverse_masses;
                self.responses.push([first.response(&row[0]), second.response(&row[1])]);
                self.rows.push(row);
            }
        }
        self.first_row.push(self.rows.len());
        self.lay_out(component);
    }

    /// Reads the right-hand side.
    fn load_rates(&mut self, component: Component<'_>, memory: &[RowMemory]) {
        self.x.clear();
        for member in component.members {
            let from = &memory[member.block as usize];
            let lane = member.lane as usize;
            let yields = yields_of(member, memory);
            for axis in locked_axes(member) {
                let soft = yields * self.diagonals[self.x.len()];
                let impulse = f64::from(from.impulses[axis].0[lane]);
                self.x.push(-f64::from(from.rates[axis].0[lane]) - soft * impulse);
            }
        }
    }

    fn lay_out(&mut self, component: Component<'_>) {
        let (mut diagonal, mut below) = (0, 0);
        self.first_diagonal.clear();
        self.first_below.resize_with(component.members.len(), Vec::new);
        for (at, column) in component.columns.iter().enumerate() {
            let size = component.members[at].row_count();
            self.first_diagonal.push(diagonal);
            diagonal += size * size;
            self.first_below[at].clear();
            for &row in column {
                self.first_below[at].push(below);
                below += size * component.members[row as usize].row_count();
            }
        }
        self.diagonal.clear();
        self.diagonal.resize(diagonal, 0.0);
        self.below.clear();
        self.below.resize(below, 0.0);
    }

    /// Fills the blocks: `J_j M⁻¹ J_iᵀ` over the bodies that two joints share.
    fn assemble(&mut self, component: Component<'_>, memory: &[RowMemory]) {
        self.diagonals.clear();
        for (at, member) in component.members.iter().enumerate() {
            let size = member.row_count();
            let start = self.first_diagonal[at];
            self.add_block(member, member, [at, at], start, true);
            for (index, &row) in component.columns[at].iter().enumerate() {
                let other = &component.members[row as usize];
                let start = self.first_below[at][index];
                self.add_block(other, member, [row as usize, at], start, false);
            }
            let yields = yields_of(member, memory);
            for k in 0..size {
                let pivot = &mut self.diagonal[start + k * size + k];
                self.diagonals.push(*pivot);
                *pivot += (yields + DAMPING) * *pivot;
            }
        }
    }

    fn add_block(
        &mut self,
        of_row: &Member,
        of_column: &Member,
        [row, column]: [usize; 2],
        start: usize,
        on_diagonal: bool,
    ) {
        let (rows, columns) = (of_row.row_count(), of_column.row_count());
        let target =
            if on_diagonal { &mut self.diagonal[start..] } else { &mut self.below[start..] };
        for (side, body) in of_row.movable() {
            for (other_side, _) in of_column.movable().filter(|(_, other)| *other == body) {
                for r in 0..rows {
                    let j = &self.rows[self.first_row[row] + r][side];
                    for c in 0..columns {
                        let response = &self.responses[self.first_row[column] + c][other_side];
                        target[r * columns + c] += dot(j, response);
                    }
                }
            }
        }
    }

    /// `L D Lᵀ`, column by column: each one takes its part off those that follow.
    fn eliminate(&mut self, component: Component<'_>) {
        for (at, column) in component.columns.iter().enumerate() {
            let size = component.members[at].row_count();
            let start = self.first_diagonal[at];
            self.factorise_diagonal(at, size);
            for (index, &row) in column.iter().enumerate() {
                let rows = component.members[row as usize].row_count();
                let block = &mut self.below[self.first_below[at][index]..][..rows * size];
                divide_right(block, &self.diagonal[start..], size);
            }
            for first in 0..column.len() {
                for second in 0..=first {
                    self.update(component, at, first, second);
                }
            }
        }
    }

    /// Factorises a diagonal block in place; the diagonal gets the inverse pivots.
    fn factorise_diagonal(&mut self, at: usize, size: usize) {
        let rows = self.first_row[at]..self.first_row[at + 1];
        let d = &mut self.diagonal[self.first_diagonal[at]..][..size * size];
        for j in 0..size {
            let original = self.diagonals[rows.start + j];
            let mut pivot = d[j * size + j];
            for m in 0..j {
                // The inverse pivots stand on the diagonal, and `L` times its pivot above it.
                pivot -= d[j * size + m] * d[m * size + j];
            }
            let inverse = if pivot > PIVOT_MIN * original { 1.0 / pivot } else { 0.0 };
            d[j * size + j] = inverse;
            for i in j + 1..size {
                let mut sum = d[i * size + j];
                for m in 0..j {
                    sum -= d[i * size + m] * d[m * size + j];
                }
                d[j * size + i] = sum;
                d[i * size + j] = sum * inverse;
            }
        }
    }

    /// Takes what the elimination of the column `at` does off the block of two of its rows.
    fn update(&mut self, component: Component<'_>, at: usize, first: usize, second: usize) {
        let column = &component.columns[at];
        let (row, other) = (column[first] as usize, column[second] as usize);
        let size = component.members[at].row_count();
        let rows = component.members[row].row_count();
        let columns = component.members[other].row_count();
        let (a, b) = (self.first_below[at][first], self.first_below[at][second]);
        let inverses = self.first_diagonal[at];
        let target = if row == other {
            None
        } else {
            let index = component.columns[other].binary_search(&(row as u32));
            Some(index.expect("the pattern has a block wherever elimination puts one"))
        };
        for r in 0..rows {
            for c in 0..columns {
                let mut sum = 0.0;
                for m in 0..size {
                    let inverse = self.diagonal[inverses + m * size + m];
                    sum += self.below[a + r * size + m] * inverse * self.below[b + c * size + m];
                }
                match target {
                    None => self.diagonal[self.first_diagonal[row] + r * rows + c] -= sum,
                    Some(index) => {
                        self.below[self.first_below[other][index] + r * columns + c] -= sum;
                    }
                }
            }
        }
    }

    /// Forwards through `L`, divided by `D`, and back through `Lᵀ`.
    fn substitute(&mut self, component: Component<'_>) {
        for (at, column) in component.columns.iter().enumerate() {
            let (start, size) = (self.first_row[at], component.members[at].row_count());
            let d = &self.diagonal[self.first_diagonal[at]..][..size * size];
            for i in 0..size {
                for m in 0..i {
                    self.x[start + i] -= d[i * size + m] * self.x[start + m];
                }
            }
            for (index, &row) in column.iter().enumerate() {
                let block = &self.below[self.first_below[at][index]..];
                let target = self.first_row[row as usize];
                for r in 0..component.members[row as usize].row_count() {
                    for m in 0..size {
                        let part = block[r * size + m] * d[m * size + m] * self.x[start + m];
                        self.x[target + r] -= part;
                    }
                }
            }
        }
        for (at, column) in component.columns.iter().enumerate().rev() {
            let (start, size) = (self.first_row[at], component.members[at].row_count());
            for (index, &row) in column.iter().enumerate() {
                let block = &self.below[self.first_below[at][index]..];
                let source = self.first_row[row as usize];
                for r in 0..component.members[row as usize].row_count() {
                    for m in 0..size {
                        self.x[start + m] -= block[r * size + m] * self.x[source + r];
                    }
                }
            }
            let d = &self.diagonal[self.first_diagonal[at]..][..size * size];
            for i in (0..size).rev() {
                self.x[start + i] *= d[i * size + i];
                for m in i + 1..size {
                    self.x[start + i] -= d[m * size + i] * self.x[start + m];
                }
            }
        }
    }

    /// Gives the bodies what the changes do to them.
    ///
    /// # Safety
    /// Nobody else may touch the states of the component's movable bodies meanwhile.
    unsafe fn push_bodies(&self, component: Component<'_>, states: &DisjointMut<'_, BodyState>) {
        for (at, member) in component.members.iter().enumerate() {
            for (side, body) in member.movable() {
                let mut change = [0.0; SPATIAL_DIM];
                for row in self.first_row[at]..self.first_row[at + 1] {
                    for (change, response) in change.iter_mut().zip(&self.responses[row][side]) {
                        *change += response * self.x[row];
                    }
                }
                // SAFETY: the caller's promise.
                let state = unsafe { states.get_mut(body as usize) };
                state.add_velocity(change.map(|value| value as Real));
            }
        }
    }

    /// Writes the changes of the impulses to the rows.
    pub fn write_changes(&self, component: Component<'_>, memory: &mut [RowMemory]) {
        for (at, member) in component.members.iter().enumerate() {
            let to = &mut memory[member.block as usize];
            for (k, axis) in locked_axes(member).enumerate() {
                let change = self.x[self.first_row[at] + k] as Real;
                to.changes[axis].0[member.lane as usize] = change;
            }
        }
    }
}

/// `block ← block L⁻ᵀ` for a diagonal block that is factorised.
fn divide_right(block: &mut [f64], d: &[f64], size: usize) {
    for row in block.chunks_exact_mut(size) {
        for j in 0..size {
            for m in 0..j {
                row[j] -= row[m] * d[j * size + m];
            }
        }
    }
}

fn yields_of(member: &Member, memory: &[RowMemory]) -> f64 {
    f64::from(memory[member.block as usize].yields.0[member.lane as usize])
}

fn locked_axes(member: &Member) -> impl Iterator<Item = usize> + use<> {
    let locked = member.locked;
    (0..SPATIAL_DIM).filter(move |axis| locked >> axis & 1 == 1)
}

fn body_row(from: &[[Lane; SPATIAL_DIM]; 2], lane: usize) -> BodyRow {
    from.each_ref().map(|side| side.each_ref().map(|lanes| f64::from(lanes.0[lane])))
}

fn dot(a: &[f64; SPATIAL_DIM], b: &[f64; SPATIAL_DIM]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
