//! The matrix of one component, with blocks of the size of its joints' rows.

use super::joint::DirectJoint;
use super::matrix::{Matrix, Rows};
use super::memory::Jacobians;
use super::pattern::Component;
use super::progress::Progress;
use crate::base::disjoint::DisjointMut;
use crate::base::wide::Simd;
use crate::dim::math::{DIM, Real, SPATIAL_DIM};
use crate::dim::state::BodyState;

/// See [`Matrix`]. Joints that lock translations alone have half of the rows and a third of the work.
pub(super) enum Factor {
    /// No joint locks a rotation.
    Translations(Matrix<DIM>),
    All(Matrix<SPATIAL_DIM>),
}

impl Default for Factor {
    fn default() -> Self {
        Self::Translations(Matrix::default())
    }
}

/// Calls a method of the matrix of either size.
macro_rules! of_matrix {
    ($factor:expr, $matrix:ident => $call:expr) => {
        match $factor {
            Factor::Translations($matrix) => $call,
            Factor::All($matrix) => $call,
        }
    };
}

impl Factor {
    /// Resizes the blocks for a component, and clears the last matrix.
    pub fn resize(&mut self, component: Component<'_>) {
        let turns = component
            .members
            .iter()
            .any(|member| member.form.locks_rotations() || member.row_count() > DIM);
        if turns != matches!(self, Self::All(_)) {
            *self = if turns { Self::All(Matrix::default()) } else { Self::default() };
        }
        self.invalidate();
    }

    /// See [`Matrix::solve`].
    ///
    /// # Safety
    /// As [`Matrix::solve`].
    pub unsafe fn solve(
        &mut self,
        component: Component<'_>,
        rows: Rows,
        again: bool,
        memory: &Jacobians,
        states: &DisjointMut<'_, BodyState>,
        simd: Simd,
    ) {
        // SAFETY: the caller's promise.
        of_matrix!(self, matrix => unsafe {
            matrix.solve(component, rows, again, memory, states, simd);
        });
    }

    /// Returns whether the component has converged: see [`Matrix::has_converged`].
    pub fn has_converged(&mut self, component: Component<'_>, memory: &Jacobians) -> bool {
        of_matrix!(self, matrix => matrix.has_converged(component, memory))
    }

    /// See [`Matrix::roll_back`].
    ///
    /// # Safety
    /// As [`Matrix::solve`].
    pub unsafe fn roll_back(
        &mut self,
        component: Component<'_>,
        memory: &Jacobians,
        states: &DisjointMut<'_, BodyState>,
    ) {
        // SAFETY: the caller's promise.
        of_matrix!(self, matrix => unsafe { matrix.roll_back(component, memory, states) });
    }

    /// See [`Matrix::correct_poses`].
    pub fn correct_poses(
        &mut self,
        component: Component<'_>,
        memory: &Jacobians,
        substep: Real,
        displace: &mut impl FnMut(usize, [Real; SPATIAL_DIM]),
    ) {
        of_matrix!(self, matrix => matrix.correct_poses(component, memory, substep, displace));
    }

    /// See [`Matrix::progress`].
    pub fn progress(
        &self,
        rounds: usize,
        component: Component<'_>,
        memory: &Jacobians,
        inv_h: Real,
    ) -> Progress {
        of_matrix!(self, matrix => matrix.progress(rounds, component, memory, inv_h))
    }

    /// See [`Matrix::invalidate`].
    pub fn invalidate(&mut self) {
        of_matrix!(self, matrix => matrix.invalidate());
    }

    /// See [`Matrix::write_changes`].
    pub fn write_changes(&self, members: &[DirectJoint], memory: &mut Jacobians) {
        of_matrix!(self, matrix => matrix.write_changes(members, memory));
    }
}
