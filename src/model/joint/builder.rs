//! The builder of generic joints.

use super::{GenericJoint, JointSoftness, MotorModel};
use crate::dim::joint_axes::{JointAxesMask, JointAxis};
use crate::dim::math::{Pose, Real, Vector};

/// Description of a [`GenericJoint`]. Its methods refuse unusable values as the setters of the joint do.
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

    /// Sets the locked axes.
    pub fn locked_axes(mut self, axes: JointAxesMask) -> Self {
        self.0.locked_axes = axes;
        self
    }

    /// Sets the axes that are measured together, as one distance or one angle.
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
        /// Sets the anchor on the first body, in that body's frame (length units).
        local_anchor1 => set_local_anchor1(anchor: Vector);
        /// Sets the anchor on the second body, in that body's frame (length units).
        local_anchor2 => set_local_anchor2(anchor: Vector);
        /// Sets whether the colliders of the two bodies collide with each other.
        contacts_enabled => set_contacts_enabled(enabled: bool);
        /// Sets the softness of the locked axes: a spring, or `None` for the stiffest joint.
        softness => set_softness(softness: impl Into<JointSoftness>);
        /// Sets the force and the torque above which the joint breaks.
        break_thresholds => set_break_thresholds(force: Real, torque: Real);
        /// Sets the range of an axis (length units or radians).
        limits => set_limits(axis: JointAxis, limits: [Real; 2]);
        /// Sets the motor model of an axis.
        motor_model => set_motor_model(axis: JointAxis, model: MotorModel);
        /// Drives an axis at a velocity (length/s or rad/s). `factor` is the damping of the motor.
        motor_velocity => set_motor_velocity(axis: JointAxis, target_vel: Real, factor: Real);
        /// Drives an axis to a position (length units or radians), like a spring with a damper.
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
