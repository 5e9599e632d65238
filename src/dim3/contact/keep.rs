//! What is left of constraints when a step ends: once per step.

use super::block::ContactBlock;
use super::coulomb::CoulombBlock;
use crate::base::wide::{LANES, Wide, scatter};
use crate::dim3::math::MAX_MANIFOLD_POINTS;
use crate::dim3::wide::{WideVector, cross};
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
    let t1 = WideVector::<W>::load(&block.tangent);
    let [x, y, twist] = &block.friction.impulse;
    let (x, y, twist) = (W::load(x), W::load(y), W::load(twist));
    let friction = t1 * x + cross(n, t1) * y;
    let head = [n.x, n.y, n.z, friction.x, friction.y, friction.z, twist, zero];
    let mut numbers = [zero; ContactReport::LEN];
    let (first, of_points) = numbers.split_at_mut(head.len());
    first.copy_from_slice(&head);
    let rows = block.points.iter().zip(&block.places).zip(&block.totals);
    for (((row, place), total), numbers) in rows.zip(of_points.chunks_exact_mut(6)) {
        let of_point = [&place.x, &place.y, &place.z, &row.separation, total, &row.impulse];
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
    W::select(is_sound, twist, zero).store(&mut input.twist_impulse);
    for k in 0..MAX_MANIFOLD_POINTS {
        let impulse = W::load(&block.points[k].impulse);
        W::select(is_sound, impulse, zero).store(&mut input.impulses[k]);
    }
    if let Some(rows) = coulomb {
        rows.keep::<W>(&mut input.tangent_impulses);
    }
    scatter(numbers, reports.each_mut().map(|report| Some(report.numbers_mut())));
}
