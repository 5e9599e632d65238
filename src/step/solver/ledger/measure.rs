//! The terms of the energy, body by body.

use super::account::Terms;
use crate::base::wide::{Kernel, LANES, Lane, Wide};
use crate::dim::rotation_vector::turned_inertia;
use crate::dim::state::BodyState;
use crate::dim::wide::{
    WideSymmetric, WideVector, ZERO_INERTIA, ang_dot, load_symmetric, mul_inertia,
};
use crate::step::solver::states::load_states;

/// Mass and inertia of [`LANES`] adjacent bodies when the step began, and the frames of their islands.
#[derive(Copy, Clone, Debug)]
pub struct Masses {
    pub mass: Lane,
    /// The velocities of their islands' frames.
    pub frame: WideVector<Lane>,
    pub inertia: WideSymmetric<Lane>,
    /// Whether any of them belongs to an open account.
    pub is_open: bool,
}

impl Masses {
    /// No bodies.
    pub const NONE: Self =
        Self { mass: Lane::ZERO, frame: WideVector::ZERO, inertia: ZERO_INERTIA, is_open: false };
}

/// Computes the terms of bodies, with their inertias at the present poses.
pub struct Measure<'a> {
    pub masses: &'a [Masses],
    pub states: &'a [BodyState],
    pub before: &'a [BodyState],
    pub terms: &'a mut [Terms<Lane>],
}

impl Kernel for Measure<'_> {
    type Output = ();

    #[inline(always)]
    fn run<W: Wide>(self) {
        let states = self.states.chunks(LANES).zip(self.before.chunks(LANES));
        let all = self.masses.iter().zip(self.terms).zip(states);
        for ((masses, terms), (states, before)) in all.filter(|((it, _), _)| it.is_open) {
            let ((now, moved), (old, _)) = (load_states::<W>(states), load_states::<W>(before));
            let change = now - old;
            let old_linear = old.linear - WideVector::load(&masses.frame);
            let inertia = turned_inertia(load_symmetric(&masses.inertia), moved.rotation());
            let mass = W::load(&masses.mass);
            let (p, l) = (change.linear * mass, mul_inertia(inertia, change.angular));
            let own = mul_inertia(inertia, old.angular);
            let t = old_linear.dot(old_linear) * mass + ang_dot(old.angular, own);
            (t * W::splat(0.5)).store(&mut terms[0]);
            (old_linear.dot(p) + ang_dot(old.angular, l)).store(&mut terms[1]);
            (change.linear.dot(p) + ang_dot(change.angular, l)).store(&mut terms[2]);
            terms[3] = masses.mass;
        }
    }
}
