//! From constraints back to joints.

use super::block::{AxisRow, JointBlock};
use crate::dim::joint::set_couple;
use crate::dim::math::{DIM, Real, ang_length_squared};
use crate::dim::wide::ang_lane;
use crate::model::event::JointBreakEvent;
use crate::model::joint::{ImpulseJoint, ImpulseJointHandle, JointEnabled};

/// Writes one lane of a block, and of its rows, back to the joint.
pub(super) fn store_lane(
    block: &JointBlock,
    rows: &[AxisRow],
    lane: usize,
    joint: &mut ImpulseJoint,
    inv_dt: Real,
) {
    for (impulse, lanes) in joint.impulses.iter_mut().zip(&block.impulses[..DIM]) {
        *impulse = lanes.0[lane];
    }
    set_couple(&mut joint.impulses, ang_lane(&block.couple, lane));
    for (axis, row) in joint.data.driven_axes().zip(rows) {
        let k = axis as usize;
        joint.data.limits[k].impulse = row.lower.0[lane] - row.upper.0[lane];
        joint.data.motors[k].impulse = row.motor.impulse.0[lane];
    }
    joint.force = block.total_impulse.lane(lane) * inv_dt;
    joint.torque = ang_lane(&block.total_moment, lane) * inv_dt;
    if !joint.is_sound() {
        joint.forget_impulses();
    }
}

/// Breaks a joint that bore more than it can, and says so.
pub(in crate::step::solver) fn break_if_overloaded(
    handle: ImpulseJointHandle,
    joint: &mut ImpulseJoint,
) -> Option<JointBreakEvent> {
    let (force, torque) = (joint.force.length(), ang_length_squared(joint.torque).sqrt());
    if force <= joint.data.break_force && torque <= joint.data.break_torque {
        return None;
    }
    joint.data.enabled = JointEnabled::Disabled;
    let (body1, body2) = (joint.body1(), joint.body2());
    Some(JointBreakEvent { joint: handle, body1, body2, force, torque })
}
