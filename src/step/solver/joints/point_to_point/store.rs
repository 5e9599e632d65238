//! Stores point-to-point joints: once per step.

use super::block::PointToPointBlock;
use crate::dim::math::{ANG_ZERO, DIM, Real};
use crate::model::joint::ImpulseJoint;

/// Writes one lane of a block back to the joint.
pub(super) fn store_lane(
    block: &PointToPointBlock,
    lane: usize,
    joint: &mut ImpulseJoint,
    inv_dt: Real,
) {
    let impulse = block.impulse.lane(lane);
    (0..DIM).for_each(|k| joint.impulses[k] = impulse[k]);
    (joint.force, joint.torque) = (block.total.lane(lane) * inv_dt, ANG_ZERO);
    if !(impulse.is_finite() && joint.force.is_finite()) {
        joint.clear_impulses();
    }
}
