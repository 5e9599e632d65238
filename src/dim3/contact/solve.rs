//! The passes over a block: solve and relax in each substep, restitution once at the end.

use super::block::ContactBlock;
use super::friction::WideFriction;
use super::prepare::{Frame, NormalRow, PairImpulse};
use crate::base::disjoint::DisjointMut;
use crate::base::wide::{Lane, Wide};
use crate::dim3::math::MAX_MANIFOLD_POINTS;
use crate::dim3::state::{BodyState, WideMotion, gather_states, scatter_velocities};
use crate::dim3::wide::{WideSymmetric, WideVector, load_symmetric, mul_inertia};
use crate::model::params::{ContactPass, Softness};

/// Velocities and displacements of a block's two bodies.
struct Bodies<W> {
    velocities: [WideMotion<W>; 2],
    displacements: [WideMotion<W>; 2],
}

/// # Safety
/// As [`gather_states`], for both bodies.
#[inline(always)]
unsafe fn gather_bodies<W: Wide>(
    states: &DisjointMut<BodyState>,
    block: &ContactBlock,
) -> Bodies<W> {
    // SAFETY: the caller's promise.
    let ([v1, d1], [v2, d2]) = unsafe {
        (gather_states(states, &block.bodies[0]), gather_states(states, &block.bodies[1]))
    };
    Bodies { velocities: [v1, v2], displacements: [d1, d2] }
}

/// # Safety
/// As [`scatter_velocities`], for both bodies.
#[inline(always)]
unsafe fn apply<W: Wide>(
    states: &DisjointMut<BodyState>,
    block: &ContactBlock,
    frame: &Frame<W>,
    impulse: &PairImpulse<W>,
    [m1, m2]: [WideMotion<W>; 2],
) {
    let (m1, m2) = impulse.apply(block, frame, m1, m2);
    // SAFETY: the caller's promise.
    unsafe {
        scatter_velocities(states, &block.bodies[0], m1);
        scatter_velocities(states, &block.bodies[1], m2);
    }
}

/// The normal rows with their bias: pushes overlapping bodies apart, and lets those that are apart
/// come no closer than to touch.
///
/// # Safety
/// Nobody else may touch the states of the block's bodies meanwhile.
#[inline(always)]
pub(crate) unsafe fn solve<W: Wide>(
    block: &mut ContactBlock,
    states: &DisjointMut<BodyState>,
    pass: &ContactPass,
) {
    // SAFETY: the caller's promise.
    let bodies = unsafe { gather_bodies::<W>(states, block) };
    let frame = Frame::load(block);
    let c = WideVector::load(&block.offset);
    let velocity = NormalRow::new(&frame, c, bodies.velocities);
    let displacement = NormalRow::new(&frame, c, bodies.displacements);
    let soft = SoftRow::of(block, pass);
    let mut impulse = PairImpulse::zero();
    solve_normals::<W, true>(block, velocity, displacement, &soft, pass, &mut impulse);
    // SAFETY: the caller's promise.
    unsafe { apply(states, block, &frame, &impulse, bodies.velocities) };
}

/// The normal rows without bias, which takes out the velocity that the bias of the solve pass put in
/// to move bodies apart; then friction.
///
/// In this order friction is bounded by the impulses that carry the bodies. Those of the solve pass
/// are less while a soft contact gives way, and more while it undoes overlap: with them a box that
/// was just put down slides 5 % too far.
///
/// # Safety
/// Nobody else may touch the states of the block's bodies meanwhile.
#[inline(always)]
pub(crate) unsafe fn relax<W: Wide>(
    block: &mut ContactBlock,
    states: &DisjointMut<BodyState>,
    pass: &ContactPass,
) {
    // SAFETY: the caller's promise.
    let bodies = unsafe { gather_bodies::<W>(states, block) };
    let frame = Frame::load(block);
    let c = WideVector::load(&block.offset);
    let velocity = NormalRow::new(&frame, c, bodies.velocities);
    let displacement = NormalRow::new(&frame, c, bodies.displacements);
    let mut impulse = PairImpulse::zero();
    solve_normals::<W, false>(block, velocity, displacement, &SoftRow::rigid(), pass, &mut impulse);

    // The normal impulses turn the bodies, and that moves the points along the surfaces.
    let [m1, m2] = bodies.velocities;
    let linear = frame.local(m2.linear - m1.linear);
    let inertia: [WideSymmetric<W>; 2] =
        [load_symmetric(&block.inv_inertia[0]), load_symmetric(&block.inv_inertia[1])];
    let w1 = frame.local(m1.angular) - mul_inertia(inertia[0], impulse.angular1);
    let w2 = frame.local(m2.angular) + mul_inertia(inertia[1], impulse.angular2);
    let mut friction = WideFriction::load(&block.friction);
    let tangential = friction.solve(linear, [w1, w2], c, total_impulse(block));
    friction.store_impulses(&mut block.friction);
    impulse.linear = impulse.linear + tangential.linear;
    impulse.angular1 = impulse.angular1 + tangential.angular1;
    impulse.angular2 = impulse.angular2 + tangential.angular2;
    for k in 0..MAX_MANIFOLD_POINTS {
        let total = W::load(&block.totals[k]) + W::load(&block.points[k].impulse);
        total.store(&mut block.totals[k]);
    }
    // SAFETY: the caller's promise.
    unsafe { apply(states, block, &frame, &impulse, bodies.velocities) };
}

/// The sum of the normal impulses.
#[inline(always)]
fn total_impulse<W: Wide>(block: &ContactBlock) -> W {
    let mut sum = W::load(&block.points[0].impulse);
    for point in &block.points[1..] {
        sum = sum + W::load(&point.impulse);
    }
    sum
}

/// [`Softness`] of each lane.
struct SoftRow<W> {
    /// Bias rate times mass scale (1/s).
    rate: W,
    mass_scale: W,
    impulse_scale: W,
}

impl<W: Wide> SoftRow<W> {
    #[inline(always)]
    fn of(block: &ContactBlock, pass: &ContactPass) -> Self {
        let is_static = W::splat(0.5).lt(W::load(&block.is_static));
        let (a, b): (Softness, Softness) = (pass.static_softness, pass.softness);
        let pick = |fixed, free| (W::splat(fixed), W::splat(free));
        let (rate1, rate2) = pick(a.bias_rate * a.mass_scale, b.bias_rate * b.mass_scale);
        let (mass1, mass2) = pick(a.mass_scale, b.mass_scale);
        let (impulse1, impulse2) = pick(a.impulse_scale, b.impulse_scale);
        Self {
            rate: W::select(is_static, rate1, rate2),
            mass_scale: W::select(is_static, mass1, mass2),
            impulse_scale: W::select(is_static, impulse1, impulse2),
        }
    }

    #[inline(always)]
    fn rigid() -> Self {
        Self { rate: W::zero(), mass_scale: W::splat(1.0), impulse_scale: W::zero() }
    }
}

/// Gauss–Seidel over the points of each lane.
#[inline(always)]
fn solve_normals<W: Wide, const BIAS: bool>(
    block: &mut ContactBlock,
    velocity: NormalRow<W>,
    displacement: NormalRow<W>,
    soft: &SoftRow<W>,
    pass: &ContactPass,
    impulse: &mut PairImpulse<W>,
) {
    let (inv_h, push) = (W::splat(pass.inv_substep), W::splat(-pass.push_velocity_max));
    let (zero, one, allowed) = (W::zero(), W::splat(1.0), W::splat(pass.allowed_error));
    let c = WideVector::load(&block.offset);
    let mut rows = [zero; MAX_MANIFOLD_POINTS];
    for k in 0..MAX_MANIFOLD_POINTS {
        rows[k] = velocity.at(W::load(&block.points[k].x), W::load(&block.points[k].y));
    }
    let mut coupling = 0;
    for k in 0..MAX_MANIFOLD_POINTS {
        let point = &mut block.points[k];
        let (x, y) = (W::load(&point.x), W::load(&point.y));
        let separation = W::load(&point.separation) + displacement.at(x, y);
        let apart = zero.lt(separation);
        let (bias, mass_scale, impulse_scale) = if BIAS {
            let error = (separation + allowed).min(zero);
            let overlapping = (error * soft.rate).max(push);
            (
                W::select(apart, separation * inv_h, overlapping),
                W::select(apart, one, soft.mass_scale),
                W::select(apart, zero, soft.impulse_scale),
            )
        } else {
            (W::select(apart, separation * inv_h, zero), one, zero)
        };
        let old = W::load(&point.impulse);
        let wanted = W::load(&point.mass) * (rows[k] * mass_scale + bias) + old * impulse_scale;
        let new = (old - wanted).max(zero);
        let added = new - old;
        new.store(&mut point.impulse);
        impulse.add_normal(added, x, y, c);
        for row in &mut rows[k + 1..] {
            *row = *row + W::load(&block.coupling[coupling]) * added;
            coupling += 1;
        }
    }
}

/// Makes the points that hit separate at `restitution` times the speed at which they came.
///
/// Done once after the last substep, so that it cannot fight the bias. Points that approached more
/// slowly than the threshold, or that no impulse ever stopped, are left alone: else resting bodies
/// would hop.
///
/// # Safety
/// Nobody else may touch the states of the block's bodies meanwhile.
#[inline(always)]
pub(crate) unsafe fn restitute<W: Wide>(
    block: &mut ContactBlock,
    states: &DisjointMut<BodyState>,
    pass: &ContactPass,
) {
    if block.restitution == Lane::ZERO {
        return;
    }
    // SAFETY: the caller's promise.
    let bodies = unsafe { gather_bodies::<W>(states, block) };
    let frame = Frame::load(block);
    let c = WideVector::load(&block.offset);
    let velocity = NormalRow::new(&frame, c, bodies.velocities);
    let (zero, threshold) = (W::zero(), W::splat(-pass.restitution_threshold));
    let restitution = W::load(&block.restitution);
    let mut impulse = PairImpulse::zero();
    let mut rows = [zero; MAX_MANIFOLD_POINTS];
    for k in 0..MAX_MANIFOLD_POINTS {
        rows[k] = velocity.at(W::load(&block.points[k].x), W::load(&block.points[k].y));
    }
    let mut coupling = 0;
    for k in 0..MAX_MANIFOLD_POINTS {
        let approach = W::load(&block.approach[k]);
        let total = W::load(&block.totals[k]);
        let point = &mut block.points[k];
        let hit = approach.lt(threshold) & zero.lt(total) & zero.lt(restitution);
        let old = W::load(&point.impulse);
        let wanted = W::load(&point.mass) * (rows[k] + restitution * approach);
        let new = W::select(hit, (old - wanted).max(zero), old);
        let added = new - old;
        new.store(&mut point.impulse);
        (total + added).store(&mut block.totals[k]);
        impulse.add_normal(added, W::load(&point.x), W::load(&point.y), c);
        for row in &mut rows[k + 1..] {
            *row = *row + W::load(&block.coupling[coupling]) * added;
            coupling += 1;
        }
    }
    // SAFETY: the caller's promise.
    unsafe { apply(states, block, &frame, &impulse, bodies.velocities) };
}
