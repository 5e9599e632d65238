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
//! The leapfrog's energy error oscillates with the configuration. Impulses in between break that bound, and
//! the corrections of the momentum (`centroidal.rs`) do as well: see `ledger.rs`.

use super::super::spatial::ZERO;
use super::{Motion, add_all};
use crate::dim::math::{Real, ang_length_squared};
use crate::dim::spatial::angular;
use crate::model::multibody::Multibody;

/// Greatest number of iterations of the implicit half.
const ITERATIONS_MAX: usize = 8;
/// Largest residual of a converged iteration, as a fraction of the change of the half.
const CONVERGED_FRACTION_MAX: Real = 1.0e-3;
/// The iteration diverges if it changes more than this fraction of the change before.
const CONTRACTION_MAX: Real = 0.5;
/// The largest angle (rad) that a link rotates in a piece, up to [`PIECES_MAX`] pieces.
const ANGLE_PER_PIECE_MAX: Real = 0.1;
/// The largest number of pieces of a substep, which bounds the cost of a fast substep.
const PIECES_MAX: usize = 8;
/// A second half that leaves more than this multiple of the energy is not accepted.
const GAIN_MAX: Real = 1.1;

impl Motion {
    /// Takes the first half of the first piece of a substep of `h` seconds. If it does not converge, the
    /// substep gets more pieces.
    pub(super) fn begin_free_motion(&mut self, h: Real, change: &mut Vec<Real>) {
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
        debug_assert!((1..=PIECES_MAX).contains(&self.pieces));
        0.5 * h / self.pieces as Real
    }

    pub(super) fn pieces_for(&mut self, h: Real) -> usize {
        let turn = |most: Real, v: &_| most.max(ang_length_squared(angular(v)));
        self.fastest_turn = self.link_velocities().iter().fold(0.0, turn).sqrt();
        // NaN and infinity become the nearest bound.
        ((self.fastest_turn * h / ANGLE_PER_PIECE_MAX).ceil() as usize).clamp(1, PIECES_MAX)
    }

    /// Moves the links for `h` seconds, and updates their velocities to the substep's end. No link gets
    /// faster than `speed_max`. Before each piece `note` is called with its length (s).
    pub fn advance(
        &mut self,
        multibody: &mut Multibody,
        h: Real,
        speed_max: Real,
        mut note: impl FnMut(&mut Self, Real),
    ) {
        self.pieces = self.pieces.max(self.pieces_for(h));
        let piece = h / self.pieces as Real;
        let mut has_diverged = self.has_diverged;
        let mut energy = self.free_motion_energy();
        let mut energy_max = energy.zip(self.ledger.before).map(|(now, it)| now.max(it.in_frame));
        for k in 0..self.pieces {
            if k > 0 {
                energy_max = self.free_motion_energy();
                let mut change = core::mem::take(&mut self.change);
                has_diverged = !self.implicit_half_step(0.5 * piece, &mut change);
                self.change = change;
                energy = self.free_motion_energy();
            }
            note(self, piece);
            let has_kept = self.advance_piece(multibody, [piece, h], has_diverged, energy_max);
            if !has_kept {
                self.has_diverged = true;
                self.limit_free_energy(energy);
                self.limit_joint_rates(h);
            }
        }
        self.limit_speed(speed_max);
    }

    /// Moves the links for a piece of a substep of `h` seconds, and takes the second half of the piece.
    /// Returns whether the piece has converged, with an energy of the same size as before.
    fn advance_piece(
        &mut self,
        multibody: &mut Multibody,
        [piece, h]: [Real; 2],
        has_diverged: bool,
        energy_max: Option<Real>,
    ) -> bool {
        let root_center = self.kinematics.links[0].center;
        self.note_momenta();
        let momenta = core::mem::take(&mut self.momenta);
        multibody.integrate(piece, &self.rates, &self.root);
        self.place(multibody);
        self.resist(h);
        let has_converged = !has_diverged && self.explicit_half_step(0.5 * piece, energy_max);
        if !has_converged {
            self.resist(0.0);
            self.take_momenta(|id, _| Some(momenta[id]));
            self.resist(h);
        }
        self.momenta = momenta;
        self.keep_momentum(root_center);
        has_converged
    }

    /// Computes the velocity changes by the inertial forces `-C q̇` in `h` seconds.
    fn inertial_kick(&mut self, h: Real, change: &mut Vec<Real>) {
        self.update_velocities();
        let Self { kinematics, velocities, accelerations, wrenches, .. } = self;
        kinematics.inertial_wrenches(&self.rates, velocities, accelerations, wrenches);
        change.clear();
        change.resize(self.rates.len(), 0.0);
        self.factor.solve(kinematics, wrenches, change);
        change.iter_mut().for_each(|number| *number *= h);
    }

    /// Integrates inertia for `h` seconds, explicitly. Returns whether the energy is conserved; the
    /// velocities stay if not.
    fn explicit_half_step(&mut self, h: Real, energy_max: Option<Real>) -> bool {
        let (mut change, _) = core::mem::take(&mut self.last_kick);
        self.inertial_kick(h, &mut change);
        add_all(&mut self.rates, &change, 1.0);
        let is_kept = match (self.free_motion_energy(), energy_max) {
            (Some(now), Some(energy_max)) => now <= GAIN_MAX * energy_max,
            _ => true,
        };
        if !is_kept {
            add_all(&mut self.rates, &change, -1.0);
        }
        self.last_kick = (change, h);
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
        let start = self.copy_of_rates();
        let converges = self.fixed_point_iteration(&start, h, change);
        if !converges {
            self.rates.copy_from_slice(&start);
        }
        self.return_buffer(start);
        converges
    }

    /// Returns whether the iteration converges. The velocities are those of the last iteration. It begins
    /// with the change by the last second half, which in most cases was at the same poses.
    fn fixed_point_iteration(&mut self, start: &[Real], h: Real, change: &mut Vec<Real>) -> bool {
        let size =
            |list: &[Real]| list.iter().fold(0.0, |most: Real, number| most.max(number.abs()));
        // A residual below rounding is accepted.
        let rounding = 16.0 * Real::EPSILON * size(start);
        let (kick, length) = &self.last_kick;
        if *length > 0.0 && !self.has_diverged {
            add_all(&mut self.rates, kick, h / length);
        }
        let mut moved = Real::MAX;
        for _ in 1..=ITERATIONS_MAX {
            self.inertial_kick(h, change);
            let news =
                |((rate, start), change): ((&Real, &Real), &Real)| (start + change - rate).abs();
            let next = self.rates.iter().zip(start).zip(&*change).map(news).fold(0.0, Real::max);
            self.rates.copy_from_slice(start);
            add_all(&mut self.rates, change, 1.0);
            if !self.rates.iter().all(|rate| rate.is_finite()) {
                return false;
            }
            if next <= rounding.max(CONVERGED_FRACTION_MAX * size(change)) {
                return true;
            }
            if next > CONTRACTION_MAX * moved {
                return false;
            }
            moved = next;
        }
        false
    }
}
