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

use super::dense::{Block, Column, PIVOT_MIN, add, divide_right, dot, factorise, zero};
use super::driven::DrivenAxis;
use super::jacobians::{JointRows, Motion, compliance_of, couple, impulses_of, locked_axes};
use super::joint::DirectJoint;
use super::memory::Jacobians;
use super::pattern::Component;
use crate::base::disjoint::DisjointMut;
use crate::base::wide::{Kernel, Simd, Wide};
use crate::dim::math::{DIM, Real};
use crate::dim::state::BodyState;
use crate::step::solver::axis_law::{Equation, Piece};

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

/// Largest number of times that axes move to another piece of their laws in one solution.
const PIECE_CHANGES_MAX: usize = 64;
/// From this time on, one axis moves at a time.
const SIMULTANEOUS_CHANGES_MAX: usize = 8;

/// Rows of a solution.
#[derive(Copy, Clone, Debug, PartialEq)]
pub(in super::super) enum Rows {
    All,
    /// The impulses of driven axes do not change.
    Locked,
}

/// The matrix of a component, and the buffers of its solution, with `N` rows per joint.
#[derive(Default)]
pub(super) struct Matrix<const N: usize> {
    /// By direct joint.
    pub(super) rows: Vec<JointRows<N>>,
    /// By direct joint: its diagonal block; factorised, `L` below the diagonal.
    diagonal: Vec<Block<N>>,
    /// By direct joint: the inverse pivots.
    inverses: Vec<Column<N>>,
    /// By direct joint: the diagonal of `J M⁻¹ Jᵀ`.
    pub(super) own: Vec<Column<N>>,
    /// By direct joint: the smallest pivot that is not rounding; infinite for rows with a constant impulse.
    least: Vec<Column<N>>,
    pub(super) driven: Vec<DrivenAxis>,
    /// By body of the component: the velocity changes of the solution.
    pub(super) changes: Vec<Motion>,
    /// The blocks below the diagonal, those of one column together; factorised, they are `L D`.
    below: Vec<Block<N>>,
    /// By direct joint: where the blocks of its column begin.
    first_below: Vec<usize>,
    /// By direct joint: `δ D` of components with loops.
    damping: Vec<Column<N>>,
    /// By direct joint: right-hand side, then solution.
    pub(super) x: Vec<Column<N>>,
    /// By direct joint: right-hand side of the second solution.
    pub(super) again: Vec<Column<N>>,
    /// Input of the first solution of a substep, of the one before the last, and of the last one.
    pub(super) first_size: f64,
    pub(super) sizes: [f64; 2],
    /// Whether the matrix is that of the present poses.
    is_made: bool,
    /// The compliances with which it was made: by joint of its locked axes, then by driven axis; negative
    /// without an equation.
    made_with: Vec<f64>,
}

impl<const N: usize> Matrix<N> {
    /// The number of active rows of a joint. In blocks for translations alone, all rows are active: rows that
    /// are not locked stay zero, and the number is a compile-time constant.
    #[inline(always)]
    fn row_count(member: &DirectJoint) -> usize {
        if N == DIM { N } else { member.row_count() }
    }

    /// Solves a component for the changes of its impulses, and applies them to its bodies. `again`: another
    /// round of this pass.
    ///
    /// # Safety
    /// The caller has exclusive access to the states of the component's movable bodies.
    pub unsafe fn solve(
        &mut self,
        component: Component<'_>,
        rows: Rows,
        again: bool,
        memory: &Jacobians,
        states: &DisjointMut<'_, BodyState>,
        simd: Simd,
    ) {
        simd.run(Solve { matrix: self, component, rows, memory });
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
    fn find_changes(&mut self, component: Component<'_>, rows: Rows, memory: &Jacobians) {
        self.load_laws(component, rows, memory);
        for change in 0..PIECE_CHANGES_MAX {
            self.solve_pieces(component, memory);
            if rows == Rows::Locked || self.driven.is_empty() {
                return;
            }
            self.find_rates(component);
            if !self.choose_pieces(change >= SIMULTANEOUS_CHANGES_MAX) {
                return;
            }
            self.invalidate();
        }
        self.fix_impulses();
        self.solve_pieces(component, memory);
        self.find_rates(component);
    }

    /// Solves the equations of the present pieces.
    #[inline(always)]
    fn solve_pieces(&mut self, component: Component<'_>, memory: &Jacobians) {
        self.update_matrix(component, memory);
        self.load_rates(component, memory);
        self.add_constant_impulses(component);
        if component.is_redundant {
            self.again.clone_from(&self.x);
            self.substitute(component);
            self.load_second_rhs(component, Some(memory));
        }
        self.substitute(component);
    }

    /// Makes the matrix and its factors unless they are up to date.
    #[inline(always)]
    fn update_matrix(&mut self, component: Component<'_>, memory: &Jacobians) {
        let of_locked = component.members.iter().map(|member| compliance_of(member, memory));
        let of_driven = self
            .driven
            .iter()
            .map(|driven| driven.equation().map_or(-1.0, |equation| equation.compliance));
        let compliances = of_locked.chain(of_driven);
        if self.is_made && self.made_with.iter().copied().eq(compliances.clone()) {
            return;
        }
        self.made_with.clear();
        self.made_with.extend(compliances);
        self.is_made = true;
        self.load(component, memory);
        self.assemble(component, memory);
        self.eliminate(component);
    }

    /// Rolls all impulses of the component back.
    ///
    /// # Safety
    /// As [`Self::solve`].
    pub unsafe fn roll_back(
        &mut self,
        component: Component<'_>,
        memory: &Jacobians,
        states: &DisjointMut<'_, BodyState>,
    ) {
        for (member, x) in component.members.iter().zip(&mut self.x) {
            *x = impulses_of(member, memory).map(|impulse| -impulse);
        }
        self.load_laws(component, Rows::All, memory);
        for driven in &mut self.driven {
            let [at, row] = driven.at;
            self.x[at][row] = -driven.impulse;
            driven.piece = Piece::Constant(0.0);
        }
        // SAFETY: the caller's promise.
        unsafe { self.push_bodies(component, states) };
    }

    /// Marks the matrix as outdated, because the bodies have moved.
    pub fn invalidate(&mut self) {
        self.is_made = false;
    }

    /// Reads the rows.
    #[inline(always)]
    fn load(&mut self, component: Component<'_>, memory: &Jacobians) {
        self.rows.clear();
        self.rows.resize(component.members.len(), JointRows::EMPTY);
        for (member, rows) in component.members.iter().zip(&mut self.rows) {
            rows.read(member, memory);
        }
    }

    /// Reads the right-hand side.
    fn load_rates(&mut self, component: Component<'_>, memory: &Jacobians) {
        self.x.clear();
        for (member, own) in component.members.iter().zip(&self.own) {
            let (from, lane) = (&memory.blocks[member.block as usize], member.lane as usize);
            let (compliance, impulses) =
                (compliance_of(member, memory), impulses_of::<N>(member, memory));
            let mut x = [0.0; N];
            for (row, axis) in locked_axes::<N>(member).enumerate() {
                let rate = f64::from(from.rates[axis].0[lane]);
                x[row] = -rate - compliance * own[row] * impulses[row];
            }
            self.x.push(x);
        }
        for driven in &self.driven {
            let [at, row] = driven.at;
            self.x[at][row] = driven.equation().map_or(0.0, |equation| equation.missing);
        }
    }

    /// Replaces the first solution by the right-hand side of the second solution. Displacements have no
    /// impulses before the solution, and no `memory`.
    pub(super) fn load_second_rhs(&mut self, component: Component<'_>, memory: Option<&Jacobians>) {
        for (at, member) in component.members.iter().enumerate() {
            let before = memory.map_or([0.0; N], |memory| impulses_of(member, memory));
            for row in 0..member.locked_row_count() {
                let impulse = before[row] + self.x[at][row];
                self.x[at][row] = self.again[at][row] - self.damping[at][row] * impulse;
            }
        }
        for driven in &self.driven {
            let [at, row] = driven.at;
            let before = if memory.is_some() { driven.impulse } else { 0.0 };
            let impulse = before + self.x[at][row];
            self.x[at][row] = self.again[at][row] - self.damping[at][row] * impulse;
        }
    }

    /// Fills the blocks: `J_j M⁻¹ J_iᵀ` over the common bodies of two joints.
    #[inline(always)]
    fn assemble(&mut self, component: Component<'_>, memory: &Jacobians) {
        self.diagonal.clear();
        self.below.clear();
        self.own.clear();
        self.least.clear();
        self.damping.clear();
        self.first_below.clear();
        for (at, member) in component.members.iter().enumerate() {
            let (size, mut block) = (Self::row_count(member), zero());
            couple(component.members, &self.rows, [at, at], &mut block, size);
            let compliance = compliance_of(member, memory);
            let (mut own, mut damping, mut least) = ([0.0; N], [0.0; N], [0.0; N]);
            for row in 0..size {
                own[row] = block[row][row];
                least[row] = PIVOT_MIN * own[row];
                damping[row] = if component.is_redundant {
                    LOOP_DAMPING * self.rows[at].without_arms(row).max(FRACTION_MIN * own[row])
                } else {
                    DAMPING * own[row]
                };
                let is_locked = row < member.locked_row_count();
                let compliance = if is_locked { compliance } else { 0.0 };
                block[row][row] += compliance * own[row] + damping[row];
            }
            self.diagonal.push(block);
            self.own.push(own);
            if component.is_redundant {
                least = self.rows[at].pivots_min(&own);
            }
            self.least.push(least);
            self.damping.push(damping);
            self.first_below.push(self.below.len());
            for &row in &component.columns[at] {
                let mut block = zero();
                couple(component.members, &self.rows, [row as usize, at], &mut block, size);
                self.below.push(block);
            }
        }
        for driven in &self.driven {
            let [at, row] = driven.at;
            match driven.equation() {
                Some(Equation { compliance, .. }) => self.diagonal[at][row][row] += compliance,
                None => self.least[at][row] = f64::INFINITY,
            }
        }
    }

    /// `L D Lᵀ`, column by column: each one takes its part off those that follow.
    #[inline(always)]
    fn eliminate(&mut self, component: Component<'_>) {
        self.inverses.clear();
        for (at, column) in component.columns.iter().enumerate() {
            let size = Self::row_count(&component.members[at]);
            let inverses = factorise(&mut self.diagonal[at], &self.least[at], size);
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
        let mut inverses = self.inverses.iter().flatten();
        debug_assert!(!inverses.any(|&inverse| inverse < 0.0), "the matrix is positive definite");
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
    pub(super) fn substitute(&mut self, component: Component<'_>) {
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
    pub(super) unsafe fn push_bodies(
        &self,
        component: Component<'_>,
        states: &DisjointMut<'_, BodyState>,
    ) {
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
    pub fn write_changes(&self, members: &[DirectJoint], memory: &mut Jacobians) {
        for (member, x) in members.iter().zip(&self.x) {
            let to = &mut memory.blocks[member.block as usize];
            for (row, axis) in locked_axes::<N>(member).enumerate() {
                to.changes[axis].0[member.lane as usize] = x[row] as Real;
            }
        }
        for driven in &self.driven {
            let [at, row] = driven.at;
            let (member, change) = (&members[at], self.x[at][row]);
            let lane = member.lane as usize;
            let index =
                memory.blocks[member.block as usize].first_row + row - member.locked_row_count();
            driven.write(&mut memory.driven[index], lane, change, self.own[at][row]);
        }
    }
}

/// See [`Matrix::find_changes`]: in the widest registers that the machine has.
struct Solve<'a, const N: usize> {
    matrix: &'a mut Matrix<N>,
    component: Component<'a>,
    rows: Rows,
    memory: &'a Jacobians,
}

impl<const N: usize> Kernel for Solve<'_, N> {
    type Output = ();

    #[inline(always)]
    fn run<W: Wide>(self) {
        self.matrix.find_changes(self.component, self.rows, self.memory);
    }
}
