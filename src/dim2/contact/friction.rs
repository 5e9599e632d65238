//! Friction of a whole manifold: one tangential row at the friction centre.
//!
//! The friction centre is the mean of the points, weighted by how close they are to touching. A tangential
//! impulse `λ` acts there. The sum `N` of the normal impulses bounds it:
//!
//! ```text
//! |λ| ≤ μ N
//!
//! Ċ = t·(v2 - v1) - (ρₙ + cₙ) ω2 + ρₙ ω1 - surface velocity
//! K = t·(M1⁻¹ + M2⁻¹) t + ρₙ² I1⁻¹ + (ρₙ + cₙ)² I2⁻¹
//! ```
//!
//! An impulse along a line acts the same wherever on the line it attacks. Only the height `ρₙ` of the
//! friction centre matters, and one row is equivalent to one per point, except for points of different
//! heights.
//!
//! Source: Catto, "Modeling and Solving Constraints" (GDC 2009); the central row is Bepu's.

use super::block::{ContactBlock, FrictionRow};
use super::coulomb::CoulombBlock;
use super::pair::Pair;
use super::rows::{Frame, push};
use crate::base::wide::{Wide, invert};
use crate::dim2::math::{MAX_MANIFOLD_POINTS, Real};
use crate::dim2::state::WideMotion;
use crate::dim2::wide::WideVector;
use crate::model::contact::{ContactInput, Turning, WidePoint};

/// A [`FrictionRow`] in registers.
#[derive(Copy, Clone)]
pub(crate) struct WideFriction<W> {
    pub height: W,
    pub coefficient: W,
    pub mass: W,
    pub surface_velocity: W,
    pub impulse: W,
}

/// The row of a block's friction.
#[inline(always)]
pub(crate) fn prepare<W: Wide>(
    input: &ContactInput,
    pair: &Pair<W>,
    points: &[WidePoint<W>; MAX_MANIFOLD_POINTS],
    prediction: W,
    turning: Turning<W>,
) -> WideFriction<W> {
    let t = pair.frame.t;
    let center = center(points, prediction);
    WideFriction {
        height: center.y,
        coefficient: W::load(&input.friction),
        mass: mass(pair, center.y),
        surface_velocity: t.dot(WideVector::load(&input.tangent_velocity))
            - pair.turn(center, turning),
        impulse: t.dot(WideVector::load(&input.friction_impulse)),
    }
}

/// Solves the friction row once, under the normal impulses as they are.
#[inline(always)]
pub(crate) fn solve<W: Wide>(
    block: &mut ContactBlock,
    _: Option<&mut CoulombBlock>,
    normal_impulse: W,
    velocities: [WideMotion<W>; 2],
) -> [WideMotion<W>; 2] {
    let frame = Frame::load(block);
    let c = WideVector::load(&block.offset);
    let mut friction = WideFriction::load(&block.friction);
    let added = friction.solve(&frame, c, velocities, normal_impulse);
    friction.impulse.store(&mut block.friction.impulse);
    friction.apply(added, block, &frame, velocities)
}

/// Computes the effective mass of the row anew.
#[inline(always)]
pub(crate) fn write_masses<W: Wide>(
    block: &mut ContactBlock,
    _: Option<&mut CoulombBlock>,
    pair: &Pair<W>,
) {
    mass(pair, W::load(&block.friction.height)).store(&mut block.friction.mass);
}

/// The effective mass of the row of a friction centre at this height.
#[inline(always)]
fn mass<W: Wide>(pair: &Pair<W>, height: W) -> W {
    let t = pair.frame.t;
    let height2 = height + pair.offset.y;
    let [i1, i2] = pair.inv_inertia;
    let linear = t.dot(t.component_mul(pair.inv_mass[0] + pair.inv_mass[1]));
    invert(linear + (height * height * i1 + height2 * height2 * i2))
}

/// The velocities after the friction impulse of a block has acted.
#[inline(always)]
pub(crate) fn apply<W: Wide>(
    block: &ContactBlock,
    _: Option<&CoulombBlock>,
    velocities: [WideMotion<W>; 2],
) -> [WideMotion<W>; 2] {
    let friction = WideFriction::load(&block.friction);
    friction.apply(friction.impulse, block, &Frame::load(block), velocities)
}

/// The friction centre.
#[inline(always)]
fn center<W: Wide>(points: &[WidePoint<W>; MAX_MANIFOLD_POINTS], prediction: W) -> WideVector<W> {
    // Weights decrease as points move apart; the lower bound keeps a separated manifold well defined.
    let floor = (prediction * W::splat(0.01)).max(W::splat(Real::EPSILON));
    let (mut sum, mut center) = (W::zero(), WideVector::zero());
    for point in points {
        let closeness = (prediction - point.separation).min(prediction).max(floor);
        let weight = closeness * point.present;
        sum = sum + weight;
        center = center + point.local * weight;
    }
    center * invert(sum)
}

impl<W: Wide> WideFriction<W> {
    #[inline(always)]
    fn load(row: &FrictionRow) -> Self {
        Self {
            height: W::load(&row.height),
            coefficient: W::load(&row.coefficient),
            mass: W::load(&row.mass),
            surface_velocity: W::load(&row.surface_velocity),
            impulse: W::load(&row.impulse),
        }
    }

    #[inline(always)]
    fn store(&self, row: &mut FrictionRow) {
        self.height.store(&mut row.height);
        self.coefficient.store(&mut row.coefficient);
        self.mass.store(&mut row.mass);
        self.surface_velocity.store(&mut row.surface_velocity);
        self.impulse.store(&mut row.impulse);
    }

    /// Stores the row, and applies the impulse with which the step starts.
    #[inline(always)]
    pub fn begin(
        self,
        _: &ContactInput,
        block: &mut ContactBlock,
        _: Option<&mut CoulombBlock>,
        pair: &Pair<W>,
        _: &[WidePoint<W>; MAX_MANIFOLD_POINTS],
        velocities: [WideMotion<W>; 2],
    ) -> [WideMotion<W>; 2] {
        self.store(&mut block.friction);
        self.apply(self.impulse, block, &pair.frame, velocities)
    }

    /// Solves the row once under a normal impulse and returns the change.
    #[inline(always)]
    pub fn solve(
        &mut self,
        frame: &Frame<W>,
        c: WideVector<W>,
        [m1, m2]: [WideMotion<W>; 2],
        normal_impulse: W,
    ) -> W {
        let slip = frame.t.dot(m2.linear - m1.linear) + self.height * m1.angular
            - (self.height + c.y) * m2.angular
            - self.surface_velocity;
        let limit = self.coefficient * normal_impulse;
        let unclamped = self.impulse - self.mass * slip;
        let clamped = unclamped.min(limit).max(-limit);
        let added = clamped - self.impulse;
        self.impulse = clamped;
        added
    }

    /// The velocities after a tangential impulse at the friction centre has acted.
    #[inline(always)]
    pub fn apply(
        &self,
        impulse: W,
        block: &ContactBlock,
        frame: &Frame<W>,
        velocities: [WideMotion<W>; 2],
    ) -> [WideMotion<W>; 2] {
        let c = WideVector::<W>::load(&block.offset);
        let moments = [-(impulse * self.height), -(impulse * (self.height + c.y))];
        push(block, frame.t * impulse, moments, velocities)
    }
}
