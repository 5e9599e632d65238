//! The matrix of one component: put together, factorised, solved.
//!
//! Numbers are of double precision whatever the engine's are: a chain of light links under a weight a
//! thousand times as heavy loses three digits here, and single precision has seven.
//!
//! Blocks have room for joints that lock all axes or, where no joint of the component locks a rotation, for translations
//! alone: chains of ropes and balls take half of the time so. Rows of joints that lock fewer axes stand first.
//!
//! ## What is held twice
//! Three hinges hold a door in more ways than it can move: some impulses `n` do nothing to the bodies, `A n = 0` with
//! `A = J M⁻¹ Jᵀ`, and `A λ = b` says nothing of their share in `λ`. What is left there is rounding, divided by next to
//! nothing: hinges that strain against each other with a thousand times what they bear. Loops alone can do that; for
//! components that have some, of all impulses which do what they should the least are wanted. They minimise `λᵀ D λ`, where
//! `D` holds the inverse masses that each row moves, without its levers: equal joints bear equal loads, wherever they are.
//!
//! With a small damping `δ` (Tikhonov's) the equations have one solution, and the factors of the damped matrix are those
//! that solve it. One more turn with them takes away what the first one found where it should find nothing:
//!
//! ```text
//! (A + δ D) y = b        (A + δ D) Δλ = b - δ D (λ + y)
//! ```
//!
//! Along an eigenvector of `D⁻¹ A` with the eigenvalue `a` this is `Δλ = (a b/(a + δ) - δ λ)/(a + δ)`. For `a = 0`
//! nothing is left of `b`, and `λ`, which has been along other eigenvectors before the bodies turned, goes away. For
//! `a ≫ δ` it is `b/a`: what is well determined gives way by `δ D λ` of velocity, which is rounding. (The first turn alone
//! leaves `b/δ` for `a = 0`. With `δ` large enough to make that small, bridges sag.) The idea is that of the proximal
//! method (Rockafellar, "Monotone operators and the proximal point algorithm", 1976), turned round: its steps go to
//! the solution from the last impulses, these go from the solution to none.

use super::dense::{Block, Column, add, divide_right, dot, factorise, zero};
use super::jacobians::{Rows, compliance_of, couple, locked_axes};
use super::memory::JacobianBlock;
use super::pattern::{Component, DirectJoint};
use crate::base::disjoint::DisjointMut;
use crate::base::wide::{Kernel, Simd, Wide};
use crate::dim::math::{DIM, Real};
use crate::dim::state::BodyState;

/// By what share of itself each diagonal element is enlarged (Levenberg and Marquardt's damping). Without it, long
/// chains under 10⁵ times the mass of a link answer to the rounding of velocities with impulses that throw their links
/// about. It slows the correction of errors down, and adds none: at rest, nothing is left to correct.
const DAMPING: f64 = 2.0 * Real::EPSILON as f64;

/// The damping `δ` of components with loops: above what the rounding of rows (its square) and that of the factorisation
/// make of zero, below what heavy weights on light chains make of one.
const SHARING: f64 = 8.0 * Real::EPSILON as f64 + 1.0e-8;
/// The least element of `D` as a share of the row's own diagonal: where a body can turn and not move, or is far away.
const SHARE_MIN: f64 = 1.0e-3;

/// When taut joints are done: the share that the size of their rates, an energy, has of what it was in the first round. A
/// round leaves the square of what it finds, so that a machine of light bars goes from 1 to 10⁻⁴ and to 10⁻⁹; for a chain
/// that hangs at rest 10⁻⁵ is rounding.
const DONE: f64 = 1.0e-4;

/// When other joints are done: what is left, as a share of what their impulses do as a whole (both energies).
const PRECISION: f64 = 1.0e-9;
/// The rounding of where anchors are, in levers.
const NOISE: f64 = 4.0 * Real::EPSILON as f64;
/// With more than this share left, the joints are not where they should be.
const ROUGH: f64 = 1.0e-3;
/// Rounds that find more than the impulses do, and so many times what the last one found, lead away.
const ASTRAY: f64 = 100.0;

/// How far the rounds of a solution have come.
#[derive(Copy, Clone, Debug, PartialEq)]
pub(super) enum Progress {
    Done,
    /// Another round would make it better, and that is all.
    Near,
    /// It takes another round.
    Far,
    /// The rounds lead away.
    Astray,
}

/// The matrix of a component, and the buffers to solve it: with room for `N` rows of each joint.
#[derive(Default)]
pub(super) struct Matrix<const N: usize> {
    /// By member.
    rows: Vec<Rows<N>>,
    /// By member: its diagonal block; factorised, `L` below the diagonal.
    diagonal: Vec<Block<N>>,
    /// By member: the inverse pivots.
    inverses: Vec<Column<N>>,
    /// By member: the diagonal of `J M⁻¹ Jᵀ`.
    own: Vec<Column<N>>,
    /// The blocks below the diagonal, those of one column together; factorised, they are `L D`.
    below: Vec<Block<N>>,
    /// By member: where the blocks of its column begin.
    first_below: Vec<usize>,
    /// By member: `δ D` of components with loops.
    damping: Vec<Column<N>>,
    /// By member: right-hand side, then solution.
    x: Vec<Column<N>>,
    /// By member: right-hand side of the second turn.
    again: Vec<Column<N>>,
    /// How much the first solution of a substep had to do, the one before the last, and the last one.
    first_size: f64,
    sizes: [f64; 2],
    /// The sum of the yields with which the matrix was made; `None` if the bodies are elsewhere by now.
    made_with: Option<f64>,
}

impl<const N: usize> Matrix<N> {
    /// How many rows of a joint take part. Where there is room for translations alone, all of them do: rows that are not locked
    /// stay zero, and the compiler knows the number.
    #[inline(always)]
    fn row_count(member: &DirectJoint) -> usize {
        if N == DIM { N } else { member.form.row_count() }
    }

    /// Solves a component for the changes of its impulses, and gives its bodies what these do. `again`: not for the first
    /// time in this visit.
    ///
    /// # Safety
    /// Nobody else may touch the states of the component's movable bodies meanwhile.
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
            self.load_shares(component, memory);
        }
        self.substitute(component);
    }

    /// Returns whether the residual of the last stiff solution is negligible against the first one. Then no
    /// impulses change.
    pub fn has_converged(&mut self, component: Component<'_>, memory: &[JacobianBlock]) -> bool {
        let is_done = self.size_of_rates(component, memory) <= DONE * self.first_size;
        if is_done {
            self.x.fill([0.0; N]);
        }
        is_done
    }

    /// Takes all impulses of the component back.
    ///
    /// # Safety
    /// As [`Self::solve`].
    pub unsafe fn take_back(
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

    /// How far the rounds have come, the last of which is at least the second one. What it has left is to what it found as
    /// that is to what the one before it had found.
    pub fn progress(
        &self,
        component: Component<'_>,
        memory: &[JacobianBlock],
        inv_h: Real,
    ) -> Progress {
        let [before, last] = self.sizes;
        let rest = if last < before { last * (last / before) } else { last };
        let (load, noise) = self.size_of_load(component, memory, f64::from(inv_h));
        if rest <= PRECISION * load + noise {
            Progress::Done
        } else if last > load && last > ASTRAY * before {
            Progress::Astray
        } else if rest > ROUGH * load {
            Progress::Far
        } else {
            Progress::Near
        }
    }

    /// As [`Self::size_of_rates`], of what the impulses do as a whole, and of what rounding makes of rates.
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
                let rounding = NOISE * rows.size_of(row) * inv_h;
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

    /// The bodies have moved: the matrix must be made anew.
    pub fn forget(&mut self) {
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

    /// Puts the right-hand side of the second turn in place of the first one's solution.
    fn load_shares(&mut self, component: Component<'_>, memory: &[JacobianBlock]) {
        for (at, member) in component.members.iter().enumerate() {
            let (from, lane) = (&memory[member.block as usize], member.lane as usize);
            for (row, axis) in locked_axes::<N>(member).enumerate() {
                let impulse = f64::from(from.impulses[axis].0[lane]) + self.x[at][row];
                self.x[at][row] = self.again[at][row] - self.damping[at][row] * impulse;
            }
        }
    }

    /// Fills the blocks: `J_j M⁻¹ J_iᵀ` over the bodies that two joints share.
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
                    SHARING * self.rows[at].without_arms(row).max(SHARE_MIN * own[row])
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

    /// Takes what the elimination of the column `at` does off the block of two of its rows.
    #[expect(clippy::expect_used, reason = "the pattern is ours, and closed under elimination")]
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

    /// Gives the bodies what the changes do to them.
    ///
    /// # Safety
    /// Nobody else may touch the states of the component's movable bodies meanwhile.
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
