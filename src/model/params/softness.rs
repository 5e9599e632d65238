//! Soft constraints: from the fraction of the error per substep to the solver's coefficients.
//!
//! Source: Catto, "Soft Constraints" (2011), and "Solver2D" (2024), whose *soft step* method the solver uses.
//! Two details differ: the parameters are fractions per substep instead of frequency and damping, and fixed
//! and moving partners get the same softness.
//!
//! # Derivation
//!
//! Symbols: `C` position error (negative: overlap), `v = Ċ` its rate, `m` effective mass of the constraint,
//! `h` length of the substep, `λ` impulse accumulated over it.
//!
//! A spring of stiffness `k` and damper `c` in place of the hard constraint, integrated implicitly, has the
//! impulse `λ = -h (k (C + h v) + c v)`. Solved for the velocity:
//!
//! ```text
//! v + (β/h) C + (σ/m) λ = 0      with   β = h k / (c + h k)   and   σ = m / (h (c + h k))
//! ```
//!
//! All of it is two numbers without a unit. A substep aims to remove the fraction `β` of the error.
//! The *compliance* `σ` is the relative motion under load. An impulse that would change the free relative
//! velocity by `λ/m` moves the constraint at `σ` times that. The impulse that satisfies the equation, given
//! the `λ` so far:
//!
//! ```text
//! Δλ = -m · mass_scale · (v + bias_rate · C) - impulse_scale · λ
//! bias_rate = β/h      mass_scale = 1/(1 + σ)      impulse_scale = σ/(1 + σ)
//! ```
//!
//! # Frequency and damping
//!
//! With `k = m ω²`, `c = 2 m ζ ω`:
//!
//! ```text
//! β = h ω / (2 ζ + h ω)        σ = 1 / (h ω (2 ζ + h ω))
//! h ω = √(β/σ)                 ζ = (1 - β) / (2 √(σ β))
//! ```
//!
//! The default contact (`β` = 0.07, `σ` = 1/16) at 240 substeps a second is a spring of 40 Hz with 7 times
//! the critical damping. Under a load of `g` a resting body sinks in by `g/ω²` = `σ g h² / β`.
//!
//! # Limits
//!
//! * `σ = 0`: a hard constraint, `mass_scale` 1 and `impulse_scale` 0; only the fraction `β` is left. It is
//!   sensitive to unfinished iterations. One iteration over a light stack under a weight of a hundred times
//!   its mass adds energy until the stack explodes.
//! * A compliance that ends at some load (`impulse_scale · λ` with a bound) would let a tall stack sag like a
//!   low one. Beyond the bound the contact is hard, with the same result: ten cubes tremble with 1.6 J/kg
//!   instead of 10⁻⁴ with a bound of four times the weight of one, and thirty fall.
//! * `β = 0`: no position correction, a pure damper if `σ > 0`.
//! * `β = 1`: the whole error at once.
//! * `σ → ∞`: `mass_scale` goes to 0 as `1/σ`, so the constraint gets weak but never goes away.
//! * `h = 0`: nothing moves, so nothing is corrected: `bias_rate` 0.

use crate::dim::math::Real;

/// The compliance of a contact without user-defined softness.
///
/// Box2D's contacts (30 Hz, damping ratio 10) have a compliance of 0.061 at 240 substeps a second. A model of
/// columns of boxes under 100-fold loads, at 30 to 240 steps a second, gives the range. Values up to 1/50
/// left stacks of 30 boxes trembling, and values from 1/5 let them sag ten times the allowed error. Between
/// 1/25 and 1/12 both are small.
pub const CONTACT_COMPLIANCE: Real = 1.0 / 16.0;

/// Factor on [`erp`](super::IntegrationParameters::erp). The product is the fraction of a contact's overlap
/// that a substep aims to remove.
///
/// The factor is less than one because an iteration over a pile of contacts does not converge. The
/// correction of one contact is an error of its neighbours in the next substep. If these corrections are
/// large enough, the pile as a whole gains energy. A pyramid of a hundred rows that is kept awake has,
/// after 1,500 steps, up to this kinetic energy (J) with `σ` = 1/16:
///
/// ```text
/// β     0.0378  0.05   0.06   0.07   0.08   0.09   0.10
/// J     0.05    0.06   0.2    0.3    1.6    13     27
/// ```
///
/// Less compliance does not help (`β` = 0.07 and `σ` = 0.044 falls over), and a smaller fraction lets piles
/// sag and collapses under heavy tops.
pub const CONTACT_ERP_SCALE: Real = 0.7;

/// Factor on [`joint_erp`](super::IntegrationParameters::joint_erp). The product, limited to 1, is the
/// fraction of a joint's error that a substep aims to remove.
pub const JOINT_ERP_SCALE: Real = 2.0;

/// The three coefficients with which the solver softens a constraint. The source of this module contains the
/// derivation.
///
/// Each iteration adds the impulse `-m · mass_scale · (v + bias_rate · C) - impulse_scale · λ` to the
/// accumulated impulse `λ`. `m` is the effective mass, `v` the relative velocity and `C` the position error.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct Softness {
    /// Velocity per unit of position error (1/s).
    pub bias_rate: Real,
    /// Fraction of the velocity error that one iteration removes (0 to 1).
    pub mass_scale: Real,
    /// Fraction of the accumulated impulse that one iteration removes (0 to 1).
    pub impulse_scale: Real,
}

impl Softness {
    /// Hard constraint without position correction. The relax pass uses it.
    pub const RIGID: Self = Self { bias_rate: 0.0, mass_scale: 1.0, impulse_scale: 0.0 };

    /// The softness that removes this fraction of the error in a substep (0 to 1), with a compliance (0:
    /// hard). A substep takes `substep` seconds.
    #[inline]
    pub fn new(fraction: Real, compliance: Real, substep: Real) -> Self {
        let bias_rate = if substep > 0.0 { fraction / substep } else { 0.0 };
        Self { bias_rate, ..Self::RIGID }.with_compliance(compliance)
    }

    /// The softness that removes the same fraction, with another compliance.
    #[inline]
    pub(crate) fn with_compliance(self, compliance: Real) -> Self {
        let mass_scale = 1.0 / (1.0 + compliance);
        Self { mass_scale, impulse_scale: compliance * mass_scale, ..self }
    }

    /// The same spring and damper in substeps of `substep` seconds, if it was made for substeps `ratio` times
    /// as long (more than 1). With a ratio of 1 or less the result is the same.
    ///
    /// From `k = β m/(σ h²)` and `c = (1 - β) m/(σ h)`.
    pub(crate) fn in_shorter_substep(&self, ratio: Real, substep: Real) -> Self {
        if ratio <= 1.0 {
            return *self;
        }
        let share = 1.0 / ratio;
        let fraction = self.bias_rate * substep * ratio;
        let kept = (1.0 - fraction) + share * fraction;
        Self::new(share * fraction / kept, self.compliance() * ratio / kept, substep)
    }

    /// The compliance `σ` from which [`Self::new`] made this.
    #[inline]
    pub(crate) fn compliance(&self) -> Real {
        self.impulse_scale / self.mass_scale
    }

    /// The softness of a spring with the angular frequency `ω` (rad/s) and the damping ratio `ζ` (1:
    /// critical), for substeps of `substep` seconds.
    ///
    /// `ω = 0` is a spring without force: the constraint has no effect.
    #[inline]
    pub fn spring(angular_frequency: Real, damping_ratio: Real, substep: Real) -> Self {
        let turn = substep * angular_frequency;
        if turn <= 0.0 {
            return Self { bias_rate: 0.0, mass_scale: 0.0, impulse_scale: 1.0 };
        }
        let stiffness = 2.0 * damping_ratio + turn;
        Self::new(turn / stiffness, 1.0 / (turn * stiffness), substep)
    }
}
