//! How far a free axis of a joint reaches.

use super::InvalidJoint;
use crate::dim::joint_axes::JointAxis;
use crate::dim::math::Real;

/// How far a free axis of a joint reaches: a range of lengths, or of angles in radians.
///
/// Angles are counted on beyond half a turn where a joint has one free axis of rotation, so a range may
/// span several turns, or be somewhere else than around zero. `Real::MAX` (or more) is no limit on that
/// side.
#[derive(Copy, Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct JointLimits<N = Real> {
    /// The lower end of the range.
    pub min: N,
    /// The upper end of the range.
    pub max: N,
    /// The impulse with which the limit pushed in the last substep: positive at the lower end, negative
    /// at the upper one. The next step starts with it.
    pub impulse: N,
}

impl Default for JointLimits {
    fn default() -> Self {
        Self { min: -Real::MAX, max: Real::MAX, impulse: 0.0 }
    }
}

impl From<[Real; 2]> for JointLimits {
    fn from([min, max]: [Real; 2]) -> Self {
        Self { min, max, impulse: 0.0 }
    }
}

impl JointLimits {
    /// Is there anything between the two ends?
    pub(crate) fn check(&self, axis: JointAxis) -> Result<(), InvalidJoint> {
        let Self { min, max, .. } = *self;
        // NaN is on neither side of anything.
        let ordered = min <= max && min < Real::INFINITY && max > -Real::INFINITY;
        if ordered { Ok(()) } else { Err(InvalidJoint::Limits { axis, min, max }) }
    }
}
