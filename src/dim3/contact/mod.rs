//! # Contact constraints in 3D
//!
//! One constraint is one manifold: up to four points with one normal. [`LANES`](crate::base::wide::LANES)
//! constraints without a common dynamic body fill the lanes of a [`ContactBlock`].
//!
//! ## The contact frame
//! All of a constraint happens in the frame `(t1, t2, n)` of its tangents and its normal. Let `x1, x2` be the
//! centres of mass, `p` a contact point and `ρ = p - x1`. Then `p - x2 = ρ + c` with `c = x1 - x2`, the same
//! for all points. The relative normal velocity at a point is
//!
//! ```text
//! Ċ = n·(v2 - v1) + ((ρ + c) × n)·ω2 - (ρ × n)·ω1,        ρ × n = (ρ₂, -ρ₁, 0) in the contact frame
//!   = [n·(v2 - v1) + c₂ ω2₁ - c₁ ω2₂] + ρ₂ (ω2₁ - ω1₁) - ρ₁ (ω2₂ - ω1₂)
//! ```
//!
//! The bracket is shared by the four points, so a point costs two multiplications and stores two numbers of
//! its Jacobian instead of twelve. The separation is followed during the step by the same row, applied to
//! displacements instead of velocities: `C = C₀ + J·Δx`. (Other engines rotate the moment arms with the
//! bodies. That costs two rotations per point and substep and is not more exact for rolling bodies.)
//!
//! ## Sequential impulses without the bodies
//! Gauss–Seidel over the four points needs each point to see the impulses of those before it. Instead of
//! applying each impulse to the bodies (some thirty multiplications), the solver stores the coupling `K_ij =
//! J_i M⁻¹ J_jᵀ` and updates the relative velocities of the points: `Ċ_j += K_ij Δλ_i`. The bodies get the
//! sum of all impulses at the end. In exact arithmetic this is the same method.
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

/// Compliance of a contact at the corner of a face between two cubes, relative to its fraction of the load.
pub(crate) const CORNER_YIELD: Real = 2.0;

/// Least stiffness of a layer of a stack against rotation, relative to the moment of its load per angle.
///
/// At nine tenths of the slope at which a rigid tower tips, a tower of 30 cubes of 1 m stands with a ratio
/// of 30, and one of ten falls with 17.
pub(crate) const LEAN_RATIO_MIN: Real = 32.0;
