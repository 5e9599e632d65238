//! Joints that hold each other, solved together and exactly.
//!
//! Sweeping over the joints of a chain carries a force from one end to the other by a link or two per sweep.
//! A long chain, or a light one with something heavy at its end, is far from done when the substep is. So the
//! locked axes of all joints that are connected through bodies are one system of linear equations,
//!
//! ```text
//! (J M⁻¹ Jᵀ + Γ) Δλ = -(J v + bias + Γ λ)
//! ```
//!
//! solved by a sparse factorisation `L D Lᵀ` whose elements are the small blocks of joint against joint. A
//! block stands where two joints share a body that can move. Joints are eliminated from the leaves to the root of
//! a breadth-first search: a tree then gets no blocks beyond these (Baraff, "Linear-time dynamics using Lagrange
//! multipliers", 1996), and the work is proportional to the number of joints. Loops get some more, as few as a good
//! order lets them (`order.rs`). What would get too many (a net, a cloth of joints) is left to the sweeps.
//!
//! The matrix depends on where the bodies are, so it is made once per substep: the relax pass and the solve pass
//! of the next substep share it, unless they soften it differently.
//!
//! `Γ` is the softness: a row's yield times its diagonal. Loops hold some things twice; those who do so share the load
//! (`factor.rs`).
//!
//! Taut components (`../taut.rs`) take their rows from where their bodies will be, and need a new matrix in each round. So their
//! rounds end when there is nothing left to do.
//!
//! Components that would gain little are left to the sweeps, too: those that nothing holds, with few joints and bodies
//! of even masses. A ragdoll bears no load for long.
//!
//! Limits and motors are no equations. They stay with the sweeps, before each exact solution.

mod factor;
mod masses;
mod memory;
mod order;
mod pattern;
#[cfg(test)]
mod tests;

pub(super) use memory::{Look, RowMemory, count, finish, write_rows};
pub(super) use pattern::Member;

use crate::base::disjoint::DisjointMut;
use crate::base::tasks::Tasks;
use crate::base::wide::Simd;
use crate::dim::state::BodyState;
use factor::Factor;
use pattern::Pattern;

/// Components of connected joints, and their matrices.
#[derive(Default)]
pub(super) struct Direct {
    pattern: Pattern,
    /// One per component; some may be left over from larger steps.
    factors: Vec<Factor>,
    /// By component.
    taut: Vec<bool>,
    gained: Vec<bool>,
}

impl Direct {
    /// Finds out which joints are connected, which of them are to be solved here, and in which order to eliminate
    /// these.
    pub fn build(&mut self, members: &[Member], body_count: usize) {
        self.pattern.build(members, body_count);
        let count = self.pattern.component_count();
        if self.factors.len() < count {
            self.factors.resize_with(count, Factor::default);
        }
        self.forget_matrices();
    }

    /// Is the joint solved here?
    pub fn contains(&self, slot: u32) -> bool {
        self.pattern.contains(slot)
    }

    /// Notes in which lane of which block a joint's rows stand. No if it is not solved here.
    pub fn place(&mut self, slot: u32, at: [usize; 2]) -> bool {
        self.pattern.place(slot, at)
    }

    /// Is there nothing to do?
    pub fn is_empty(&self) -> bool {
        self.pattern.component_count() == 0
    }

    /// Notes which components are taut, as `find` says of the members of each.
    pub fn tighten(&mut self, mut find: impl FnMut(&[Member]) -> bool) {
        self.taut.clear();
        for index in 0..self.pattern.component_count() {
            self.taut.push(find(self.pattern.component(index).members));
        }
    }

    /// The bodies have moved, or others took their places: all matrices must be made anew.
    pub fn forget_matrices(&mut self) {
        self.factors.iter_mut().for_each(Factor::forget);
    }

    /// Is any component taut?
    pub fn any_taut(&self) -> bool {
        self.taut.contains(&true)
    }

    /// Finds the taut components that gained more energy since they were solved first than the correction of errors may
    /// bring in. Is there any?
    pub fn find_gains(&mut self) -> bool {
        let has_gained = |(taut, factor): (&bool, &Factor)| *taut && factor.has_gained();
        self.gained.clear();
        self.gained.extend(self.taut.iter().zip(&self.factors).map(has_gained));
        self.gained.contains(&true)
    }

    /// The joints of the components that were found.
    pub fn gained(&self) -> impl Iterator<Item = &Member> {
        let components = (0..self.gained.len()).filter(|&index| self.gained[index]);
        components.flat_map(|index| self.pattern.component(index).members)
    }

    /// Solves the components that are `wanted`, by their members and whether they are taut; without looking ahead only those
    /// that gained energy. Gives the rows their change
    /// of impulse, and the bodies what it does to them.
    pub fn solve(
        &mut self,
        rows: &mut [RowMemory],
        states: DisjointMut<'_, BodyState>,
        wanted: impl Fn(&[Member], bool) -> bool + Sync,
        look: Look,
        simd: Simd,
        tasks: Tasks<'_>,
    ) {
        let count = self.pattern.component_count();
        let (pattern, taut, gained) = (&self.pattern, &self.taut, &self.gained);
        let is_wanted = |index: &usize| match look {
            Look::Nowhere => gained[*index],
            _ => wanted(pattern.component(*index).members, taut[*index]),
        };
        let factors = DisjointMut::new(&mut self.factors);
        let read = &*rows;
        tasks.par_for(count, 1, |range| {
            for index in range.filter(is_wanted) {
                // SAFETY: components share neither joints nor bodies that can move, and each is solved by one
                // task.
                unsafe {
                    let (factor, component) = (factors.get_mut(index), pattern.component(index));
                    let again = look != Look::First;
                    if look == Look::Again && taut[index] && factor.has_converged(component, read) {
                        continue;
                    }
                    factor.solve(component, (again, taut[index]), read, &states, simd);
                    // Taut joints took their rows from where the bodies are not yet.
                    if taut[index] {
                        factor.forget();
                    }
                }
            }
        });
        for index in (0..count).filter(is_wanted) {
            self.factors[index].write_changes(pattern.component(index), rows);
        }
    }
}
