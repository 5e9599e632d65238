//! The motor of a free axis of a joint.

use super::InvalidJoint;
use crate::dim::math::Real;

/// The unit of a motor's stiffness and damping.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub enum MotorModel {
    /// They give accelerations: the solver multiplies them by the effective mass (or inertia) of the joint's
    /// own two bodies. The motion is independent of their masses. The inertia behind other joints is
    /// excluded. The motor at the root of an arm with `n` times the inertia of its first link needs `n` times
    /// the stiffness and damping.
    #[default]
    AccelerationBased,
    /// They give forces (or torques). Heavier bodies move more slowly.
    ForceBased,
}

impl MotorModel {
    /// Coefficients of a motor with this stiffness and damping in a step of `dt` seconds. The first number is
    /// the fraction of the distance per second. The second is the compliance of
    /// [acceleration-based](Self::AccelerationBased) motors, in units of the inverse mass that they move. The
    /// third is the compliance of [force-based](Self::ForceBased) motors. One of the two is 0.
    ///
    /// ```
    /// # use rapier3d::prelude::*;
    /// let (rate, compliance, _) = MotorModel::AccelerationBased.combine_coefficients(0.1, 100.0, 10.0);
    /// assert_eq!((rate, compliance), (5.0, 0.5)); // k / (dt k + c), 1 / (dt (dt k + c))
    /// ```
    pub fn combine_coefficients(
        self,
        dt: Real,
        stiffness: Real,
        damping: Real,
    ) -> (Real, Real, Real) {
        let inverse = |value: Real| if value == 0.0 { 0.0 } else { 1.0 / value };
        let resistance = dt * stiffness + damping;
        let rate = stiffness * inverse(resistance);
        let compliance = inverse(dt * resistance);
        match self {
            Self::AccelerationBased => (rate, compliance, 0.0),
            Self::ForceBased => (rate, 0.0, compliance),
        }
    }
}

/// The motor of a free axis, which drives it to a position or at a velocity:
///
/// ```text
/// force = stiffness · (target_pos - position) + damping · (target_vel - velocity)
/// ```
///
/// within `±max_force`. Positions are lengths on axes of translation, and radians on axes of rotation, where
/// the force is a torque.
#[derive(Copy, Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct JointMotor {
    /// The target velocity (length/s or rad/s).
    pub target_vel: Real,
    /// The target position (length units or radians).
    pub target_pos: Real,
    /// Force (or acceleration) per unit of distance from the target position.
    pub stiffness: Real,
    /// Force (or acceleration) per unit of difference from the target velocity.
    pub damping: Real,
    /// The largest force, or torque, of the motor.
    pub max_force: Real,
    /// Impulse of the motor in the last substep (mass·length/s or mass·length²/s). The next step starts with
    /// it.
    pub impulse: Real,
    /// Unit of stiffness and damping.
    pub model: MotorModel,
}

impl Default for JointMotor {
    fn default() -> Self {
        Self {
            target_vel: 0.0,
            target_pos: 0.0,
            stiffness: 0.0,
            damping: 0.0,
            max_force: Real::MAX,
            impulse: 0.0,
            model: MotorModel::AccelerationBased,
        }
    }
}

impl JointMotor {
    /// Returns whether it may do positive work on its bodies. A damper that stops its axis does none.
    pub(crate) fn does_work(&self) -> bool {
        let drives = self.stiffness > 0.0 || self.damping * self.target_vel != 0.0;
        drives && self.max_force > 0.0
    }

    /// Returns whether all numbers are usable.
    pub(crate) fn check(&self) -> Result<(), InvalidJoint> {
        let finite = |parameter, value: Real| match value.is_finite() {
            true => Ok(()),
            false => Err(InvalidJoint::Number { parameter, value, expected: "finite" }),
        };
        finite("the target velocity of a motor", self.target_vel)?;
        finite("the target position of a motor", self.target_pos)?;
        check_factor("the stiffness of a motor", self.stiffness)?;
        check_factor("the damping of a motor", self.damping)?;
        check_threshold("the maximum force of a motor", self.max_force)
    }
}

/// A number that is finite and not negative.
pub(super) fn check_factor(parameter: &'static str, value: Real) -> Result<(), InvalidJoint> {
    if value.is_finite() && value >= 0.0 {
        return Ok(());
    }
    Err(InvalidJoint::Number { parameter, value, expected: "finite and not negative" })
}

/// A number that is not negative, and may be infinite.
pub(super) fn check_threshold(parameter: &'static str, value: Real) -> Result<(), InvalidJoint> {
    let expected = "not negative";
    if value >= 0.0 { Ok(()) } else { Err(InvalidJoint::Number { parameter, value, expected }) }
}
