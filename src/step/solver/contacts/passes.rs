//! The passes over a block: solve and relax in each substep.

use super::soft_row::SoftRow;
use crate::base::disjoint::DisjointMut;
use crate::base::wide::Wide;
use crate::dim::contact::{
    ContactBlock, CoulombBlock, Frame, NormalImpulse, NormalRow, solve_friction as solve_rows,
};
use crate::dim::math::MAX_MANIFOLD_POINTS;
use crate::dim::state::{BodyState, WideMotion};
use crate::dim::wide::WideVector;
use crate::model::params::ContactPass;
use crate::step::solver::states::Bodies;

/// The normal rows with their bias: separates overlapping bodies, and lets separated ones approach up to
/// contact.
///
/// # Safety
/// The caller has exclusive access to the states of the block's bodies.
#[inline(always)]
pub(in crate::step::solver) unsafe fn solve<W: Wide>(
    block: &mut ContactBlock,
    states: &DisjointMut<BodyState>,
    pass: &ContactPass,
) {
    // SAFETY: the caller's promise.
    let mut bodies = unsafe { Bodies::<W>::gather(states, &block.bodies) };
    solve_normals::<W, true>(block, &mut bodies, pass);
    // SAFETY: the caller's promise.
    unsafe { bodies.scatter(states, &block.bodies) };
}

/// The normal rows without bias, which remove the velocity that the bias of the solve pass added, then
/// friction.
///
/// In this order friction is bounded by the impulses that carry the bodies. The impulses of the solve pass
/// are smaller while a soft contact is compressed, and larger while it removes overlap. With them a new box
/// slides 5 % too far.
///
/// # Safety
/// The caller has exclusive access to the states of the block's bodies.
#[inline(always)]
pub(in crate::step::solver) unsafe fn relax<W: Wide>(
    block: &mut ContactBlock,
    coulomb: Option<&mut CoulombBlock>,
    states: &DisjointMut<BodyState>,
    pass: &ContactPass,
) {
    // SAFETY: the caller's promise.
    let mut bodies = unsafe { Bodies::<W>::gather(states, &block.bodies) };
    solve_normals::<W, false>(block, &mut bodies, pass);
    bodies.velocities = solve_friction(block, coulomb, bodies.velocities);
    if pass.is_last_iteration {
        for k in 0..MAX_MANIFOLD_POINTS {
            let total = W::load(&block.totals[k]) + W::load(&block.points[k].impulse);
            total.store(&mut block.totals[k]);
        }
    }
    // SAFETY: the caller's promise.
    unsafe { bodies.scatter(states, &block.bodies) };
}

/// Solves the friction rows once, central ones or those of the points, under the normal impulses as they are.
#[inline(always)]
pub(in crate::step::solver) fn solve_friction<W: Wide>(
    block: &mut ContactBlock,
    coulomb: Option<&mut CoulombBlock>,
    velocities: [WideMotion<W>; 2],
) -> [WideMotion<W>; 2] {
    let mut normal_impulse = W::load(&block.points[0].impulse);
    for point in &block.points[1..] {
        normal_impulse = normal_impulse + W::load(&point.impulse);
    }
    solve_rows(block, coulomb, normal_impulse, velocities)
}

/// Gauss–Seidel over the points of each lane.
#[inline(always)]
fn solve_normals<W: Wide, const BIAS: bool>(
    block: &mut ContactBlock,
    bodies: &mut Bodies<W>,
    pass: &ContactPass,
) {
    let frame = Frame::load(block);
    let c = WideVector::load(&block.offset);
    let mut rows = values_at(block, NormalRow::new(&frame, c, bodies.velocities));
    let displacement = NormalRow::new(&frame, c, bodies.moved());
    let soft = SoftRow::<W>::new(pass);
    let mut sum = NormalImpulse::zero();
    let mut coupling = 0;
    for k in 0..MAX_MANIFOLD_POINTS {
        let point = &mut block.points[k];
        let place = point.place();
        let separation = W::load(&point.separation) + displacement.at(place);
        let old = W::load(&point.impulse);
        let wanted = soft.wanted::<BIAS>(rows[k], separation, W::load(&point.mass), old);
        let new = (old - wanted).max(W::zero());
        let added = new - old;
        new.store(&mut point.impulse);
        sum.add(added, place);
        for row in &mut rows[k + 1..] {
            *row = *row + W::load(&block.coupling[coupling]) * added;
            coupling += 1;
        }
    }
    bodies.velocities = sum.apply(block, &frame, bodies.velocities);
}

/// The relative normal velocities, or displacements, at the points.
#[inline(always)]
pub(in crate::step::solver) fn values_at<W: Wide>(
    block: &ContactBlock,
    row: NormalRow<W>,
) -> [W; MAX_MANIFOLD_POINTS] {
    let mut values = [W::zero(); MAX_MANIFOLD_POINTS];
    for (value, point) in values.iter_mut().zip(&block.points) {
        *value = row.at(point.place());
    }
    values
}
