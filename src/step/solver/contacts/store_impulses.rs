//! Stores contact constraints when a step ends: once per step.

use crate::base::wide::{LANES, Wide};
use crate::dim::contact::{ContactBlock, CoulombBlock};
use crate::dim::math::Real;
use crate::dim::wide::WideVector;
use crate::model::contact::{ContactInput, ContactReport, WideReport};

/// Stores the warm-start impulses of a block for the next step, and writes a report for each lane.
///
/// `withheld` is the share that the step did not start with, over the share that it did: the impulses are
/// those of longer steps ([`StepPace`](crate::model::island::StepPace)). A point without an impulse has none
/// left.
///
/// A lane in which not all numbers stayed finite starts with none: its bodies would never get rid of them.
#[inline(always)]
pub(in crate::step::solver) fn store_impulses<W: Wide>(
    block: &ContactBlock,
    coulomb: Option<&CoulombBlock>,
    input: &mut ContactInput,
    reports: &mut [ContactReport; LANES],
    withheld: Real,
) {
    let withheld = W::splat(withheld);
    let (zero, (friction, torsion)) = (W::zero(), block.friction_impulses::<W>());
    let mut report = WideReport::new(WideVector::load(&block.normal), friction, torsion);
    let rows = block.points.iter().zip(&block.places).zip(&block.totals);
    for (k, ((row, place), total)) in rows.enumerate() {
        let impulses = [W::load(total), W::load(&row.impulse)];
        report.set_point(k, WideVector::load(place), W::load(&row.separation), impulses);
    }
    let is_sound = report.find_sound();
    let friction = friction + WideVector::load(&input.friction_impulse) * withheld;
    WideVector::select(is_sound, friction, WideVector::zero()).store(&mut input.friction_impulse);
    let torsion = torsion + W::load(&input.torsional_impulse) * withheld;
    W::select(is_sound, torsion, zero).store(&mut input.torsional_impulse);
    for (row, kept) in block.points.iter().zip(&mut input.impulses) {
        let impulse = W::load(&row.impulse);
        let whole = impulse + W::load(kept) * withheld;
        W::select(is_sound & zero.lt(impulse), whole, zero).store(kept);
    }
    if let Some(rows) = coulomb {
        rows.store_impulses(&mut input.tangent_impulses, withheld);
    }
    report.write(reports);
}
