//! The ledger of a multibody's energy.
//!
//! Free motion conserves the kinetic energy `T`. Impulses of limits, dry friction, loops, and contacts with
//! bodies at rest do not increase it. Numerically all of them may: free motion is integrated in steps, the
//! rows of limits and contacts are those of an earlier pose, and the momentum is corrected afterwards
//! (`centroidal.rs`). One entry per substep adds up all of these errors:
//!
//! ```text
//! gain = T(end) - T(after forces) + energy of corrections of the momentum - work
//! ```
//!
//! The *work* is that of what drives the links: motors with a largest force, loops, moving bodies and
//! surfaces, and impacts that may add energy. Forces, springs, dampers and other motors have done theirs
//! before. Without impulses, the error of the work of forces is part of the gain: the mean of their power at
//! both ends times `h`, minus force times displacement.
//!
//! No entry raises the balance above [`ERROR_MAX`] of `T`, for which the leapfrog's error oscillates
//! (`free.rs`): the rest of the gain is removed from the velocities. A balance below -[`ERROR_MAX`] of `T` is
//! raised to that, so that energy lost in a non-converged piece does not return later. An entry with impulses
//! does not lower a negative balance, so that the energy that they take does not return either.
//!
//! ## Frame of reference
//! `T` is measured in the frame of the centre of mass at the start of the substep, at the velocity `V`. A
//! chain that is thrown at 100 m/s has an energy whose rounding exceeds that of its change of shape. In the
//! frame at rest the gain is larger by `V · ΔP`, with the change `ΔP` of the momentum. Without impulses that
//! is rounding, and is left out.
//!
//! Why there is one ledger for all errors: `docs/decisions/0028-one-ledger-of-energy.md`.

use super::super::kinematics::LinkFrame;
use super::super::spatial::ZERO;
use super::{LinkForce, Motion};
use crate::dim::math::{Real, Vector};
use crate::dim::spatial::linear;
use crate::model::multibody::Multibody;

/// The bound of the balance, in both directions, as a fraction of the kinetic energy. At an angle `θ` a
/// piece, the leapfrog's energy oscillates by about `θ² / 8` for links of equal masses. It oscillates by
/// several percent if a light root carries links of a hundred times its mass.
const ERROR_MAX: Real = 0.025;
/// Relative rounding errors of an energy and of a work.
const ENERGY_ROUNDING: Real = 4.0 * Real::EPSILON;
const WORK_ROUNDING: Real = 2.0 * Real::EPSILON;

/// The entry of a substep. What is "before" is after forces, and before impulses and free motion.
#[derive(Copy, Clone, Debug, Default)]
pub(super) struct Ledger {
    /// The length of the substep (s).
    h: Real,
    /// The velocity of the frame of reference.
    frame: Vector,
    /// The kinetic energy before, in the frame and at rest; `None` if something drives the links that no
    /// entry includes.
    pub before: Option<Energies>,
    /// The linear momentum before.
    momentum: Vector,
    /// The power and the work of forces before: see [`Motion::force_work`].
    forces: [Real; 2],
    /// The root's centre of mass before.
    root: Vector,
    /// Energy of corrections of the momentum since the last entry.
    pub corrected: Real,
    /// Whether impulses of impacts or from outside have acted since.
    pub is_hit: bool,
    /// The gain beyond the bound of the balance, and the energy that may be added to that before.
    excess: Real,
    allowance: Real,
}

/// The kinetic energy in the frame of a ledger, and in the frame at rest.
#[derive(Copy, Clone, Debug, Default)]
pub(super) struct Energies {
    pub in_frame: Real,
    pub at_rest: Real,
}

impl Motion {
    /// Begins the entry of a substep of `h` seconds at the velocities that forces have led to.
    pub(super) fn open_ledger(&mut self, h: Real) {
        let in_frame = self.free_motion_energy();
        let (frame, momentum) = (self.frame_velocity(), self.linear_momentum());
        let of_frame = frame.dot(momentum - frame * (0.5 * self.mass()));
        self.ledger = Ledger {
            h,
            frame,
            before: in_frame.map(|in_frame| Energies { in_frame, at_rest: in_frame + of_frame }),
            momentum,
            forces: [self.force_power(), self.force_work()],
            root: self.kinematics.links[0].center,
            corrected: self.ledger.corrected,
            ..Ledger::default()
        };
    }

    /// Ends the entry: adds the gain of the substep, in which impulses may have acted (`is_pushed`), to the
    /// balance. Returns whether the balance stays within its bound.
    pub fn settle(&mut self, multibody: &mut Multibody, is_pushed: bool, work: Real) -> bool {
        let corrected = core::mem::take(&mut self.ledger.corrected);
        let Ledger { frame, before: Some(before), momentum, .. } = self.ledger else { return true };
        self.update_velocities();
        self.ledger.is_hit |= self.external_impulse != ZERO;
        let is_pushed = is_pushed || self.ledger.is_hit;
        let has_new_momentum = is_pushed && self.root_dofs() > 0;
        let now = self.energy_seen_from(frame);
        let mut change = now - before.in_frame;
        if has_new_momentum {
            change += frame.dot(self.linear_momentum() - momentum);
        }
        let of_forces = if is_pushed { 0.0 } else { self.force_error() };
        let explained = work - corrected - of_forces;
        let size = if has_new_momentum { before.at_rest } else { before.in_frame };
        let band = ERROR_MAX * now.min(size) + ENERGY_ROUNDING * size + self.work_rounding();
        let known = multibody.energy_error.max(-band);
        let bound = band.max(known);
        let least = if is_pushed { known.min(0.0) } else { -band };
        let balance = known + (change - explained);
        self.ledger.excess = balance - bound;
        self.ledger.allowance = bound - known + explained;
        multibody.energy_error =
            if balance.is_finite() { balance.max(least).min(bound) } else { 0.0 };
        // NaN is none.
        let exceeds = self.ledger.excess > 0.0;
        !exceeds
    }

    /// Removes the gain beyond the bound of the balance. Returns the fraction of the impulses with which the
    /// next substep should start.
    pub fn remove_excess(&mut self, touches: bool) -> Real {
        let Ledger { before: Some(before), is_hit, excess, allowance, .. } = self.ledger else {
            return 1.0;
        };
        let kept = if is_hit && self.root_dofs() > 0 {
            self.limit_energy(before.at_rest + allowance, touches)
        } else {
            self.keep_momentum(self.kinematics.links[0].center);
            let energy_max = (before.in_frame + allowance).max(0.0);
            self.limit_free_energy(Some(energy_max));
            energy_max / (energy_max + excess)
        };
        // At rest all velocities are errors, but the impulses are not.
        kept.max(1.0 - excess / before.at_rest).min(1.0)
    }

    /// The linear momentum of all links at their last velocities.
    fn linear_momentum(&self) -> Vector {
        let links = self.kinematics.links.iter().zip(&self.velocities);
        links.map(|(link, velocity)| linear(velocity) * link.mass).sum()
    }

    /// The error of the work of forces in the substep.
    fn force_error(&mut self) -> Real {
        let Ledger { h, forces: [power, work], root, .. } = self.ledger;
        let shift = self.kinematics.links[0].center - root;
        let work = self.force_work() - work + self.force_sum().dot(shift);
        0.5 * h * (power + self.force_power()) - work
    }

    /// The power of the forces on the links.
    fn force_power(&mut self) -> Real {
        self.update_velocities();
        let links = self.forces.iter().zip(&self.velocities);
        links.map(|(force, velocity)| linear(&force.wrench).dot(linear(velocity))).sum()
    }

    /// The work of the forces on the links if these moved here from the root's centre of mass.
    fn force_work(&self) -> Real {
        let links = self.forces.iter().zip(&self.kinematics.links);
        let root = self.kinematics.links[0].center;
        links.map(|(force, link)| linear(&force.wrench).dot(link.center - root)).sum()
    }

    /// The sum of the forces on the links.
    fn force_sum(&self) -> Vector {
        self.forces.iter().map(|force| linear(&force.wrench)).sum()
    }

    /// Rounding error of [`Self::force_work`] and of the work at the root (J).
    fn work_rounding(&self) -> Real {
        let root = self.kinematics.links[0].center;
        let links = self.forces.iter().zip(&self.kinematics.links);
        let of = |(force, link): (&LinkForce, &LinkFrame)| {
            linear(&force.wrench).length() * ((link.center - root).length() + root.length())
        };
        WORK_ROUNDING * links.map(of).sum::<Real>()
    }
}
