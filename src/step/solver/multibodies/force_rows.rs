//! Motors with a largest force, and dry friction, of one degree of freedom: see `limits.rs`.

use super::limits::Owner;
use super::rows::{ConstrainedStates, JacobianPool, Row};
use super::system::{EQUATION_COMPLIANCE_MIN, MOTOR_COMPLIANCE_MIN};
use crate::dim::joint_axes::JointAxis;
use crate::dim::math::Real;
use crate::model::joint::{JointMotor, MotorModel};
use crate::step::solver::axis_law::AxisLaw;

/// A motor with a largest force, or friction.
#[derive(Copy, Clone, Debug)]
pub struct ForceRow {
    pub owner: Owner,
    pub axis: JointAxis,
    pub row: Row,
    pub is_friction: bool,
    /// Stiffness over `h k + d` (1/s): the increase of the target velocity per distance from the target.
    pull: Real,
    /// Distance to the target at the beginning of the step.
    distance: Real,
    /// Target velocity at the target position.
    velocity: Real,
    compliance: Real,
    pub impulse: Real,
    /// Sum of the impulses of the substeps.
    pub total: Real,
    impulse_max: Real,
}

impl ForceRow {
    pub fn motor(
        owner: Owner,
        axis: JointAxis,
        row: Row,
        q: Real,
        motor: &JointMotor,
        h: Real,
    ) -> Self {
        let inertia = match motor.model {
            MotorModel::AccelerationBased => row.mass,
            MotorModel::ForceBased => 1.0,
        };
        let (stiffness, damping) = (motor.stiffness * inertia, motor.damping * inertia);
        let resistance = h * stiffness + damping;
        let fraction = |of: Real| if resistance > 0.0 { of / resistance } else { 0.0 };
        let impulse_max = (motor.max_force * h).min(Real::MAX);
        Self {
            owner,
            axis,
            row: if resistance > 0.0 { row } else { Row { mass: 0.0, ..row } },
            is_friction: false,
            pull: fraction(stiffness),
            distance: motor.target_pos - q,
            velocity: fraction(damping) * motor.target_vel,
            compliance: fraction(1.0 / h),
            impulse: motor.impulse.clamp(-impulse_max, impulse_max),
            total: 0.0,
            impulse_max,
        }
    }

    pub fn friction(
        owner: Owner,
        axis: JointAxis,
        row: Row,
        impulse_max: Real,
        impulse: Real,
    ) -> Self {
        let impulse = impulse.clamp(-impulse_max, impulse_max);
        let (pull, distance, velocity, compliance) = (0.0, 0.0, 0.0, 0.0);
        Self {
            owner,
            axis,
            row,
            is_friction: true,
            pull,
            distance,
            velocity,
            compliance,
            impulse,
            total: 0.0,
            impulse_max,
        }
    }

    /// The law of the motor or of the friction.
    pub fn law(&self, jacobians: &JacobianPool, states: &ConstrainedStates<'_>) -> AxisLaw {
        if self.row.mass == 0.0 {
            return AxisLaw::FREE;
        }
        let moved = if self.pull > 0.0 { jacobians.displacement(&self.row, states) } else { 0.0 };
        let wanted = f64::from(self.velocity + self.pull * (self.distance - moved));
        let least = if self.is_friction { EQUATION_COMPLIANCE_MIN } else { MOTOR_COMPLIANCE_MIN };
        let compliance_min = least / f64::from(self.row.mass);
        let damping = 1.0 / f64::from(self.compliance).max(compliance_min);
        let bound = f64::from(self.impulse_max);
        AxisLaw { damping, pull: -wanted * damping, bound, ..AxisLaw::FREE }
    }
}
