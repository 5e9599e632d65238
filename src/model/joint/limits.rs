//! Range of a free axis of a joint.

use super::InvalidJoint;
use crate::dim::joint_axes::JointAxis;
use crate::dim::math::Real;

const TURN: Real = 2.0 * core::f64::consts::PI as Real;

/// Largest violation (rad) of an angle limit by an initial pose. Beyond it, the angle is taken to be in
/// another turn.
const ANGLE_TOLERANCE: Real = 0.5;

/// Range of a free axis of a joint: of lengths, or of angles in radians.
///
/// Angles of joints with one free axis of rotation are continuous beyond half a turn, so a range may span
/// several turns, or lie anywhere. `Real::MAX` or more disables the limit on that side.
#[derive(Copy, Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct JointLimits<N = Real> {
    /// The lower end of the range.
    pub min: N,
    /// The upper end of the range.
    pub max: N,
    /// The impulse of the limit in the last substep (mass·length/s or mass·length²/s): positive at the lower
    /// end, negative at the upper end. The next step starts with this impulse.
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
    /// The turn count of a first measured angle (in `-π..=π`) brings it between the limits. An angle of 3.25
    /// rad between 2.5 and 4 is measured as such, and not as -3.03. If several values are between the limits,
    /// the function returns the one nearest to zero. If none is, it returns the one with the smallest
    /// violation.
    pub(crate) fn first_reading(&self, angle: Real) -> Real {
        let (min, max) = (self.min - ANGLE_TOLERANCE, self.max + ANGLE_TOLERANCE);
        let turns = if angle < min {
            ((min - angle) / TURN).ceil()
        } else if angle > max {
            ((max - angle) / TURN).floor()
        } else {
            return angle;
        };
        let outside = |angle: Real| (self.min - angle).max(angle - self.max);
        let inside = angle + turns * TURN;
        let before = inside - TURN.copysign(turns);
        if outside(inside) <= outside(before) { inside } else { before }
    }

    /// Returns whether the range is not empty.
    pub(crate) fn check(&self, axis: JointAxis) -> Result<(), InvalidJoint> {
        let Self { min, max, .. } = *self;
        // NaN is on neither side of anything.
        let ordered = min <= max && min < Real::INFINITY && max > -Real::INFINITY;
        if ordered { Ok(()) } else { Err(InvalidJoint::Limits { axis, min, max }) }
    }
}

/// The angle plus that number of turns that brings it nearest to the last one. The sum overflows if the last
/// one is near the largest number: then the turns are not counted on.
pub(crate) fn nearest_turn(angle: Real, last: Real) -> Real {
    let nearest = angle + ((last - angle) / TURN).round() * TURN;
    if nearest.is_finite() { nearest } else { angle }
}
