//! Friction of a whole manifold: two tangential rows and a twist row at the friction centre.
//!
//! The friction centre is the mean of the points, weighted by how close they are to touching. At it
//! acts a tangential impulse `λt` (two rows, solved together) and about the normal a twist impulse
//! `λw`, with the sum `N` of the normal impulses and the mean distance `r` of the points from the
//! centre:
//!
//! ```text
//! |λt| ≤ μ N        |λw| ≤ μ N r
//!
//! Ċt = v2 + ω2 × (ρ + c) - v1 - ω1 × ρ - surface velocity, first two components in the contact frame
//! K  = M⁻¹ + Σ J I⁻¹ Jᵀ with the angular rows  J₁ = (0, ρ₃, -ρ₂),  J₂ = (-ρ₃, 0, ρ₁)
//! ```
//!
//! The circle is the exact cone; a box of two independent rows would let a body slide √2 times as
//! hard along the diagonal. One centre instead of a row pair per point costs a third and is exact for
//! a translating body under uniform pressure. [`coulomb`](super) friction per point is the other
//! model.
//!
//! Source: Catto, "Box2D v3.1" release notes and Bepu's contact constraints for the central rows.

use super::block::{ContactInput, FrictionRow};
use super::prepare::{Pair, PairImpulse, Point, invert};
use crate::base::wide::Wide;
use crate::dim3::math::MAX_MANIFOLD_POINTS;
use crate::dim3::wide::{WideSymmetric, WideVector};

/// A [`FrictionRow`] in registers.
#[derive(Copy, Clone)]
pub(super) struct WideFriction<W> {
    pub center: WideVector<W>,
    pub coefficient: W,
    pub tangent_mass: [W; 3],
    pub twist_mass: W,
    pub lever: W,
    pub surface_velocity: [W; 2],
    pub impulse: [W; 2],
    pub twist_impulse: W,
}

/// The rows of a block's friction.
#[inline(always)]
pub(super) fn prepare<W: Wide>(
    input: &ContactInput,
    pair: &Pair<W>,
    points: &[Point<W>; MAX_MANIFOLD_POINTS],
    prediction: W,
) -> WideFriction<W> {
    let (center, lever) = center(points, prediction);
    let frame = &pair.frame;
    let impulse = frame.local(WideVector::load(&input.friction_impulse));
    let surface = frame.local(WideVector::load(&input.tangent_velocity));
    WideFriction {
        center,
        coefficient: W::load(&input.friction),
        tangent_mass: tangent_mass(pair, center),
        twist_mass: invert(pair.inv_inertia[0].m33 + pair.inv_inertia[1].m33),
        lever,
        surface_velocity: [surface.x, surface.y],
        impulse: [impulse.x, impulse.y],
        twist_impulse: W::load(&input.twist_impulse),
    }
}

/// The friction centre, and the mean distance of the points from it.
#[inline(always)]
fn center<W: Wide>(
    points: &[Point<W>; MAX_MANIFOLD_POINTS],
    prediction: W,
) -> (WideVector<W>, W) {
    // Weights fade out as points move apart; the floor keeps a manifold that hovers well defined.
    let floor = prediction * W::splat(0.01);
    let mut weights = [W::zero(); MAX_MANIFOLD_POINTS];
    let mut sum = W::zero();
    let mut center = WideVector::zero();
    for k in 0..MAX_MANIFOLD_POINTS {
        let closeness = (prediction - points[k].separation).min(prediction).max(floor);
        weights[k] = closeness * points[k].present;
        sum = sum + weights[k];
        center = center + points[k].local * weights[k];
    }
    let inv_sum = invert(sum);
    let center = center * inv_sum;
    let mut lever = W::zero();
    for k in 0..MAX_MANIFOLD_POINTS {
        let arm = points[k].local - center;
        lever = lever + weights[k] * (arm.x * arm.x + arm.y * arm.y).sqrt();
    }
    (center, lever * inv_sum)
}

/// The inverse of the tangents' 2×2 matrix `K`.
#[inline(always)]
fn tangent_mass<W: Wide>(pair: &Pair<W>, center: WideVector<W>) -> [W; 3] {
    let inv_mass = pair.poses[0].inv_mass + pair.poses[1].inv_mass;
    let (t1, t2) = (pair.frame.t1, pair.frame.t2);
    let [a11, a12, a22] = angular_part(pair.inv_inertia[0], center);
    let [b11, b12, b22] = angular_part(pair.inv_inertia[1], center + pair.offset);
    let k11 = t1.dot(t1.component_mul(inv_mass)) + a11 + b11;
    let k12 = t1.dot(t2.component_mul(inv_mass)) + a12 + b12;
    let k22 = t2.dot(t2.component_mul(inv_mass)) + a22 + b22;
    let inv_det = invert(k11 * k22 - k12 * k12);
    [k22 * inv_det, -(k12 * inv_det), k11 * inv_det]
}

/// `J I⁻¹ Jᵀ` of the two tangential rows at a point: 11, 12, 22.
#[inline(always)]
fn angular_part<W: Wide>(i: WideSymmetric<W>, r: WideVector<W>) -> [W; 3] {
    // I⁻¹ J₂ᵀ with J₂ = (-r₃, 0, r₁)
    let column = [i.m13 * r.x - i.m11 * r.z, i.m23 * r.x - i.m12 * r.z, i.m33 * r.x - i.m13 * r.z];
    let cross = r.y * r.z * i.m23;
    [
        r.z * r.z * i.m22 - (cross + cross) + r.y * r.y * i.m33,
        r.z * column[1] - r.y * column[2],
        r.x * column[2] - r.z * column[0],
    ]
}

impl<W: Wide> WideFriction<W> {
    #[inline(always)]
    pub fn load(row: &FrictionRow) -> Self {
        Self {
            center: WideVector::load(&row.center),
            coefficient: W::load(&row.coefficient),
            tangent_mass: [
                W::load(&row.tangent_mass[0]),
                W::load(&row.tangent_mass[1]),
                W::load(&row.tangent_mass[2]),
            ],
            twist_mass: W::load(&row.twist_mass),
            lever: W::load(&row.lever),
            surface_velocity: [
                W::load(&row.surface_velocity[0]),
                W::load(&row.surface_velocity[1]),
            ],
            impulse: [W::load(&row.impulse[0]), W::load(&row.impulse[1])],
            twist_impulse: W::load(&row.twist_impulse),
        }
    }

    #[inline(always)]
    pub fn store(&self, row: &mut FrictionRow) {
        self.center.store(&mut row.center);
        self.coefficient.store(&mut row.coefficient);
        for k in 0..3 {
            self.tangent_mass[k].store(&mut row.tangent_mass[k]);
        }
        self.twist_mass.store(&mut row.twist_mass);
        self.lever.store(&mut row.lever);
        for k in 0..2 {
            self.surface_velocity[k].store(&mut row.surface_velocity[k]);
        }
        self.store_impulses(row);
    }

    #[inline(always)]
    pub fn store_impulses(&self, row: &mut FrictionRow) {
        self.impulse[0].store(&mut row.impulse[0]);
        self.impulse[1].store(&mut row.impulse[1]);
        self.twist_impulse.store(&mut row.twist_impulse);
    }

    /// Solves the three rows once, for velocities in the contact frame, and returns what it added.
    #[inline(always)]
    pub fn solve(
        &mut self,
        linear: WideVector<W>,
        w: [WideVector<W>; 2],
        c: WideVector<W>,
        normal_impulse: W,
    ) -> PairImpulse<W> {
        let limit = self.coefficient * normal_impulse;
        let mut added = PairImpulse::zero();
        let twist = self.solve_twist(w[1].z - w[0].z, limit);
        added.angular1.z = twist;
        added.angular2.z = twist;

        let (a, b) = (self.center, self.center + c);
        let vx = linear.x + (w[1].y * b.z - w[1].z * b.y) - (w[0].y * a.z - w[0].z * a.y)
            - self.surface_velocity[0];
        let vy = linear.y + (w[1].z * b.x - w[1].x * b.z) - (w[0].z * a.x - w[0].x * a.z)
            - self.surface_velocity[1];
        let tangential = self.solve_tangents(vx, vy, limit);
        added.add_tangential(tangential, a, c);
        added
    }

    #[inline(always)]
    fn solve_twist(&mut self, spin: W, limit: W) -> W {
        let limit = limit * self.lever;
        let wanted = self.twist_impulse - self.twist_mass * spin;
        let clamped = wanted.min(limit).max(-limit);
        let added = clamped - self.twist_impulse;
        self.twist_impulse = clamped;
        added
    }

    #[inline(always)]
    fn solve_tangents(&mut self, vx: W, vy: W, limit: W) -> [W; 2] {
        let [m11, m12, m22] = self.tangent_mass;
        let x = self.impulse[0] - (m11 * vx + m12 * vy);
        let y = self.impulse[1] - (m12 * vx + m22 * vy);
        // Back onto the circle of radius `limit`.
        let length_squared = x * x + y * y;
        let outside = (limit * limit).lt(length_squared);
        let one = W::splat(1.0);
        let length = W::select(outside, length_squared, one).sqrt();
        let scale = W::select(outside, limit / length, one);
        let (x, y) = (x * scale, y * scale);
        let added = [x - self.impulse[0], y - self.impulse[1]];
        self.impulse = [x, y];
        added
    }
}
