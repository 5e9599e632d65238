//! The momentum of a multibody, which nothing inside it changes.
//!
//! Internal forces of a multibody conserve its linear and angular momentum. The error of free motion changes
//! them, in third order, and so do external impulses, whose responses are frozen during a step. The momentum
//! is therefore integrated beside the velocities. It changes by gravity, forces and impulses alone, and the
//! [`LockedInertia`](super::super::locked_inertia::LockedInertia) corrects the velocities. Freely tumbling
//! chains do not drift, and contacts conserve momentum.
//!
//! Contact impulses after the free motion leave a momentum that is corrected at the beginning of the next
//! substep. The energy of that correction belongs to the entry of the next substep in the ledger of energy
//! (`ledger.rs`).
//!
//! The momentum is that about the root's centre of mass, wherever that moves. The moment arm of an impulse
//! moves along: the contact of a ball is below the ball also when this has rolled on. (With the arm of the
//! start of the step, the ball would rotate by its weight times its displacement.)

use super::super::kinematics::LinkFrame;
use super::super::spatial::{ZERO, add_scaled, carry_back};
use super::{Motion, add_all};
use crate::dim::math::{Real, SpatialVector, Vector};

impl Motion {
    /// Records an external impulse that the rates already contain, as the impulses on the root's degrees of
    /// freedom.
    pub fn note_external_impulse(&mut self, impulses: &[Real], factor: Real) {
        for (axis, impulse) in self.kinematics.axes.iter().zip(impulses) {
            add_scaled(&mut self.external_impulse, axis, impulse * factor);
        }
    }

    /// Records that an impact has changed the rates.
    pub fn note_impact(&mut self) {
        self.ledger.is_hit = true;
    }

    /// The noted external impulses that are not applied yet.
    pub fn external_impulse(&self) -> SpatialVector {
        self.external_impulse
    }

    /// Scales the external impulses since these by a fraction.
    pub fn scale_external_impulse(&mut self, since: &SpatialVector, fraction: Real) {
        for (now, since) in self.external_impulse.iter_mut().zip(since) {
            *now = since + (*now - since) * fraction;
        }
    }

    /// Begins to follow the momentum.
    pub(super) fn follow_momentum(&mut self) {
        self.ledger.is_hit |= self.external_impulse != ZERO;
        (self.momentum, self.external_impulse) = (self.root_momentum(), ZERO);
    }

    /// Adds the motion of the locked body that corrects the missing momentum. It referred to `before`, and
    /// refers to the root's centre of mass from now on. Returns the energy that this took: with the change
    /// `δ` of the rates and the momentum `p` before it, `δᵀ Sᵀ (p + ½ missing)`.
    pub(super) fn keep_momentum(&mut self, before: Vector) -> Real {
        if self.root_dofs() == 0 {
            return 0.0;
        }
        self.carry_momentum(before);
        let now = self.root_momentum();
        let mut missing = self.momentum;
        add_scaled(&mut missing, &now, -1.0);
        let correction = self.locked_inertia.correction(&missing);
        let mut mean = now;
        add_scaled(&mut mean, &missing, 0.5);
        let mut energy = 0.0;
        for (own, &axis) in self.rates.iter_mut().zip(&self.kinematics.root_axes) {
            energy += mean[axis] * correction[axis];
            *own += correction[axis];
        }
        energy
    }

    /// Changes the reference point of the momentum, and of the external impulses, from `before` to the root's
    /// centre of mass.
    pub(super) fn carry_momentum(&mut self, before: Vector) {
        self.ledger.is_hit |= self.external_impulse != ZERO;
        add_scaled(&mut self.momentum, &self.external_impulse, 1.0);
        self.momentum = carry_back(&self.momentum, before - self.kinematics.links[0].center);
        self.external_impulse = ZERO;
    }

    /// The momentum of all links together, about the root's centre of mass.
    pub(super) fn root_momentum(&mut self) -> SpatialVector {
        self.note_momenta();
        let Self { kinematics, momenta, .. } = self;
        for (id, link) in kinematics.links.iter().enumerate().rev() {
            let Some(parent) = link.parent else { continue };
            let felt = carry_back(&momenta[id], link.offset);
            add_scaled(&mut momenta[parent], &felt, 1.0);
        }
        momenta[0]
    }

    /// The momenta of the links.
    pub fn link_momenta(&mut self) -> Vec<SpatialVector> {
        self.note_momenta();
        self.momenta.clone()
    }

    /// Notes the momenta of the links.
    pub(super) fn note_momenta(&mut self) {
        self.update_velocities();
        let Self { kinematics, velocities, momenta, .. } = self;
        momenta.clear();
        let links = kinematics.links.iter().zip(velocities);
        momenta.extend(links.map(|(link, velocity)| link.momentum(velocity)));
    }

    /// Changes the velocities to those at which, for each degree of freedom, the links have these momenta;
    /// `None`: the momentum that the link has.
    pub fn take_momenta(&mut self, of: impl Fn(usize, &LinkFrame) -> Option<SpatialVector>) {
        self.update_velocities();
        self.wrenches.clear();
        for (id, link) in self.kinematics.links.iter().enumerate() {
            let missing = of(id, link).map_or(ZERO, |mut missing| {
                add_scaled(&mut missing, &link.momentum(&self.velocities[id]), -1.0);
                missing
            });
            self.wrenches.push(missing);
        }
        let mut change = core::mem::take(&mut self.change);
        change.clear();
        change.resize(self.rates.len(), 0.0);
        self.factor.solve(&self.kinematics, &self.wrenches, &mut change);
        add_all(&mut self.rates, &change, 1.0);
        self.change = change;
    }
}
