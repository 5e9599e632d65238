//! Rules that joints between bodies and joints of multibodies share.

use crate::dim::math::{Real, ang_length_squared};
use crate::model::event::JointBreakEvent;
use crate::model::joint::{ImpulseJoint, ImpulseJointHandle, JointEnabled};

/// Largest curvature of a free axis in a substep, as a fraction of its speed. A chord deviates from a circle
/// by half of the arc angle. This is half a radian, up to which one step towards the end of the substep
/// converges.
pub(super) const CURVATURE_FRACTION_MAX: Real = 0.25;

/// The fraction of a limit's error that a substep removes, where connected limits are solved together.
/// Contacts pass the velocity of a correction on: with 1, a bridge of ropes threw a load of 1,000 kg up by 30
/// cm.
pub(super) const EXACT_LIMIT_ERROR_FRACTION: Real = 0.1;

/// Returns whether the load of a joint exceeds its limit.
pub(super) fn is_overloaded(joint: &ImpulseJoint) -> bool {
    let (force, torque) = load_of(joint);
    !(force <= joint.data.break_force && torque <= joint.data.break_torque)
}

fn load_of(joint: &ImpulseJoint) -> (Real, Real) {
    (joint.force.length(), ang_length_squared(joint.torque).sqrt())
}

/// Breaks an overloaded joint, and reports it.
pub(super) fn break_if_overloaded(
    handle: ImpulseJointHandle,
    joint: &mut ImpulseJoint,
) -> Option<JointBreakEvent> {
    if !is_overloaded(joint) {
        return None;
    }
    let (force, torque) = load_of(joint);
    joint.data.enabled = JointEnabled::Disabled;
    let (body1, body2) = (joint.body1(), joint.body2());
    Some(JointBreakEvent { joint: handle, body1, body2, force, torque })
}
