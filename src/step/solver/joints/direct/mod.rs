//! Direct solution of connected joints.
//!
//! An iteration over the joints of a chain carries a force by one or two links. A long chain, or a light one
//! with a heavy body at its end, has not converged at the end of the substep. So the axes of all joints
//! that are connected through bodies are one system of equations, for locked axes
//!
//! ```text
//! (J M⁻¹ Jᵀ + Γ) Δλ = -(J v + bias + Γ λ)
//! ```
//!
//! solved by a sparse factorisation `L D Lᵀ` whose elements are the small blocks of joint against joint. It
//! has a block for each two joints with a common movable body. Joints are eliminated from the leaves to the
//! root of a breadth-first search. A tree gets no further blocks (Baraff, "Linear-time dynamics using
//! Lagrange multipliers", 1996), and the work is proportional to the number of joints. Loops get some more,
//! as few as a good order lets them (`order.rs`). Components with too many blocks (a net, a cloth of joints)
//! are left to the iterative solver.
//!
//! The matrix depends on the poses of the bodies, so it is made once per substep. The relax pass and the next
//! solve pass use the same one, unless their softness differs.
//!
//! `Γ` is the compliance of a row times its diagonal. Loops have redundant rows; redundant rows share the
//! load (`matrix.rs`).
//!
//! Stiff components (`../geometric_stiffness.rs`) use the rows at the predicted poses, and need a new matrix
//! in each round. Components with a large unconstrained displacement are solved once, at the current poses.
//! Each component ends its rounds on its own convergence, independent of the others.
//!
//! Components with little gain are left to the iterative solver, too: unattached ones with few joints and
//! moderate mass ratios, without springs or motors that do work. A ragdoll carries no load for long.
//!
//! Limits and motors are rows of the same system, with a law in place of an equation: see `axis_law.rs`.

mod corrections;
mod dense;
mod driven;
mod driven_rows;
mod factor;
mod jacobians;
mod joint;
mod masses;
mod matrix;
mod memory;
mod order;
mod pattern;
mod progress;
#[cfg(test)]
mod tests;

pub(super) use driven_rows::{AxisNow, write_law};
pub(super) use joint::DirectJoint;
pub(super) use matrix::Rows;
pub(super) use memory::{
    ImpactImpulse, JacobianBlock, Jacobians, SharedJacobians, count, finish, write_rows,
};

use super::block::JointBlock;
use crate::base::disjoint::DisjointMut;
use crate::base::tasks::Tasks;
use crate::base::wide::{Lane, Simd};
use crate::dim::math::{Real, SPATIAL_DIM};
use crate::dim::state::BodyState;
use crate::step::solver::impact_time::ImpactTime;
use factor::Factor;
use joint::has_moderate_mass_ratio;
use pattern::Pattern;
use progress::Progress;

/// Largest number of Newton steps per substep towards the constrained poses. A pendulum keeps its energy with
/// two; bodies with large rotations in a substep need more.
const ROUNDS_MAX: usize = 8;
/// The same for stiff components, whose projection starts farther away.
const STIFF_ROUNDS_MAX: usize = 4;

/// Errors that would be corrected by larger velocities (length units or radians per second) than this may be
/// corrected apart from the velocities: see `corrections.rs`.
pub(super) const CORRECTED_APART_RATE_MIN: Real = 1.0;

/// Components of connected joints, and their matrices.
#[derive(Default)]
pub(super) struct Direct {
    pattern: Pattern,
    /// One per component; some may be left over from larger steps.
    factors: Vec<Factor>,
    /// By component.
    solve_states: Vec<SolveState>,
    /// By component: whether a joint has a large error, which is corrected apart.
    is_corrected_apart: Vec<bool>,
}

/// Method for a component in a substep: see `../geometric_stiffness.rs`.
#[derive(Copy, Clone, Debug, PartialEq)]
enum Linearization {
    /// At the end of the substep, along the rows of the current poses.
    SubstepEnd,
    /// Stiff: projected at the predicted poses of free motion, along the rows there.
    PredictedPose,
    /// Stiff with a large unconstrained displacement, or with a large error: projected at the current poses.
    CurrentPose,
}

/// State of the solution of a component.
#[derive(Copy, Clone, Debug)]
struct SolveState {
    linearization: Linearization,
    /// Number of rounds of this pass with this linearisation.
    rounds: usize,
    next: Next,
}

impl SolveState {
    /// Selects the linearisation of a stiff component.
    fn linearize_stiff(&mut self, has_large_displacement: bool) {
        self.linearization = if has_large_displacement {
            Linearization::CurrentPose
        } else {
            Linearization::PredictedPose
        };
    }

    /// The step after a round of a stiff component.
    fn next_if_stiff(&self) -> Next {
        if self.linearization == Linearization::PredictedPose && self.rounds < STIFF_ROUNDS_MAX {
            Next::Solve
        } else {
            Next::Nothing
        }
    }
}

/// Test of a component's joints.
#[derive(Copy, Clone, Debug)]
pub(super) enum StiffnessTest {
    /// Tests whether the computed forces make the component stiff.
    IsStiff,
    /// For a stiff component without impulses, tests whether its unconstrained displacement is large.
    HasLargeDisplacement,
}

/// The next step of a component.
#[derive(Copy, Clone, Debug, PartialEq)]
enum Next {
    Solve,
    /// It became stiff: its impulses are rolled back, and the round is repeated.
    Rollback,
    Nothing,
}

impl Direct {
    /// Finds out which joints are connected, which of them are to be solved here, and in which order to
    /// eliminate these.
    pub fn build(&mut self, members: &[DirectJoint], body_count: usize) {
        self.pattern.build(members, body_count);
        let count = self.pattern.component_count();
        if self.factors.len() < count {
            self.factors.resize_with(count, Factor::default);
        }
        for (index, factor) in self.factors[..count].iter_mut().enumerate() {
            factor.resize(self.pattern.component(index));
        }
    }

    /// Returns whether the joint is solved directly.
    pub fn contains(&self, slot: u32) -> bool {
        self.pattern.contains(slot)
    }

    /// Returns whether the joint is connected with no other one, and drives a single axis.
    pub fn is_alone(&self, slot: u32) -> bool {
        self.pattern.is_alone(slot)
    }

    /// Returns whether the joint's component is too large for a direct solution: a large net.
    pub fn is_too_large(&self, slot: u32) -> bool {
        self.pattern.is_too_large(slot)
    }

    /// Notes the block and the lane of a joint's rows. Returns whether the joint is solved directly.
    pub fn place(&mut self, slot: u32, at: [usize; 2]) -> bool {
        self.pattern.place(slot, at)
    }

    /// Returns whether there is nothing to solve.
    pub fn is_empty(&self) -> bool {
        self.pattern.component_count() == 0
    }

    /// Marks the components that are stiff from the beginning, as `find` returns for the joints of each.
    pub fn select_method(&mut self, mut find: impl FnMut(&[DirectJoint]) -> bool) {
        self.solve_states.clear();
        for index in 0..self.pattern.component_count() {
            let is_stiff = find(self.pattern.component(index).members);
            if is_stiff {
                // Stiff joints take other rows than those of the last relax pass.
                self.factors[index].invalidate();
            }
            let linearization =
                if is_stiff { Linearization::PredictedPose } else { Linearization::SubstepEnd };
            self.solve_states.push(SolveState { linearization, rounds: 0, next: Next::Solve });
        }
    }

    /// Begins a pass.
    pub fn begin(&mut self) {
        debug_assert_eq!(self.solve_states.len(), self.pattern.component_count());
        for solve_state in &mut self.solve_states {
            (solve_state.rounds, solve_state.next) = (0, Next::Solve);
        }
    }

    /// Begins a solve pass: finds the stiff components with a large unconstrained displacement by `test`.
    pub fn find_large_displacements(
        &mut self,
        rows: &mut [JacobianBlock],
        mut test: impl FnMut(&[DirectJoint], StiffnessTest) -> bool,
    ) {
        for (index, solve_state) in self.solve_states.iter_mut().enumerate() {
            let members = self.pattern.component(index).members;
            if self.is_corrected_apart[index] {
                // The anchors are arms of the length of their distance, and rotate far with the bodies.
                solve_state.linearization = Linearization::CurrentPose;
            } else if solve_state.linearization == Linearization::PredictedPose {
                solve_state.linearize_stiff(test(members, StiffnessTest::HasLargeDisplacement));
            }
            note_linearization(members, rows, solve_state.linearization);
        }
    }

    /// Sets the impact time of each body of a component to the mean over the component.
    pub fn merge_impact_times(&self, times: &mut [ImpactTime]) {
        for index in 0..self.pattern.component_count() {
            let members = self.pattern.component(index).members;
            let bodies =
                || members.iter().flat_map(DirectJoint::movable).map(|(_, body)| body as usize);
            let mut all = ImpactTime::default();
            bodies().for_each(|body| all += core::mem::take(&mut times[body]));
            bodies().for_each(|body| times[body] = all);
        }
    }

    /// Ends a round of the solve pass. Returns whether another round is necessary. `test` returns whether a
    /// component is stiff.
    pub fn needs_another_round(
        &mut self,
        rows: &mut Jacobians,
        inv_h: Real,
        mut test: impl FnMut(&[DirectJoint], StiffnessTest) -> bool,
    ) -> bool {
        let mut is_unfinished = false;
        for (index, solve_state) in self.solve_states.iter_mut().enumerate() {
            let (component, factor) = (self.pattern.component(index), &mut self.factors[index]);
            solve_state.rounds += 1;
            solve_state.next = match solve_state.next {
                Next::Nothing => Next::Nothing,
                Next::Rollback => {
                    factor.invalidate();
                    solve_state.rounds = 0;
                    solve_state.linearize_stiff(test(
                        component.members,
                        StiffnessTest::HasLargeDisplacement,
                    ));
                    note_linearization(
                        component.members,
                        &mut rows.blocks,
                        solve_state.linearization,
                    );
                    Next::Solve
                }
                Next::Solve if solve_state.linearization != Linearization::SubstepEnd => {
                    solve_state.next_if_stiff()
                }
                Next::Solve if solve_state.rounds == 1 => Next::Solve,
                Next::Solve
                    if solve_state.rounds == 2
                        && test(component.members, StiffnessTest::IsStiff) =>
                {
                    Next::Rollback
                }
                Next::Solve => match factor.progress(solve_state.rounds, component, rows, inv_h) {
                    Progress::Done => Next::Nothing,
                    Progress::Near | Progress::Far if solve_state.rounds < ROUNDS_MAX => {
                        Next::Solve
                    }
                    Progress::Near => Next::Nothing,
                    Progress::Far | Progress::Diverging => Next::Rollback,
                },
            };
            is_unfinished |= solve_state.next != Next::Nothing;
        }
        is_unfinished
    }

    /// Begins a step: notes the components with errors that are corrected apart, and the rows of their
    /// joints. The bias of a spring is its force, and no error.
    pub fn begin_step(&mut self, blocks: &[JointBlock], rows: &mut [JacobianBlock]) {
        self.is_corrected_apart.clear();
        for index in 0..self.pattern.component_count() {
            let members = self.pattern.component(index).members;
            let of = |member: &DirectJoint| (&blocks[member.block as usize], member.lane as usize);
            let any = |lanes: fn(&JointBlock) -> &Lane| {
                members.iter().map(of).any(|(block, lane)| lanes(block).0[lane] > 0.0)
            };
            let is_corrected_apart = any(|block| &block.exceeds_limit)
                || (any(|block| &block.is_displaced) && has_moderate_mass_ratio(members.iter()));
            for member in members {
                let (block, lane) = of(member);
                let is_corrected = is_corrected_apart && block.is_spring.0[lane] == 0.0;
                let to = &mut rows[member.block as usize].is_corrected_apart;
                to.0[lane] = if is_corrected { 1.0 } else { 0.0 };
            }
            self.is_corrected_apart.push(is_corrected_apart);
        }
    }

    /// Moves the bodies by what corrects large errors of their joints: see `corrections.rs`.
    pub fn correct_poses(
        &mut self,
        rows: &Jacobians,
        substep: Real,
        mut displace: impl FnMut(usize, [Real; SPATIAL_DIM]),
    ) {
        for (index, factor) in self.factors.iter_mut().enumerate() {
            if self.is_corrected_apart.get(index).is_some_and(|is_corrected| *is_corrected) {
                let component = self.pattern.component(index);
                factor.correct_poses(component, rows, substep, &mut displace);
            }
        }
    }

    /// Marks all matrices as outdated, because the bodies moved or changed.
    pub fn invalidate_matrices(&mut self) {
        self.factors.iter_mut().for_each(Factor::invalidate);
    }

    /// Solves `selected` rows of the components whose members `is_selected` accepts. Applies the changes of
    /// impulses to the rows, and the resulting velocity changes to the bodies.
    pub fn solve(
        &mut self,
        selected: Rows,
        rows: &mut Jacobians,
        states: DisjointMut<'_, BodyState>,
        is_selected: impl Fn(&[DirectJoint]) -> bool + Sync,
        simd: Simd,
        tasks: Tasks<'_>,
    ) {
        let count = self.pattern.component_count();
        let (pattern, solve_states) = (&self.pattern, &self.solve_states);
        let is_due = |index: &usize| {
            solve_states[*index].next != Next::Nothing
                && is_selected(pattern.component(*index).members)
        };
        let factors = DisjointMut::new(&mut self.factors);
        let read = &*rows;
        tasks.par_for(count, 1, |range| {
            for index in range.filter(is_due) {
                // SAFETY: components have no common joints or movable bodies, and each is solved by one task.
                unsafe {
                    let (factor, component) = (factors.get_mut(index), pattern.component(index));
                    let solve_state = solve_states[index];
                    if solve_state.next == Next::Rollback {
                        factor.roll_back(component, read, &states);
                        continue;
                    }
                    let (again, at_predicted_pose) = (
                        solve_state.rounds > 0,
                        solve_state.linearization == Linearization::PredictedPose,
                    );
                    if again && at_predicted_pose && factor.has_converged(component, read) {
                        continue;
                    }
                    factor.solve(component, selected, again, read, &states, simd);
                    // The rows were those of predicted poses.
                    if at_predicted_pose {
                        factor.invalidate();
                    }
                }
            }
        });
        for index in (0..count).filter(is_due) {
            self.factors[index].write_changes(pattern.component(index).members, rows);
        }
    }
}

/// Notes the linearisation of a component in its rows.
fn note_linearization(
    members: &[DirectJoint],
    rows: &mut [JacobianBlock],
    linearization: Linearization,
) {
    for member in members {
        let (memory, lane) = (&mut rows[member.block as usize], member.lane as usize);
        memory.at_predicted_pose.0[lane] =
            if linearization == Linearization::PredictedPose { 1.0 } else { 0.0 };
        memory.includes_curvature.0[lane] =
            if linearization == Linearization::CurrentPose { 0.0 } else { 1.0 };
    }
}
