//! Joints that broke.

use crate::dim::math::Real;
use crate::model::body::RigidBodyHandle;
use crate::model::joint::ImpulseJointHandle;

/// Event of a broken joint: its load exceeded its
/// [thresholds](crate::model::joint::GenericJoint::set_break_thresholds), and the step disabled it.
#[derive(Copy, Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct JointBreakEvent {
    /// The joint. It stays in its set until its removal by the user.
    pub joint: ImpulseJointHandle,
    /// Its first body.
    pub body1: RigidBodyHandle,
    /// Its second body.
    pub body2: RigidBodyHandle,
    /// Magnitude of its force (mean of the step, mass·length/s²).
    pub force: Real,
    /// Magnitude of its torque (mean of the step, mass·length²/s²).
    pub torque: Real,
}
