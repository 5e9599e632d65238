//! The driven rows of a block of joints: rows and laws of motors and limits.

use super::super::block::AxisRow;
use super::super::motors_and_limits::{FreeAxis, MotorLaw, rate_limits};
use super::super::substep_end::SubstepEnd;
use super::memory::{JacobianBlock, Moment, store_row};
use crate::base::wide::{Lane, Wide};
use crate::dim::math::SPATIAL_DIM;
use crate::model::params::JointPass;
use crate::step::solver::joint_rules::EXACT_LIMIT_ERROR_FRACTION;

/// One driven axis of each lane's joint: see `axis_law.rs`.
#[derive(Clone, Debug)]
pub(in super::super) struct DrivenRow {
    /// By body: the row `J`, with the sign of that body.
    pub row: [[Lane; SPATIAL_DIM]; 2],
    /// `J v`: in before the solution, out after.
    pub rate: Lane,
    pub damping: Lane,
    pub pull: Lane,
    pub bound: Lane,
    pub low: Lane,
    pub high: Lane,
    /// The parts of `low` and `high` that correct an exceeded limit.
    pub corrections: [Lane; 2],
    /// Impulses of the motor and at both limits: in, and out.
    pub motor: Lane,
    pub lower: Lane,
    pub upper: Lane,
    /// Out: the change of the total impulse.
    pub change: Lane,
}

impl DrivenRow {
    pub const EMPTY: Self = {
        let zero = Lane::ZERO;
        Self {
            row: [[zero; SPATIAL_DIM]; 2],
            rate: zero,
            damping: zero,
            pull: zero,
            bound: zero,
            low: zero,
            high: zero,
            corrections: [zero; 2],
            motor: zero,
            lower: zero,
            upper: zero,
            change: zero,
        }
    };

    /// The total impulse of a lane.
    pub(super) fn impulse(&self, lane: usize) -> f64 {
        let [motor, lower, upper] =
            [&self.motor, &self.lower, &self.upper].map(|lanes| f64::from(lanes.0[lane]));
        motor + lower - upper
    }
}

/// Computes the driven rows of a block, and their laws.
#[inline(always)]
pub(super) fn write_driven<'a, W: Wide>(
    memory: &JacobianBlock,
    rows: impl Iterator<Item = (&'a mut AxisRow, &'a mut DrivenRow)>,
    moment: &Moment<'_, W>,
) {
    let Moment { bodies, now, substep_end, pass } = moment;
    let zero = W::zero();
    for (row, to) in rows {
        let (mut along, position) = now.free_row(row);
        let mut rate = along.rate(&bodies.velocities);
        let mut curvature = zero;
        if let Some(end) = substep_end {
            let (then, position_then) = end.then.free_row(row);
            let bent = end.curvature(now, &along, position_then - position, rate, pass);
            let includes_curvature = zero.lt(W::load(&memory.includes_curvature));
            curvature = W::select(includes_curvature, bent, zero);
            let at_predicted_pose = zero.lt(W::load(&memory.at_predicted_pose));
            along = then.select(at_predicted_pose, along);
            // The rate at the end of the substep is the same with either row.
            let straight = rate;
            rate = along.rate(&bodies.velocities);
            curvature = curvature + (straight - rate);
        } else {
            position.store(&mut row.position);
        }
        let is_translation = SubstepEnd::is_translation(&along);
        store_row(&along, &mut to.row);
        rate.store(&mut to.rate);
        let axis = AxisNow { position, curvature, is_translation };
        write_law::<W>(memory, row, to, &axis, pass);
    }
}

/// A driven axis of each lane's joint at the moment when its law is made.
pub(in super::super) struct AxisNow<W: Wide> {
    pub position: W,
    /// The rate of the substep that its velocities do not have yet.
    pub curvature: W,
    /// Where its position is a length.
    pub is_translation: W::Mask,
}

/// Computes the law of a row.
#[inline(always)]
pub(in super::super) fn write_law<W: Wide>(
    memory: &JacobianBlock,
    row: &mut AxisRow,
    to: &mut DrivenRow,
    now: &AxisNow<W>,
    pass: &JointPass,
) {
    let &AxisNow { position, curvature, is_translation } = now;
    let axis = FreeAxis::new(position, W::load(&row.response));
    let law = MotorLaw::new(&mut row.motor, &axis, curvature, pass);
    let correction_rate = W::splat(EXACT_LIMIT_ERROR_FRACTION * pass.inv_substep);
    let ([low, high], corrections) =
        rate_limits::<W>(row, position, correction_rate, is_translation, pass);
    let apart = if pass.is_biased { W::load(&memory.is_corrected_apart) } else { W::zero() };
    law.damping.store(&mut to.damping);
    law.pull.store(&mut to.pull);
    law.bound.store(&mut to.bound);
    (low - corrections[0] * apart - curvature).store(&mut to.low);
    (high - corrections[1] * apart - curvature).store(&mut to.high);
    for (correction, to) in corrections.into_iter().zip(&mut to.corrections) {
        correction.store(to);
    }
    (to.motor, to.lower, to.upper) = (row.motor.impulse, row.lower, row.upper);
    to.change = Lane::ZERO;
}
