//! Velocities that correct large errors of joints while the bodies move.
//!
//! Errors are corrected by the velocities of the solve pass. The relax pass removes what is left of them along
//! the locked axes. What is left along the free ones is energy from nothing: a hinge whose anchor was moved
//! by two metres kept 1,400 J in 1 kg. Contacts would pass them on, too. So the velocities of this file exist
//! during the integration of the positions, and no longer. They correct
//!
//! * errors of joints that a program made or edited, or moved a body of: those are no results of motions;
//! * the excess over limits, which is that of a load: heavy boxes jumped on ropes.
//!
//! They are a Newton step towards the poses without errors, and a step is linear: a light link that has to
//! turn by several radians in it ends anywhere. So it ends where a body has turned by [`TURN_MAX`], and the
//! next substep takes another one. Between a post and a heavy ball, the step still turns light links where it
//! should lift the ball: a chain that hits a wall opens by half a metre, and remained open. Errors by
//! motion, and errors of components with large mass ratios, are therefore left to the velocities.

use super::driven::add_changes;
use super::jacobians::{Motion, locked_axes};
use super::matrix::Matrix;
use super::memory::Jacobians;
use super::pattern::Component;
use crate::base::disjoint::DisjointMut;
use crate::dim::math::{DIM, Real, SPATIAL_DIM};
use crate::dim::state::BodyState;

/// Largest angle (rad) by which a correction turns a body in a substep.
const TURN_MAX: f64 = 0.5;

impl<const N: usize> Matrix<N> {
    /// Finds the velocities that correct the errors in a substep of this length, and adds them to the bodies.
    ///
    /// # Safety
    /// As [`Self::solve`].
    pub unsafe fn add_corrections(
        &mut self,
        component: Component<'_>,
        memory: &Jacobians,
        states: &DisjointMut<'_, BodyState>,
        substep: Real,
    ) {
        for (member, x) in component.members.iter().zip(&mut self.x) {
            let (from, lane) = (&memory.blocks[member.block as usize], member.lane as usize);
            *x = [0.0; N];
            let axes = locked_axes::<N>(member).filter(|_| from.is_displaced.0[lane] > 0.0);
            for (x, axis) in x.iter_mut().zip(axes) {
                *x = -f64::from(from.corrections[axis].0[lane]);
            }
        }
        for driven in &self.driven {
            let [at, row] = driven.at;
            self.x[at][row] = driven.correction();
        }
        self.substitute(component);
        let turn = self.largest_spin(component) * f64::from(substep);
        if turn > TURN_MAX {
            self.x.iter_mut().flatten().for_each(|change| *change *= TURN_MAX / turn);
        }
        // SAFETY: the caller's promise.
        unsafe { self.push_bodies(component, states) };
    }

    /// Takes the velocities of [`Self::add_corrections`] from the bodies.
    ///
    /// # Safety
    /// As [`Self::solve`].
    pub unsafe fn remove_corrections(
        &mut self,
        component: Component<'_>,
        states: &DisjointMut<'_, BodyState>,
    ) {
        self.x.iter_mut().flatten().for_each(|change| *change = -*change);
        // SAFETY: the caller's promise.
        unsafe { self.push_bodies(component, states) };
    }

    /// The largest angular velocity that the solution gives to a body.
    fn largest_spin(&mut self, component: Component<'_>) -> f64 {
        self.changes.clear();
        self.changes.resize(component.body_count, [0.0; SPATIAL_DIM]);
        for (at, (rows, x)) in self.rows.iter().zip(&self.x).enumerate() {
            add_changes(component, rows, at, x, &mut self.changes);
        }
        let spin = |change: &Motion| change[DIM..].iter().map(|value| value * value).sum::<f64>();
        self.changes.iter().map(spin).fold(0.0, f64::max).sqrt()
    }
}
