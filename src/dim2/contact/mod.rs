//! # Contact constraints in 2D
//!
//! One constraint is one manifold: one or two points with one normal. [`LANES`](crate::base::wide::LANES)
//! constraints without a common dynamic body fill the lanes of a [`ContactBlock`].
//!
//! ## The contact frame
//! All of a constraint happens in the right-handed frame `(t, n)` of its tangent and its normal. Let `x1, x2`
//! be the centres of mass, `p` a contact point and `ρ = p - x1`. Then `p - x2 = ρ + c` with `c = x1 - x2`,
//! the same for both points. The relative normal velocity at a point is
//!
//! ```text
//! Ċ = n·(v2 - v1) + ((ρ + c) × n) ω2 - (ρ × n) ω1,        ρ × n = ρₜ in the contact frame
//!   = [n·(v2 - v1) + cₜ ω2] + ρₜ (ω2 - ω1)
//! ```
//!
//! The bracket is shared by the points, so a point costs one multiplication and stores one number of its
//! Jacobian. The separation is followed during the step by the same row, applied to displacements instead of
//! velocities: `C = C₀ + J·Δx`. (Other engines rotate the moment arms with the bodies. That costs two
//! rotations per point and substep and is not more exact for rolling bodies.)
//!
//! ## Sequential impulses without the bodies
//! Gauss–Seidel over the points needs the second point to see the impulse of the first. Instead of applying
//! it to the bodies, the solver stores the coupling `K₀₁ = J₀ M⁻¹ J₁ᵀ` and updates the relative velocity of
//! the second point: `Ċ₁ += K₀₁ Δλ₀`. The bodies get the sum of both impulses at the end. In exact arithmetic
//! this is the same method.
//!
//! ## The soft row
//! With the softness of [`Softness`](crate::model::params::Softness) (bias rate `b`, mass scale `m`,
//! impulse scale `i`), the allowed overlap `C_allowed` and the accumulated impulse `λ ≥ 0`:
//!
//! ```text
//! Δλ = -(m Ċ + bias) / K - i λ,    bias = max(m b min(C + C_allowed, 0), -push)  overlapping
//!                                  bias = C / h, m = 1, i = 0                    apart (it may close the gap, no more)
//! ```
//!
//! Sources: Catto, "Solver2D" (box2d.org, 2024) for the soft substep; Catto, "Modeling and Solving
//! Constraints" (GDC 2009) for sequential impulses.

mod block;
mod coulomb;
mod friction;
mod pair;
mod rows;
mod tangents;
#[cfg(test)]
mod tests;

use super::math::Real;
pub(crate) use block::ContactBlock;
pub(crate) use coulomb::CoulombBlock;
pub(crate) use friction::{
    apply as apply_friction, prepare as prepare_friction, solve as solve_friction,
    write_masses as write_friction_masses,
};
pub(crate) use pair::Pair;
pub(crate) use rows::{Frame, NormalImpulse, NormalRow};
pub(crate) use tangents::PointTangentMass;

/// Compliance of a contact at the end of a side between two squares, relative to its fraction of the load.
pub(crate) const CORNER_YIELD: Real = 2.5;

/// Least stiffness of a layer of a stack against rotation, relative to the moment of its load per angle.
///
/// At nine tenths of the slope at which a rigid tower tips, a tower of twenty squares falls with a ratio of
/// 106, and one of eight stands with 166. Sudden gravity swings a tower on two points more than one on four.
pub(crate) const LEAN_RATIO_MIN: Real = 128.0;
