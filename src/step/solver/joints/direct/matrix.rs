//! The matrix of one component: assembly, factorisation, solution.
//!
//! Numbers have double precision, independent of the engine's. A chain of light links under a weight of a
//! thousand times their mass loses three digits here, and single precision has seven.
//!
//! Blocks have the size of joints that lock all axes or, if no joint of the component locks a rotation, of
//! translations alone. That halves the time for chains of ropes and balls. Rows of joints that lock fewer
//! axes come first.
//!
//! ## Redundant constraints
//! Three hinges of a door are redundant. Some impulses `n` have no effect on the bodies, `A n = 0` with `A =
//! J M⁻¹ Jᵀ`. `A λ = b` leaves their fraction in `λ` open. The result is rounding divided by almost zero:
//! hinges that strain against each other with a thousand times their load. Only components with loops can
//! have redundant constraints. For these, the solver selects the smallest of all valid impulses. They
//! minimise `λᵀ D λ`, where `D` contains the inverse masses of each row without its moment arms. Equal joints
//! then carry equal loads, independent of their position.
//!
//! With a small damping `δ` (Tikhonov's) the equations have one solution, and the factors of the damped
//! matrix are those that solve it. A second solution with the same factors removes the first one's component
//! along the null space:
//!
//! ```text
//! (A + δ D) y = b        (A + δ D) Δλ = b - δ D (λ + y)
//! ```
//!
//! Along an eigenvector of `D⁻¹ A` with the eigenvalue `a` this is `Δλ = (a b/(a + δ) - δ λ)/(a + δ)`. For `a
//! = 0` nothing is left of `b`, and `λ`, which has been along other eigenvectors before the bodies turned,
//! goes away. For `a ≫ δ` it is `b/a`: well-determined rows have an error of `δ D λ` in velocity, which is
//! rounding. (The first solution alone leaves `b/δ` for `a = 0`. With `δ` large enough to make that small,
//! bridges sag.) The idea is the reverse of the proximal method (Rockafellar, "Monotone operators and the
//! proximal point algorithm", 1976). Its steps lead from the last impulses to the solution. The steps here
//! lead from the solution to zero.

use super::dense::{Block, Column, add, divide_right, dot, factorise, zero};
use super::jacobians::{Rows, compliance_of, couple, locked_axes};
use super::memory::JacobianBlock;
use super::pattern::{Component, DirectJoint};
use crate::base::disjoint::DisjointMut;
use crate::base::wide::{Kernel, Simd, Wide};
use crate::dim::math::{DIM, Real};
use crate::dim::state::BodyState;

/// Relative increase of each diagonal element (Levenberg and Marquardt's damping). Without it, long chains
/// under 10⁵ times the mass of a link answer to the rounding of velocities with impulses that throw their
/// links about. It slows the correction of errors down, and adds none: at rest, nothing is left to correct.
const DAMPING: f64 = 2.0 * Real::EPSILON as f64;

/// The damping `δ` of components with loops. It is above the rounding error of rows (squared) and of the
/// factorisation, and below the values of heavy weights on light chains.
const LOOP_DAMPING: f64 = 8.0 * Real::EPSILON as f64 + 1.0e-8;
/// The least element of `D` as a fraction of the row's own diagonal, for bodies that rotate without
/// translation or are far away.
const FRACTION_MIN: f64 = 1.0e-3;

/// Convergence of stiff joints: the norm of their velocity errors, an energy, as a fraction of the first
/// round's. Convergence is quadratic: a machine of light bars goes from 1 to 10⁻⁴ and to 10⁻⁹. For a chain at
/// rest, 10⁻⁵ is rounding.
const STIFF_RESIDUAL_FRACTION_MAX: f64 = 1.0e-4;

/// Convergence of other joints: the residual as a fraction of the total effect of their impulses (both
/// energies).
const CONVERGED_FRACTION_MAX: f64 = 1.0e-9;
/// Rounding error of anchor positions, relative to the moment arms.
const ANCHOR_ROUNDING: f64 = 4.0 * Real::EPSILON as f64;
/// With a larger residual fraction, the joints are not converged.
const RESIDUAL_FRACTION_MAX: f64 = 1.0e-3;
/// The rounds diverge if the residual exceeds the total effect of the impulses, and the last residual by this
/// factor.
const RESIDUAL_GROWTH_MAX: f64 = 100.0;

/// Progress of the rounds of a solution.
#[derive(Copy, Clone, Debug, PartialEq)]
pub(super) enum Progress {
    Done,
    /// Sufficient; another round would reduce the error.
    Near,
    /// Another round is required.
    Far,
    /// The rounds diverge.
    Diverging,
}

/// The matrix of a component, and the buffers of its solution, with `N` rows per joint.
#[derive(Default)]
pub(super) struct Matrix<const N: usize> {
    /// By direct joint.
    rows: Vec<Rows<N>>,
    /// By direct joint: its diagonal block; factorised, `L` below the diagonal.
    diagonal: Vec<Block<N>>,
    /// By direct joint: the inverse pivots.
    inverses: Vec<Column<N>>,
    /// By direct joint: the diagonal of `J M⁻¹ Jᵀ`.
    own: Vec<Column<N>>,
    /// The blocks below the diagonal, those of one column together; factorised, they are `L D`.
    below: Vec<Block<N>>,
    /// By direct joint: where the blocks of its column begin.
    first_below: Vec<usize>,
    /// By direct joint: `δ D` of components with loops.
    damping: Vec<Column<N>>,
    /// By direct joint: right-hand side, then solution.
    x: Vec<Column<N>>,
    /// By direct joint: right-hand side of the second solution.
    again: Vec<Column<N>>,
    /// Input of the first solution of a substep, of the one before the last, and of the last one.
    first_size: f64,
    sizes: [f64; 2],
    /// The sum of the compliances with which the matrix was made; `None` if the bodies have moved since.
    made_with: Option<f64>,
}

impl<const N: usize> Matrix<N> {
    /// The number of active rows of a joint. In blocks for translations alone, all rows are active: rows that
    /// are not locked stay zero, and the number is a compile-time constant.
    #[inline(always)]
    fn row_count(member: &DirectJoint) -> usize {
        if N == DIM { N } else { member.form.row_count() }
    }

    /// Solves a component for the changes of its impulses, and applies them to its bodies. `again`: another
    /// round of this pass.
    ///
    /// # Safety
    /// The caller has exclusive access to the states of the component's movable bodies.
    pub unsafe fn solve(
        &mut self,
        component: Component<'_>,
        again: bool,
        memory: &[JacobianBlock],
        states: &DisjointMut<'_, BodyState>,
        simd: Simd,
    ) {
        simd.run(Solve { matrix: self, component, memory });
        let size = self.size_of_rates(component, memory);
        if !again {
            self.first_size = size;
        }
        self.sizes = [self.sizes[1], size];
        // SAFETY: the caller's promise.
        unsafe { self.push_bodies(component, states) };
    }

    /// Finds the changes of the impulses.
    #[inline(always)]
    fn find_changes(&mut self, component: Component<'_>, memory: &[JacobianBlock]) {
        let compliance = component.members.iter().map(|member| compliance_of(member, memory)).sum();
        if self.made_with != Some(compliance) {
            self.load(component, memory);
            self.assemble(component, memory);
            self.eliminate(component);
            self.made_with = Some(compliance);
        }
        self.load_rates(component, memory);
        if component.has_loops {
            self.again.clone_from(&self.x);
            self.substitute(component);
            self.load_second_rhs(component, memory);
        }
        self.substitute(component);
    }

    /// Returns whether the residual of the last stiff solution is negligible against the first one. Then no
    /// impulses change.
    pub fn has_converged(&mut self, component: Component<'_>, memory: &[JacobianBlock]) -> bool {
        let is_done =
            self.size_of_rates(component, memory) <= STIFF_RESIDUAL_FRACTION_MAX * self.first_size;
        if is_done {
            self.x.fill([0.0; N]);
        }
        is_done
    }

    /// Rolls all impulses of the component back.
    ///
    /// # Safety
    /// As [`Self::solve`].
    pub unsafe fn roll_back(
        &mut self,
        component: Component<'_>,
        memory: &[JacobianBlock],
        states: &DisjointMut<'_, BodyState>,
    ) {
        for (member, x) in component.members.iter().zip(&mut self.x) {
            let (from, lane) = (&memory[member.block as usize], member.lane as usize);
            for (x, axis) in x.iter_mut().zip(locked_axes::<N>(member)) {
                *x = -f64::from(from.impulses[axis].0[lane]);
            }
        }
        // SAFETY: the caller's promise.
        unsafe { self.push_bodies(component, states) };
    }

    /// The progress of the rounds, after at least two. The ratio of its residual to its input equals the
    /// ratio of that input to the previous one.
    pub fn progress(
        &self,
        component: Component<'_>,
        memory: &[JacobianBlock],
        inv_h: Real,
    ) -> Progress {
        let [before, last] = self.sizes;
        let rest = if last < before { last * (last / before) } else { last };
        let (load, noise) = self.size_of_load(component, memory, f64::from(inv_h));
        if rest <= CONVERGED_FRACTION_MAX * load + noise {
            Progress::Done
        } else if last > load && last > RESIDUAL_GROWTH_MAX * before {
            Progress::Diverging
        } else if rest > RESIDUAL_FRACTION_MAX * load {
            Progress::Far
        } else {
            Progress::Near
        }
    }

    /// As [`Self::size_of_rates`], for the total effect of the impulses and for the rounding errors of rates.
    fn size_of_load(
        &self,
        component: Component<'_>,
        memory: &[JacobianBlock],
        inv_h: f64,
    ) -> (f64, f64) {
        let (mut load, mut noise) = (0.0, 0.0);
        for ((member, own), rows) in component.members.iter().zip(&self.own).zip(&self.rows) {
            let (from, lane) = (&memory[member.block as usize], member.lane as usize);
            for (row, axis) in
                locked_axes::<N>(member).enumerate().filter(|(row, _)| own[*row] > 0.0)
            {
                let impulse = from.impulses[axis].0[lane] + from.changes[axis].0[lane];
                load += own[row] * f64::from(impulse) * f64::from(impulse);
                let rounding = ANCHOR_ROUNDING * rows.size_of(row) * inv_h;
                noise += rounding * rounding / own[row];
            }
        }
        (load, noise)
    }

    /// The sum of `b²/a` over all rows, with the right-hand sides `b` and the diagonal `a`: an energy.
    fn size_of_rates(&self, component: Component<'_>, memory: &[JacobianBlock]) -> f64 {
        let mut sum = 0.0;
        for (member, own) in component.members.iter().zip(&self.own) {
            let (from, lane) = (&memory[member.block as usize], member.lane as usize);
            for (own, axis) in own.iter().zip(locked_axes::<N>(member)) {
                let rate = f64::from(from.rates[axis].0[lane]);
                sum += if *own > 0.0 { rate * rate / own } else { 0.0 };
            }
        }
        sum
    }

    /// Marks the matrix as outdated, because the bodies have moved.
    pub fn invalidate(&mut self) {
        self.made_with = None;
    }

    /// Reads the rows.
    #[inline(always)]
    fn load(&mut self, component: Component<'_>, memory: &[JacobianBlock]) {
        self.rows.clear();
        self.rows.resize(component.members.len(), Rows::EMPTY);
        for (member, rows) in component.members.iter().zip(&mut self.rows) {
            rows.read(member, memory);
        }
    }

    /// Reads the right-hand side.
    fn load_rates(&mut self, component: Component<'_>, memory: &[JacobianBlock]) {
        self.x.clear();
        for (member, own) in component.members.iter().zip(&self.own) {
            let (from, lane) = (&memory[member.block as usize], member.lane as usize);
            let compliance = compliance_of(member, memory);
            let mut x = [0.0; N];
            for (row, axis) in locked_axes::<N>(member).enumerate() {
                let impulse = f64::from(from.impulses[axis].0[lane]);
                x[row] = -f64::from(from.rates[axis].0[lane]) - compliance * own[row] * impulse;
            }
            self.x.push(x);
        }
    }

    /// Replaces the first solution by the right-hand side of the second one.
    fn load_second_rhs(&mut self, component: Component<'_>, memory: &[JacobianBlock]) {
        for (at, member) in component.members.iter().enumerate() {
            let (from, lane) = (&memory[member.block as usize], member.lane as usize);
            for (row, axis) in locked_axes::<N>(member).enumerate() {
                let impulse = f64::from(from.impulses[axis].0[lane]) + self.x[at][row];
                self.x[at][row] = self.again[at][row] - self.damping[at][row] * impulse;
            }
        }
    }

    /// Fills the blocks: `J_j M⁻¹ J_iᵀ` over the common bodies of two joints.
    #[inline(always)]
    fn assemble(&mut self, component: Component<'_>, memory: &[JacobianBlock]) {
        self.diagonal.clear();
        self.below.clear();
        self.own.clear();
        self.damping.clear();
        self.first_below.clear();
        for (at, member) in component.members.iter().enumerate() {
            let (size, mut block) = (Self::row_count(member), zero());
            couple(component.members, &self.rows, [at, at], &mut block, size);
            let compliance = compliance_of(member, memory);
            let (mut own, mut damping) = ([0.0; N], [0.0; N]);
            for row in 0..size {
                own[row] = block[row][row];
                damping[row] = if component.has_loops {
                    LOOP_DAMPING * self.rows[at].without_arms(row).max(FRACTION_MIN * own[row])
                } else {
                    DAMPING * own[row]
                };
                block[row][row] += compliance * own[row] + damping[row];
            }
            self.diagonal.push(block);
            self.own.push(own);
            self.damping.push(damping);
            self.first_below.push(self.below.len());
            for &row in &component.columns[at] {
                let mut block = zero();
                couple(component.members, &self.rows, [row as usize, at], &mut block, size);
                self.below.push(block);
            }
        }
    }

    /// `L D Lᵀ`, column by column: each one takes its part off those that follow.
    #[inline(always)]
    fn eliminate(&mut self, component: Component<'_>) {
        self.inverses.clear();
        for (at, column) in component.columns.iter().enumerate() {
            let size = Self::row_count(&component.members[at]);
            let inverses = factorise(&mut self.diagonal[at], &self.own[at], size);
            self.inverses.push(inverses);
            let first = self.first_below[at];
            for block in &mut self.below[first..first + column.len()] {
                divide_right(block, &self.diagonal[at], size);
            }
            for first in 0..column.len() {
                for second in 0..=first {
                    self.update(component, at, first, second);
                }
            }
        }
    }

    /// Subtracts the effect of the elimination of the column `at` from the block of two of its rows.
    #[expect(
        clippy::expect_used,
        reason = "the engine makes the pattern, which is closed under elimination"
    )]
    #[inline(always)]
    fn update(&mut self, component: Component<'_>, at: usize, first: usize, second: usize) {
        let column = &component.columns[at];
        let (row, other) = (column[first] as usize, column[second] as usize);
        let start = self.first_below[at];
        // Columns that follow have their blocks behind those of this one.
        let (done, later) = self.below.split_at_mut(start + column.len());
        let target = if row == other {
            &mut self.diagonal[row]
        } else {
            let index = component.columns[other].binary_search(&(row as u32));
            let index = index.expect("the pattern has a block wherever elimination puts one");
            &mut later[self.first_below[other] + index - start - column.len()]
        };
        let (of_row, of_column) = (&done[start + first], &done[start + second]);
        let (size, columns) =
            (Self::row_count(&component.members[at]), Self::row_count(&component.members[other]));
        for (column, target) in target[..columns].iter_mut().enumerate() {
            let mut sum = *target;
            for m in 0..size {
                add(&mut sum, &of_row[m], -(of_column[m][column] * self.inverses[at][m]));
            }
            *target = sum;
        }
    }

    /// Forwards through `L`, divided by `D`, and back through `Lᵀ`.
    #[inline(always)]
    fn substitute(&mut self, component: Component<'_>) {
        for (at, column) in component.columns.iter().enumerate() {
            let size = Self::row_count(&component.members[at]);
            let (d, inverses) = (&self.diagonal[at], &self.inverses[at]);
            let mut x = self.x[at];
            for m in 0..size {
                for i in m + 1..size {
                    x[i] -= d[m][i] * x[m];
                }
            }
            self.x[at] = x;
            for (block, &row) in self.below[self.first_below[at]..].iter().zip(column) {
                for m in 0..size {
                    add(&mut self.x[row as usize], &block[m], -(inverses[m] * x[m]));
                }
            }
        }
        for (at, column) in component.columns.iter().enumerate().rev() {
            let size = Self::row_count(&component.members[at]);
            let (d, inverses) = (&self.diagonal[at], &self.inverses[at]);
            let mut x = self.x[at];
            for (block, &row) in self.below[self.first_below[at]..].iter().zip(column) {
                for m in 0..size {
                    x[m] -= dot(&block[m], &self.x[row as usize]);
                }
            }
            for i in (0..size).rev() {
                x[i] *= inverses[i];
                for m in i + 1..size {
                    x[i] -= d[i][m] * x[m];
                }
            }
            self.x[at] = x;
        }
    }

    /// Applies the changes to the bodies.
    ///
    /// # Safety
    /// The caller has exclusive access to the states of the component's movable bodies.
    unsafe fn push_bodies(&self, component: Component<'_>, states: &DisjointMut<'_, BodyState>) {
        for ((member, rows), x) in component.members.iter().zip(&self.rows).zip(&self.x) {
            for (side, body) in member.movable() {
                let change = rows.push(side, x);
                // SAFETY: the caller's promise.
                let state = unsafe { states.get_mut(body as usize) };
                state.add_velocity(change.map(|value| value as Real));
            }
        }
    }

    /// Writes the changes of the impulses to the rows.
    pub fn write_changes(&self, members: &[DirectJoint], memory: &mut [JacobianBlock]) {
        for (member, x) in members.iter().zip(&self.x) {
            let to = &mut memory[member.block as usize];
            for (row, axis) in locked_axes::<N>(member).enumerate() {
                to.changes[axis].0[member.lane as usize] = x[row] as Real;
            }
        }
    }
}

/// See [`Matrix::find_changes`]: in the widest registers that the machine has.
struct Solve<'a, const N: usize> {
    matrix: &'a mut Matrix<N>,
    component: Component<'a>,
    memory: &'a [JacobianBlock],
}

impl<const N: usize> Kernel for Solve<'_, N> {
    type Output = ();

    #[inline(always)]
    fn run<W: Wide>(self) {
        self.matrix.find_changes(self.component, self.memory);
    }
}
