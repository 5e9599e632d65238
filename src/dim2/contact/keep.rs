//! What is left of constraints when a step ends: once per step.

use super::block::ContactBlock;
use super::coulomb::CoulombBlock;
use crate::base::wide::{LANES, Wide, scatter};
use crate::dim2::math::MAX_MANIFOLD_POINTS;
use crate::dim2::wide::WideVector;
use crate::model::contact::{ContactInput, ContactReport};

/// Keeps the impulses of a block, with which its lanes start the next step, and tells of them, lane by lane.
///
/// A lane in which not all numbers stayed finite starts with none: its bodies would never get rid of them.
#[inline(always)]
pub(crate) fn keep<W: Wide>(
    block: &ContactBlock,
    coulomb: Option<&CoulombBlock>,
    input: &mut ContactInput,
    reports: &mut [ContactReport; LANES],
) {
    let (zero, n) = (W::zero(), WideVector::<W>::load(&block.normal));
    let friction = WideVector { x: n.y, y: -n.x } * W::load(&block.friction.impulse);
    let head = [n.x, n.y, friction.x, friction.y, zero, zero];
    let mut numbers = [zero; ContactReport::LEN];
    let (first, of_points) = numbers.split_at_mut(head.len());
    first.copy_from_slice(&head);
    let rows = block.points.iter().zip(&block.places).zip(&block.totals);
    for (((row, place), total), numbers) in rows.zip(of_points.chunks_exact_mut(5)) {
        let of_point = [&place.x, &place.y, &row.separation, total, &row.impulse];
        for (number, lane) in numbers.iter_mut().zip(of_point) {
            *number = W::load(lane);
        }
    }
    // Stays zero unless a number is not finite: 0·∞ and 0·NaN are NaN.
    let mut probe = zero;
    for number in numbers {
        probe = probe + zero * number;
    }
    let is_sound = probe.le(zero);
    numbers[ContactReport::IS_SOUND] = W::select(is_sound, W::splat(1.0), zero);
    WideVector::select(is_sound, friction, WideVector::zero()).store(&mut input.friction_impulse);
    for k in 0..MAX_MANIFOLD_POINTS {
        let impulse = W::load(&block.points[k].impulse);
        W::select(is_sound, impulse, zero).store(&mut input.impulses[k]);
    }
    // Links of multibodies have some, whatever the dimension.
    if coulomb.is_some() {
        input.tangent_impulses = Default::default();
    }
    scatter(numbers, reports.each_mut().map(|report| Some(report.numbers_mut())));
}
