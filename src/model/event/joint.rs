//! Joints that broke.

use crate::dim::math::Real;
use crate::model::body::RigidBodyHandle;
use crate::model::joint::ImpulseJointHandle;

/// A joint broke: its load exceeded its
/// [thresholds](crate::model::joint::GenericJoint::set_break_thresholds), and it is disabled now.
#[derive(Copy, Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct JointBreakEvent {
    /// The joint. It stays in its set until it is removed.
    pub joint: ImpulseJointHandle,
    /// Its first body.
    pub body1: RigidBodyHandle,
    /// Its second body.
    pub body2: RigidBodyHandle,
    /// Its force (mean of the step).
    pub force: Real,
    /// Its torque (mean of the step).
    pub torque: Real,
}
