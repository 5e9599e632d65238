//! Free motion: the effect of inertia on the velocities while the links move.
//!
//! # Pieces
//! A substep of `h` seconds is divided into `n` equal pieces, so that no link rotates by more than
//! [`ANGLE_PER_PIECE_MAX`] in a piece. With the inertial forces `-C q̇` and the piece `p = h / n`:
//!
//! ```text
//! q̇½ = q̇ - ½ p M̃⁻¹ C(q, q̇½) q̇½        implicit: by fixed-point iteration
//! q  ← q + p q̇½
//! q̇  ← q̇½ - ½ p M̃⁻¹ C(q, q̇½) q̇½        explicit, at the new q
//! ```
//!
//! The two halves are each other's mirror image, so the integrator is reversible and of second order, and its
//! energy error is bounded. It is the generalised leapfrog (Hairer, Lubich, Wanner, "Geometric Numerical
//! Integration", 2006, chapter VI) in velocities. Contacts and limits act once a substep, on the `q̇½` of the
//! first piece.
//!
//! # Pieces without convergence
//! The fixed-point iteration contracts by the angle of half a piece times a ratio of inertias. The two are a
//! link's smallest inertia and the one that it carries about another axis. That ratio is forty for a chain of
//! thin limbs, and grows with the ratio of the masses. A substep whose first half does not converge gets more
//! pieces, [`PIECES_MAX`] at most. A piece that does not converge, or whose second half gains energy, is
//! *non-converged*. Each link then keeps its momentum while the links move, and the velocities are projected
//! on the joints afterwards:
//!
//! ```text
//! q̇  ← M⁻¹ Jᵀ p        p: momenta of the links before, J and M at the new q
//! ```
//!
//! The projection is orthogonal in the metric of the mass, so it takes energy and never gives any (Carnot's
//! theorem).
//!
//! # Energy budget
//! Free motion conserves the kinetic energy `T`. The leapfrog's error oscillates with the configuration;
//! impulses in between break that bound, and the corrections of the momentum (`centroidal.rs`) do as well.
//! [`Multibody::free_motion_error`] therefore sums the energy errors of all substeps, those of the work of
//! the forces among them. It stays within ±[`ERROR_MAX`] of the kinetic energy. An excess is removed from the
//! change of shape, so that linear and angular momentum are conserved. A deficit is dropped, so that energy
//! lost in a non-converged piece does not return later. Impulses that leave too much energy have a budget of
//! their own (`energy.rs`).

use super::super::kinematics::LinkFrame;
use super::super::spatial::ZERO;
use super::{LinkForce, Motion, add_all};
use crate::dim::math::{Real, Vector, ang_length_squared};
use crate::dim::spatial::{angular, linear};
use crate::model::multibody::Multibody;

/// Least and greatest number of iterations of the implicit half.
const ITERATIONS_MIN: usize = 3;
const ITERATIONS_MAX: usize = 8;
/// Largest change of a converged iteration, as a fraction of the first change.
const CONVERGED_FRACTION_MAX: Real = 1.0e-3;
/// The iteration diverges if it changes more than this fraction of the change before.
const CONTRACTION_MAX: Real = 0.5;
/// Least fraction of the velocities that a half without convergence may change.
const CHANGE_FRACTION_MIN: Real = 0.05;
/// The largest angle (rad) that a link rotates in a piece, up to [`PIECES_MAX`] pieces.
const ANGLE_PER_PIECE_MAX: Real = 0.1;
/// The largest number of pieces of a substep, which bounds the cost of a fast substep.
const PIECES_MAX: usize = 8;
/// A second half that leaves more than this multiple of the energy is not accepted.
const GAIN_MAX: Real = 1.1;
/// The bound of the energy budget, in both directions, as a fraction of the kinetic energy. At an angle `θ` a
/// piece, the leapfrog's energy oscillates by about `θ² / 8` for links of equal masses. It oscillates by
/// several percent if a light root carries links of a hundred times its mass.
pub(super) const ERROR_MAX: Real = 0.025;
/// Relative rounding errors of an energy and of a work.
const ENERGY_ROUNDING: Real = 4.0 * Real::EPSILON;
const WORK_ROUNDING: Real = 2.0 * Real::EPSILON;

/// Start of a substep's free motion.
struct FreeMotionStart {
    energy: Option<Real>,
    /// The power of the forces on the links.
    power: Real,
    /// See [`Motion::force_work`].
    work: Real,
    /// The root's centre of mass.
    root: Vector,
}

impl Motion {
    /// Chooses the number of pieces for a substep of `h` seconds and takes the first half of the first piece.
    pub(super) fn begin_free_motion(&mut self, h: Real, change: &mut Vec<Real>) {
        self.pieces = self.pieces_for(h);
        loop {
            self.has_diverged = !self.implicit_half_step(self.middle(h), change);
            if !self.has_diverged || self.pieces >= PIECES_MAX {
                return;
            }
            self.pieces = (2 * self.pieces).min(PIECES_MAX);
        }
    }

    /// The time (s) from the beginning of a substep of `h` seconds to the middle of its first piece.
    pub fn middle(&self, h: Real) -> Real {
        0.5 * h / self.pieces as Real
    }

    fn pieces_for(&mut self, h: Real) -> usize {
        let turn = |most: Real, v: &_| most.max(ang_length_squared(angular(v)));
        let fastest = self.link_velocities().iter().fold(0.0, turn).sqrt();
        // NaN and infinity become the nearest bound.
        ((fastest * h / ANGLE_PER_PIECE_MAX).ceil() as usize).clamp(1, PIECES_MAX)
    }

    /// Moves the links for `h` seconds, and updates their velocities to the substep's end. No link gets
    /// faster than `speed_max`. Before each piece `note` is called with its length (s). Returns the change of
    /// the kinetic energy.
    pub fn advance(
        &mut self,
        multibody: &mut Multibody,
        h: Real,
        speed_max: Real,
        mut note: impl FnMut(&mut Self, Real),
    ) -> Real {
        let begin = self.begin_budget(h);
        self.pieces = self.pieces.max(self.pieces_for(h));
        let piece = h / self.pieces as Real;
        let (mut has_diverged, mut energy) = (self.has_diverged, begin.energy);
        for k in 0..self.pieces {
            if k > 0 {
                energy = self.free_motion_energy();
                let mut change = core::mem::take(&mut self.change);
                has_diverged = !self.implicit_half_step(0.5 * piece, &mut change);
                self.change = change;
            }
            note(self, piece);
            self.advance_piece(multibody, [piece, h], has_diverged, energy);
        }
        let energy_change = self.close_energy_budget(multibody, h, &begin);
        self.limit_speed(speed_max);
        energy_change
    }

    /// Moves the links for a piece of a substep of `h` seconds, and takes the second half of the piece, which
    /// began with an energy.
    fn advance_piece(
        &mut self,
        multibody: &mut Multibody,
        [piece, h]: [Real; 2],
        has_diverged: bool,
        energy: Option<Real>,
    ) {
        let root_center = self.kinematics.links[0].center;
        self.note_momenta();
        let momenta = core::mem::take(&mut self.momenta);
        multibody.integrate(piece, &self.rates, &self.root);
        self.place(multibody);
        self.resist(h);
        let has_diverged = has_diverged || !self.explicit_half_step(0.5 * piece, energy);
        if has_diverged {
            self.resist(0.0);
            self.take_momenta(|id, _| Some(momenta[id]));
            self.resist(h);
        }
        self.momenta = momenta;
        self.keep_momentum(root_center);
        if has_diverged {
            self.has_diverged = true;
            self.limit_free_energy(energy);
            self.limit_joint_rates(h);
        }
    }

    /// Notes energy, power and places before a substep of `h` seconds, at the velocities from which the first
    /// half led to those that there are.
    fn begin_budget(&mut self, h: Real) -> FreeMotionStart {
        let now = self.copy_of_rates();
        if self.rates == self.half_rates {
            add_all(&mut self.rates, &self.first_half_change, -1.0);
        } else if !self.has_diverged {
            self.has_diverged = !self.undo_first_half(self.middle(h));
        }
        let (energy, power) = (self.free_motion_energy(), self.force_power());
        self.rates.copy_from_slice(&now);
        self.return_buffer(now);
        let (work, root) = (self.force_work(), self.kinematics.links[0].center);
        FreeMotionStart { energy, power, work, root }
    }

    /// Undoes the first half, of `h` seconds, after impulses have changed the velocities. Returns whether the
    /// first half would converge from there; if not, the velocities stay.
    ///
    /// The residual of the iteration in the first half is the same in this half. Otherwise the error would
    /// have the same sign in each substep.
    fn undo_first_half(&mut self, h: Real) -> bool {
        let [mut change, mut open] =
            [core::mem::take(&mut self.change), core::mem::take(&mut self.start)];
        core::mem::swap(&mut self.rates, &mut self.half_rates);
        self.inertial_kick(h, &mut open);
        add_all(&mut open, &self.first_half_change, -1.0);
        core::mem::swap(&mut self.rates, &mut self.half_rates);
        self.inertial_kick(h, &mut change);
        add_all(&mut self.rates, &change, -1.0);
        let size =
            |list: &[Real]| list.iter().fold(0.0, |most: Real, number| most.max(number.abs()));
        let mut converges = true;
        if size(&change) > CHANGE_FRACTION_MIN * size(&self.rates) {
            let mut next = self.copy_of_rates();
            self.inertial_kick(h, &mut next);
            add_all(&mut next, &change, -1.0);
            converges = size(&next) <= CONTRACTION_MAX * size(&change);
            self.return_buffer(next);
        }
        if converges {
            add_all(&mut self.rates, &open, 1.0);
        } else {
            add_all(&mut self.rates, &change, 1.0);
        }
        [self.change, self.start] = [change, open];
        converges
    }

    /// Records the energy error of a substep of `h` seconds, and removes the excess. Returns the change of
    /// the kinetic energy.
    fn close_energy_budget(
        &mut self,
        multibody: &mut Multibody,
        h: Real,
        begin: &FreeMotionStart,
    ) -> Real {
        let (Some(before), Some(now)) = (begin.energy, self.free_motion_energy()) else {
            return 0.0;
        };
        let kicks = 0.5 * h * (begin.power + self.force_power());
        let root_shift = self.kinematics.links[0].center - begin.root;
        let work = self.force_work() - begin.work + self.force_sum().dot(root_shift);
        let corrected = core::mem::take(&mut self.corrected);
        let rounding = self.work_rounding() + ENERGY_ROUNDING * now;
        let band = ERROR_MAX * now + rounding;
        let known = multibody.free_motion_error.max(-band).min(band);
        let error = known + corrected + (now - before) + (kicks - work);
        let energy_gain = (error - band).max(0.0);
        if energy_gain > 0.0 {
            self.limit_free_energy(Some((now - energy_gain).max(0.0)));
        }
        let rest = (error - energy_gain).max(-band);
        multibody.free_motion_error = if rest.is_finite() { rest } else { 0.0 };
        now - before - energy_gain
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

    /// Computes the velocity changes by the inertial forces `-C q̇` in `h` seconds.
    fn inertial_kick(&mut self, h: Real, change: &mut Vec<Real>) {
        let Self { kinematics, velocities, accelerations, wrenches, .. } = self;
        kinematics.velocities(&self.rates, &self.root, velocities);
        kinematics.inertial_wrenches(&self.rates, velocities, accelerations, wrenches);
        change.clear();
        change.resize(self.rates.len(), 0.0);
        self.factor.solve(kinematics, wrenches, change);
        change.iter_mut().for_each(|number| *number *= h);
    }

    /// Integrates inertia for `h` seconds, explicitly. Returns whether the energy is conserved; the
    /// velocities stay if not.
    fn explicit_half_step(&mut self, h: Real, energy: Option<Real>) -> bool {
        let mut change = core::mem::take(&mut self.change);
        self.inertial_kick(h, &mut change);
        add_all(&mut self.rates, &change, 1.0);
        let is_kept = match (self.free_motion_energy(), energy) {
            (Some(now), Some(before)) => now <= GAIN_MAX * before,
            _ => true,
        };
        if !is_kept {
            add_all(&mut self.rates, &change, -1.0);
        }
        self.change = change;
        is_kept
    }

    /// Moves the links for `h` seconds, which may be negative, at these rates. Velocities stay.
    pub fn displace(&mut self, multibody: &mut Multibody, rates: &[Real], h: Real) {
        let root_center = self.kinematics.links[0].center;
        multibody.integrate(h, rates, &ZERO);
        self.place(multibody);
        self.carry_momentum(root_center);
    }

    /// Reverses the velocity change by inertia in the last `h` seconds.
    pub fn undo_inertial_kick(&mut self, h: Real) {
        let mut change = core::mem::take(&mut self.change);
        self.inertial_kick(h, &mut change);
        add_all(&mut self.rates, &change, -1.0);
        self.change = change;
    }

    /// Integrates inertia for `h` seconds, implicitly as [`Self::accelerate`] does. Returns whether the
    /// iteration converges; the velocities stay if not.
    pub fn implicit_inertial_kick(&mut self, h: Real) -> bool {
        let mut change = core::mem::take(&mut self.change);
        let converges = self.implicit_half_step(h, &mut change);
        self.change = change;
        converges
    }

    /// The velocities before the first half of the free motion, in a buffer that [`Self::return_buffer`]
    /// takes back.
    pub fn rates_before_free_motion(&mut self) -> Vec<Real> {
        let mut rates = self.copy_of_rates();
        add_all(&mut rates, &self.first_half_change, -1.0);
        rates
    }

    /// Integrates inertia for `h` seconds with the velocities of their end, and stores the change. Returns
    /// whether the iteration converges; the velocities stay if not.
    fn implicit_half_step(&mut self, h: Real, change: &mut Vec<Real>) -> bool {
        let mut start = core::mem::take(&mut self.start);
        start.clone_from(&self.rates);
        let converges = self.fixed_point_iteration(&start, h, change);
        if !converges {
            self.rates.copy_from_slice(&start);
        }
        self.start = start;
        converges
    }

    /// Returns whether the iteration converges. The velocities are those of the last iteration.
    fn fixed_point_iteration(&mut self, start: &[Real], h: Real, change: &mut Vec<Real>) -> bool {
        // A residual below rounding is accepted.
        let fastest = start.iter().fold(0.0, |most: Real, rate| most.max(rate.abs()));
        let rounding = 16.0 * Real::EPSILON * fastest;
        let (mut first, mut moved) = (0.0, Real::MAX);
        for iteration in 1..=ITERATIONS_MAX {
            self.inertial_kick(h, change);
            let news =
                |((rate, start), change): ((&Real, &Real), &Real)| (start + change - rate).abs();
            let next = self.rates.iter().zip(start).zip(&*change).map(news).fold(0.0, Real::max);
            self.rates.copy_from_slice(start);
            add_all(&mut self.rates, change, 1.0);
            if iteration == 1 {
                first = next;
            }
            if next <= rounding
                || (iteration >= ITERATIONS_MIN && next <= CONVERGED_FRACTION_MAX * first)
            {
                return true;
            }
            // A comparison with NaN is false, so NaN does not converge.
            let comes_nearer = next <= CONTRACTION_MAX * moved;
            if !comes_nearer {
                return false;
            }
            moved = next;
        }
        false
    }
}
