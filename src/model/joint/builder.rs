//! Describes a joint in full generality before it is made.

use super::{GenericJoint, MotorModel, SpringCoefficients};
use crate::dim::joint_axes::{JointAxesMask, JointAxis};
use crate::dim::math::{Pose, Real, Vector};

/// Describes a [`GenericJoint`]. Values that no simulation could survive are refused as by its setters.
#[derive(Copy, Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
#[must_use = "a builder does nothing until its joint is built or inserted"]
pub struct GenericJointBuilder(pub GenericJoint);

/// Builder methods that hand their arguments to a setter of the joint.
macro_rules! hand_over {
    ($($(#[$doc:meta])* $name:ident => $setter:ident($($argument:ident: $type:ty),*);)*) => {$(
        $(#[$doc])*
        pub fn $name(mut self, $($argument: $type),*) -> Self {
            self.0.$setter($($argument),*);
            self
        }
    )*};
}

impl GenericJointBuilder {
    /// A joint that locks some axes and leaves the others free.
    pub fn new(locked_axes: JointAxesMask) -> Self {
        Self(GenericJoint::new(locked_axes))
    }

    /// Sets which axes are locked.
    pub fn locked_axes(mut self, axes: JointAxesMask) -> Self {
        self.0.locked_axes = axes;
        self
    }

    /// Sets which axes are measured together: as one distance, or one angle.
    pub fn coupled_axes(mut self, axes: JointAxesMask) -> Self {
        self.0.coupled_axes = axes;
        self
    }

    /// Sets the user data.
    pub fn user_data(mut self, data: u128) -> Self {
        self.0.user_data = data;
        self
    }

    hand_over! {
        /// Sets the joint's frame on the first body, in that body's frame.
        local_frame1 => set_local_frame1(frame: Pose);
        /// Sets the joint's frame on the second body, in that body's frame.
        local_frame2 => set_local_frame2(frame: Pose);
        /// Sets the joint's first axis on the first body, in that body's frame.
        local_axis1 => set_local_axis1(axis: Vector);
        /// Sets the joint's first axis on the second body, in that body's frame.
        local_axis2 => set_local_axis2(axis: Vector);
        /// Sets where the joint holds the first body, in that body's frame.
        local_anchor1 => set_local_anchor1(anchor: Vector);
        /// Sets where the joint holds the second body, in that body's frame.
        local_anchor2 => set_local_anchor2(anchor: Vector);
        /// Says whether the two bodies' colliders touch each other.
        contacts_enabled => set_contacts_enabled(enabled: bool);
        /// Makes the locked axes a spring.
        softness => set_softness(softness: Option<SpringCoefficients>);
        /// Sets the force or torque at which the joint breaks.
        break_thresholds => set_break_thresholds(force: Real, torque: Real);
        /// Says how far an axis reaches.
        limits => set_limits(axis: JointAxis, limits: [Real; 2]);
        /// Sets the motor model of an axis.
        motor_model => set_motor_model(axis: JointAxis, model: MotorModel);
        /// Drives an axis at a velocity.
        motor_velocity => set_motor_velocity(axis: JointAxis, target_vel: Real, factor: Real);
        /// Drives an axis to a position.
        motor_position => set_motor_position(
            axis: JointAxis, target_pos: Real, stiffness: Real, damping: Real
        );
        /// Drives an axis to a position and at a velocity.
        set_motor => set_motor(
            axis: JointAxis, target_pos: Real, target_vel: Real, stiffness: Real, damping: Real
        );
        /// Sets the largest force (or torque) of an axis's motor.
        motor_max_force => set_motor_max_force(axis: JointAxis, max_force: Real);
    }

    /// The joint.
    #[must_use]
    pub fn build(self) -> GenericJoint {
        self.0
    }
}

impl From<GenericJointBuilder> for GenericJoint {
    fn from(builder: GenericJointBuilder) -> Self {
        builder.0
    }
}
