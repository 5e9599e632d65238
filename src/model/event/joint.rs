//! Joints that broke.

use crate::dim::math::Real;
use crate::model::body::RigidBodyHandle;
use crate::model::joint::ImpulseJointHandle;

/// A joint broke: it bore more than its
/// [thresholds](crate::model::joint::GenericJoint::set_break_thresholds), and is disabled now.
#[derive(Copy, Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct JointBreakEvent {
    /// The joint. It stays in its set until it is removed.
    pub joint: ImpulseJointHandle,
    /// The first body that it held.
    pub body1: RigidBodyHandle,
    /// The second body that it held.
    pub body2: RigidBodyHandle,
    /// The force that it bore (mean of the step).
    pub force: Real,
    /// The torque that it bore (mean of the step).
    pub torque: Real,
}
