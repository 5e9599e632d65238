//! Friction of a whole manifold: two tangential rows and a torsional row at the friction centre.
//!
//! The friction centre is the mean of the points, weighted by how close they are to touching. A tangential
//! impulse `λt` (two rows, solved together) acts there, and a torsional impulse `λw` about the normal. With
//! the sum `N` of the normal impulses and the mean distance `r` of the points from the centre:
//!
//! ```text
//! |λt| ≤ μ N        |λw| ≤ μ N r        at `|λt| = μ N` opposite to the slip: see `tangents`
//!
//! Ċt = v2 + ω2 × (ρ + c) - v1 - ω1 × ρ - surface velocity, first two components in the contact frame
//! K  = M⁻¹ + Σ J I⁻¹ Jᵀ with the angular rows  J₁ = (0, ρ₃, -ρ₂),  J₂ = (-ρ₃, 0, ρ₁)
//! ```
//!
//! The circle is the exact cone; a box of two independent rows would let a body slide √2 times as
//! hard along the diagonal. One centre instead of a row pair per point costs a third and is exact for
//! a translating body under uniform pressure. Friction per point is [the other model](super::coulomb).
//!
//! Source: Catto, "Box2D v3.1" release notes and Bepu's contact constraints for the central rows.

use super::block::{ContactBlock, FrictionRow};
use super::coulomb::CoulombBlock;
use super::pair::Pair;
use super::rows::{Frame, push};
use super::tangents::{TangentMass, load, store};
use crate::base::wide::{Wide, invert};
use crate::dim3::math::{MAX_MANIFOLD_POINTS, Real};
use crate::dim3::state::WideMotion;
use crate::dim3::wide::{WideSymmetric, WideVector};
use crate::model::contact::{ContactInput, Turning, WidePoint};

/// A [`FrictionRow`] in registers.
#[derive(Copy, Clone)]
pub(crate) struct WideFriction<W> {
    pub center: WideVector<W>,
    pub coefficient: W,
    pub tangent_mass: TangentMass<W>,
    pub torsional_mass: W,
    pub radius: W,
    pub torsional_coupling: [W; 2],
    pub surface_velocity: [W; 2],
    pub impulse: [W; 3],
}

/// The rows of a block's friction.
#[inline(always)]
pub(crate) fn prepare<W: Wide>(
    input: &ContactInput,
    pair: &Pair<W>,
    points: &[WidePoint<W>; MAX_MANIFOLD_POINTS],
    prediction: W,
    turning: Turning<W>,
) -> WideFriction<W> {
    let (center, radius) = center(points, prediction);
    let frame = &pair.frame;
    let [x, y] = frame.tangential(WideVector::load(&input.friction_impulse));
    let [vx, vy] = frame.tangential(WideVector::load(&input.tangent_velocity));
    let [tx, ty] = pair.turn(center, turning);
    let (tangent_mass, torsional_mass, torsional_coupling) = masses(pair, center);
    WideFriction {
        center,
        coefficient: W::load(&input.friction),
        tangent_mass,
        torsional_mass,
        radius,
        torsional_coupling,
        surface_velocity: [vx - tx, vy - ty],
        impulse: [x, y, W::load(&input.torsional_impulse)],
    }
}

/// Solves the friction rows once, central ones or those of the points, under the normal impulses as they are.
#[inline(always)]
pub(crate) fn solve<W: Wide>(
    block: &mut ContactBlock,
    coulomb: Option<&mut CoulombBlock>,
    normal_impulse: W,
    velocities: [WideMotion<W>; 2],
) -> [WideMotion<W>; 2] {
    let frame = Frame::load(block);
    if let Some(rows) = coulomb {
        return rows.solve(block, &frame, velocities);
    }
    let c = WideVector::load(&block.offset);
    let mut friction = WideFriction::load(&block.friction);
    let added = friction.solve(&frame, c, velocities, normal_impulse);
    store(friction.impulse, &mut block.friction.impulse);
    friction.apply(added, block, &frame, velocities)
}

/// Computes the effective masses of the rows anew.
#[inline(always)]
pub(crate) fn write_masses<W: Wide>(
    block: &mut ContactBlock,
    coulomb: Option<&mut CoulombBlock>,
    pair: &Pair<W>,
) {
    let (tangents, torsional, coupling) = masses(pair, WideVector::load(&block.friction.center));
    tangents.store(&mut block.friction.tangent_mass);
    torsional.store(&mut block.friction.torsional_mass);
    store(coupling, &mut block.friction.torsional_coupling);
    coulomb.into_iter().for_each(|rows| rows.write_masses(block, pair));
}

/// The effective masses of the tangential rows and of the torsional row, and their coupling.
#[inline(always)]
fn masses<W: Wide>(pair: &Pair<W>, center: WideVector<W>) -> (TangentMass<W>, W, [W; 2]) {
    let (tangents, coupling) = tangent_matrix(pair, center);
    let torsional = invert(pair.inv_inertia[0].m33 + pair.inv_inertia[1].m33);
    (TangentMass::of(tangents), torsional, coupling)
}

/// The velocities after all friction impulses of a block have acted.
#[inline(always)]
pub(crate) fn apply<W: Wide>(
    block: &ContactBlock,
    coulomb: Option<&CoulombBlock>,
    velocities: [WideMotion<W>; 2],
) -> [WideMotion<W>; 2] {
    let frame = Frame::load(block);
    match coulomb {
        Some(rows) => rows.warm_start(block, &frame, velocities),
        None => {
            let friction = WideFriction::load(&block.friction);
            friction.apply(friction.impulse, block, &frame, velocities)
        }
    }
}

/// The friction centre, and the mean distance of the points from it.
#[inline(always)]
fn center<W: Wide>(
    points: &[WidePoint<W>; MAX_MANIFOLD_POINTS],
    prediction: W,
) -> (WideVector<W>, W) {
    // Weights decrease as points move apart; the lower bound keeps a separated manifold well defined.
    let floor = (prediction * W::splat(0.01)).max(W::splat(Real::EPSILON));
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
    let mut radius = W::zero();
    for k in 0..MAX_MANIFOLD_POINTS {
        let arm = points[k].local - center;
        radius = radius + weights[k] * (arm.x * arm.x + arm.y * arm.y).sqrt();
    }
    (center, radius * inv_sum)
}

/// The matrix `K` of the two tangential rows (11, 12, 22), and their coupling with the torsional row.
#[inline(always)]
fn tangent_matrix<W: Wide>(pair: &Pair<W>, center: WideVector<W>) -> ([W; 3], [W; 2]) {
    let inv_mass = pair.inv_mass[0] + pair.inv_mass[1];
    let (t1, t2) = (pair.frame.t1, pair.frame.t2);
    let [a11, a12, a22, a13, a23] = angular_part(pair.inv_inertia[0], center);
    let [b11, b12, b22, b13, b23] = angular_part(pair.inv_inertia[1], center + pair.offset);
    let tangents = [
        t1.dot(t1.component_mul(inv_mass)) + a11 + b11,
        t1.dot(t2.component_mul(inv_mass)) + a12 + b12,
        t2.dot(t2.component_mul(inv_mass)) + a22 + b22,
    ];
    (tangents, [a13 + b13, a23 + b23])
}

/// `J I⁻¹ Jᵀ` of the two tangential rows at a point and the torsional row `J₃ = (0, 0, 1)`: 11, 12, 22, 13,
/// 23.
#[inline(always)]
fn angular_part<W: Wide>(i: WideSymmetric<W>, r: WideVector<W>) -> [W; 5] {
    // Components of I⁻¹ J₁ᵀ and I⁻¹ J₂ᵀ.
    let (i1y, i1z) = (i.m22 * r.z - i.m23 * r.y, i.m23 * r.z - i.m33 * r.y);
    let i2x = i.m13 * r.x - i.m11 * r.z;
    let (i2y, i2z) = (i.m23 * r.x - i.m12 * r.z, i.m33 * r.x - i.m13 * r.z);
    [r.z * i1y - r.y * i1z, r.z * i2y - r.y * i2z, r.x * i2z - r.z * i2x, i1z, i2z]
}

impl<W: Wide> WideFriction<W> {
    #[inline(always)]
    fn load(row: &FrictionRow) -> Self {
        Self {
            center: WideVector::load(&row.center),
            coefficient: W::load(&row.coefficient),
            tangent_mass: TangentMass::load(&row.tangent_mass),
            torsional_mass: W::load(&row.torsional_mass),
            radius: W::load(&row.radius),
            torsional_coupling: load(&row.torsional_coupling),
            surface_velocity: load(&row.surface_velocity),
            impulse: load(&row.impulse),
        }
    }

    #[inline(always)]
    fn store(self, row: &mut FrictionRow) {
        self.center.store(&mut row.center);
        self.coefficient.store(&mut row.coefficient);
        self.tangent_mass.store(&mut row.tangent_mass);
        self.torsional_mass.store(&mut row.torsional_mass);
        self.radius.store(&mut row.radius);
        store(self.torsional_coupling, &mut row.torsional_coupling);
        store(self.surface_velocity, &mut row.surface_velocity);
        store(self.impulse, &mut row.impulse);
    }

    /// Stores the rows, and applies the impulses with which the step starts: its own, or those of the points.
    #[inline(always)]
    pub fn begin(
        self,
        input: &ContactInput,
        block: &mut ContactBlock,
        coulomb: Option<&mut CoulombBlock>,
        pair: &Pair<W>,
        points: &[WidePoint<W>; MAX_MANIFOLD_POINTS],
        velocities: [WideMotion<W>; 2],
    ) -> [WideMotion<W>; 2] {
        self.store(&mut block.friction);
        match coulomb {
            None => self.apply(self.impulse, block, &pair.frame, velocities),
            Some(rows) => {
                rows.prepare(input, block, pair, points);
                rows.warm_start(block, &pair.frame, velocities)
            }
        }
    }

    /// Solves the three rows once under a normal impulse and returns the change.
    #[inline(always)]
    pub fn solve(
        &mut self,
        frame: &Frame<W>,
        c: WideVector<W>,
        [m1, m2]: [WideMotion<W>; 2],
        normal_impulse: W,
    ) -> [W; 3] {
        let limit = self.coefficient * normal_impulse;
        let spin = frame.n.dot(m2.angular - m1.angular);
        let torsion = self.solve_torsion(spin, limit * self.radius);
        let [vx, vy] = slip(frame, self.center, c, [m1, m2]);
        let slip = [
            vx + self.torsional_coupling[0] * torsion - self.surface_velocity[0],
            vy + self.torsional_coupling[1] * torsion - self.surface_velocity[1],
        ];
        let [x, y] = self.solve_tangents(slip, limit);
        [x, y, torsion]
    }

    #[inline(always)]
    fn solve_torsion(&mut self, spin: W, limit: W) -> W {
        let old = self.impulse[2];
        let unclamped = old - self.torsional_mass * spin;
        self.impulse[2] = unclamped.min(limit).max(-limit);
        self.impulse[2] - old
    }

    #[inline(always)]
    fn solve_tangents(&mut self, slip: [W; 2], limit: W) -> [W; 2] {
        let [old_x, old_y, torsion] = self.impulse;
        let [x, y] = self.tangent_mass.friction([old_x, old_y], slip, limit);
        self.impulse = [x, y, torsion];
        [x - old_x, y - old_y]
    }

    /// The velocities after impulses at the friction centre have acted: two along the tangents, one
    /// about the normal.
    #[inline(always)]
    pub fn apply(
        &self,
        [x, y, torsion]: [W; 3],
        block: &ContactBlock,
        frame: &Frame<W>,
        velocities: [WideMotion<W>; 2],
    ) -> [WideMotion<W>; 2] {
        let (a, b) = (self.center, self.center + WideVector::load(&block.offset));
        let mut moments = [moment(a, [x, y]), moment(b, [x, y])];
        moments[0][2] = moments[0][2] + torsion;
        moments[1][2] = moments[1][2] + torsion;
        push(block, frame.t1 * x + frame.t2 * y, moments, velocities)
    }
}

/// The relative velocity along the two tangents, at a point of the contact frame.
#[inline(always)]
pub(super) fn slip<W: Wide>(
    frame: &Frame<W>,
    a: WideVector<W>,
    c: WideVector<W>,
    [m1, m2]: [WideMotion<W>; 2],
) -> [W; 2] {
    let (w1, w2) = (frame.local(m1.angular), frame.local(m2.angular));
    let linear = frame.tangential(m2.linear - m1.linear);
    let b = a + c;
    [
        linear[0] + (w2.y * b.z - w2.z * b.y) - (w1.y * a.z - w1.z * a.y),
        linear[1] + (w2.z * b.x - w2.x * b.z) - (w1.z * a.x - w1.x * a.z),
    ]
}

/// The moment `ρ × P` of an impulse along the tangents (`P₃ = 0`) at a point.
#[inline(always)]
pub(super) fn moment<W: Wide>(rho: WideVector<W>, [x, y]: [W; 2]) -> [W; 3] {
    [-(rho.z * y), rho.z * x, rho.x * y - rho.y * x]
}

/// The effective mass of two tangential rows at a point.
#[inline(always)]
pub(super) fn tangent_mass<W: Wide>(pair: &Pair<W>, point: WideVector<W>) -> TangentMass<W> {
    TangentMass::of(tangent_matrix(pair, point).0)
}
