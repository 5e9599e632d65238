//! Rules of impacts that contacts of bodies and contacts of links share.
//!
//! The derivation is in `impacts/mod.rs`. The rules are generic over the number: that of a single point,
//! or of a point per lane.

use crate::base::wide::{Lane, Wide, record_of_lanes};
use crate::dim::math::Real;
use crate::model::params::ImpactPass;
use core::ops::{Add, Mul, Neg, Sub};

/// Gauss–Seidel iterations over the points of a manifold in each iteration over all manifolds. The points
/// couple with each other more than with other manifolds.
pub(super) const POINT_ITERATIONS: usize = 4;
/// A round has converged when no point changes its velocity by more than this fraction of its approach
/// velocity.
const CONVERGENCE_TOLERANCE: Real = 1.0e-3;

/// Largest correction of a point's approach for forces in the rest of the substep, as a fraction of its
/// speed.
const FORCE_CORRECTION_MAX: Real = 0.25;
/// Points at rest when the impact began take part when their approach increases by this fraction of the
/// restitution threshold. Rounding must not wake them.
pub(super) const APPROACH_CHANGE_MIN: Real = 0.01;

/// Separation of deferred points: beyond the reach of all passes.
pub(super) const DEFERRED_SEPARATION: Real = 1.0e10;

/// A number of one point, or of a point per lane. Each function has a counterpart in [`Wide`].
pub(super) trait Number:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self>
{
    /// The same number for all points.
    fn all(value: Real) -> Self;
    /// The smaller number.
    fn smaller(self, other: Self) -> Self;
    /// The larger number.
    fn larger(self, other: Self) -> Self;
    /// This number where `bound <= value`, else zero.
    fn where_reached(self, bound: Self, value: Self) -> Self;
}

impl Number for Real {
    fn all(value: Real) -> Self {
        value
    }

    fn smaller(self, other: Self) -> Self {
        if self < other { self } else { other }
    }

    fn larger(self, other: Self) -> Self {
        if self > other { self } else { other }
    }

    fn where_reached(self, bound: Self, value: Self) -> Self {
        if bound <= value { self } else { 0.0 }
    }
}

impl<W: Wide> Number for W {
    #[inline(always)]
    fn all(value: Real) -> Self {
        W::splat(value)
    }

    #[inline(always)]
    fn smaller(self, other: Self) -> Self {
        self.min(other)
    }

    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        self.max(other)
    }

    #[inline(always)]
    fn where_reached(self, bound: Self, value: Self) -> Self {
        W::select(bound.le(value), self, W::zero())
    }
}

/// The part of the velocity change by forces that supports cancel, and the velocity below which a point hits.
///
/// The point moves at `free` without the impulses of the last substep and at `loaded` with them. It moved at
/// `last` when that substep ended.
#[inline(always)]
pub(super) fn supported<N: Number>(free: N, last: N, loaded: N, pass: &ImpactPass) -> (N, N) {
    let zero = N::all(0.0);
    let support_velocity = (loaded - free).smaller(-(free - last)).larger(zero);
    let now = free + support_velocity;
    let at_rest = now.smaller(zero).where_reached(N::all(-pass.threshold), now.larger(last));
    (support_velocity, at_rest - N::all(pass.threshold * APPROACH_CHANGE_MIN))
}

/// Data of a hitting point.
#[derive(Copy, Clone, Debug, Default)]
pub(super) struct HitRow<N> {
    /// `1 / K` where it hits in this round, zero elsewhere.
    pub mass: N,
    /// The part of the force-induced velocity change that supports cancel.
    pub support_velocity: N,
    /// Its velocity of approach in this round (negative), and the one with which it is to part.
    pub approach: N,
    pub target: N,
    /// Time of the impact since the beginning of the substep (s).
    pub time: N,
}

record_of_lanes!(HitRow of &HitRow<Real> { mass, support_velocity, approach, target, time });

impl HitRow<Lane> {
    /// Data of one lane.
    pub fn lane(&self, lane: usize) -> HitRow<Real> {
        HitRow {
            mass: self.mass.0[lane],
            support_velocity: self.support_velocity.0[lane],
            approach: self.approach.0[lane],
            target: self.target.0[lane],
            time: self.time.0[lane],
        }
    }
}

impl<N: Number> HitRow<N> {
    /// Computes how a point parts that hits at this speed. Forces change its velocity by `accelerated` in
    /// the substep.
    #[inline(always)]
    pub fn aim(&mut self, speed: N, accelerated: N, restitution: N, pass: &ImpactPass) {
        let most = speed * N::all(FORCE_CORRECTION_MAX);
        let correction = accelerated * (self.time * N::all(pass.inv_substep) - N::all(0.5));
        let correction = correction.larger(-most).smaller(most);
        self.approach = correction + correction - speed;
        self.target = (restitution * (speed - correction) - correction).larger(N::all(0.0));
    }

    /// The impulse with which a point at this velocity parts at its target velocity.
    #[inline(always)]
    pub fn impulse(&self, velocity: N, old: N) -> N {
        let missing = self.target - self.support_velocity - velocity;
        (old + self.mass * missing).larger(N::all(0.0))
    }

    /// The change of the impulse up to which the point has converged.
    #[inline(always)]
    pub fn tolerance(&self) -> N {
        -(self.mass * self.approach * N::all(CONVERGENCE_TOLERANCE))
    }

    /// Impulse times approach, and the energy gain beyond the restitution.
    #[inline(always)]
    pub fn energies(&self, velocity: N, impulse: N, restitution: N) -> [N; 2] {
        let allowed = restitution.larger(N::all(1.0));
        let velocity = velocity + self.support_velocity;
        [impulse * self.approach, impulse * (velocity + allowed * self.approach) * N::all(0.5)]
    }
}
