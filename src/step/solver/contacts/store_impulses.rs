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
    let (zero, withheld) = (W::zero(), W::splat(withheld));
    let (friction, torsion) = block.friction_impulses::<W>();
    let torsion = torsion + W::load(&input.torsional_impulse) * withheld;
    let mut report = WideReport::new(WideVector::load(&block.normal), friction, torsion);
    let friction = friction + WideVector::load(&input.friction_impulse) * withheld;
    for (k, (row, kept)) in block.points.iter().zip(&mut input.impulses).enumerate() {
        let impulse = W::load(&row.impulse);
        let whole = impulse + W::load(kept) * withheld;
        let whole = W::select(zero.lt(impulse), whole, impulse);
        let impulses = [W::load(&block.totals[k]), whole];
        report.set_point(k, WideVector::load(&block.places[k]), W::load(&row.separation), impulses);
        whole.store(kept);
    }
    let is_sound = report.find_sound();
    WideVector::select(is_sound, friction, WideVector::zero()).store(&mut input.friction_impulse);
    W::select(is_sound, torsion, zero).store(&mut input.torsional_impulse);
    for kept in &mut input.impulses {
        W::select(is_sound, W::load(kept), zero).store(kept);
    }
    if let Some(rows) = coulomb {
        rows.store_impulses(&mut input.tangent_impulses, withheld);
    }
    report.write(reports);
}
