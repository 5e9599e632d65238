//! Macros for the common methods of named joints.
//!
//! A named joint is a [`GenericJoint`](super::GenericJoint) with chosen locked axes, and methods for its free
//! axes.

/// A named joint, its builder, and the conversions of both to the generic joint.
macro_rules! joint_kind {
    ($(#[$doc:meta])* $joint:ident, $builder:ident) => {
        $(#[$doc])*
        #[derive(Copy, Clone, Debug, PartialEq)]
        #[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
        #[repr(transparent)]
        pub struct $joint {
            /// The generic joint that this joint wraps.
            pub data: $crate::model::joint::GenericJoint,
        }

        #[doc = concat!("Describes a [`", stringify!($joint), "`].")]
        #[derive(Copy, Clone, Debug, PartialEq)]
        #[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
        #[must_use = "a builder does nothing until its joint is built or inserted"]
        pub struct $builder(pub $joint);

        impl $joint {
            /// The generic joint that this joint wraps.
            pub fn data(&self) -> &$crate::model::joint::GenericJoint {
                &self.data
            }

            /// The generic joint.
            #[allow(
                clippy::should_implement_trait,
                reason = "so that `joint.into()` needs no type; `From` does the same"
            )]
            pub fn into(self) -> $crate::model::joint::GenericJoint {
                self.data
            }
        }

        $crate::model::joint::kind::joint_methods! {
            $joint, $builder;
            /// Anchor on the first body, in that body's frame.
            local_anchor1() -> crate::dim::math::Vector;
            /// Sets the anchor on the first body, in that body's frame (length units).
            local_anchor1, set_local_anchor1(anchor: crate::dim::math::Vector);
            /// Anchor on the second body, in that body's frame.
            local_anchor2() -> crate::dim::math::Vector;
            /// Sets the anchor on the second body, in that body's frame (length units).
            local_anchor2, set_local_anchor2(anchor: crate::dim::math::Vector);
            /// Returns whether the colliders of the two bodies collide with each other.
            contacts_enabled() -> bool;
            /// Sets whether the colliders of the two bodies collide with each other.
            contacts_enabled, set_contacts_enabled(enabled: bool);
        }
        $crate::model::joint::kind::joint_methods! {
            $joint, $builder;
            /// Softness of the locked axes.
            softness() -> $crate::model::joint::JointSoftness;
            /// Sets the softness of the locked axes: a spring, or `None` for the stiffest joint of the
            /// solver.
            softness, set_softness(softness: impl Into<$crate::model::joint::JointSoftness>);
            /// Sets the force (first number) and torque (second number) above which the joint breaks: see
            /// [`GenericJoint::set_break_thresholds`](crate::dynamics::GenericJoint::set_break_thresholds).
            break_thresholds, set_break_thresholds(
                force: $crate::dim::math::Real, torque: $crate::dim::math::Real
            );
        }

        // SAFETY: the struct above is transparent, and has no rules of its own.
        unsafe impl $crate::model::joint::views::Named for $joint {}

        impl $builder {
            /// The joint.
            #[must_use]
            pub fn build(self) -> $joint {
                self.0
            }

            /// The generic joint.
            #[allow(
                clippy::should_implement_trait,
                reason = "so that `builder.into()` needs no type; `From` does the same"
            )]
            pub fn into(self) -> $crate::model::joint::GenericJoint {
                self.0.data
            }
        }

        impl From<$joint> for $crate::model::joint::GenericJoint {
            fn from(joint: $joint) -> Self {
                joint.data
            }
        }

        impl From<$builder> for $crate::model::joint::GenericJoint {
            fn from(builder: $builder) -> Self {
                builder.0.data
            }
        }

        impl From<$builder> for $joint {
            fn from(builder: $builder) -> Self {
                builder.0
            }
        }
    };
}

/// Methods that hand their arguments to the generic joint: getters of the joint, setters of the joint and of
/// its builder. The bracketed arguments before the semicolon are passed first.
macro_rules! joint_methods {
    ($joint:ident, $builder:ident $([$($first:expr),*])?;) => {};
    (
        $joint:ident, $builder:ident $([$($first:expr),*])?;
        $(#[$doc:meta])* $getter:ident($($argument:ident: $type:ty),*) -> $result:ty;
        $($rest:tt)*
    ) => {
        impl $joint {
            $(#[$doc])*
            pub fn $getter(&self, $($argument: $type),*) -> $result {
                self.data.$getter($($($first,)*)? $($argument),*)
            }
        }
        $crate::model::joint::kind::joint_methods! {
            $joint, $builder $([$($first),*])?; $($rest)*
        }
    };
    (
        $joint:ident, $builder:ident $([$($first:expr),*])?;
        $(#[$doc:meta])* $building:ident, $setter:ident($($argument:ident: $type:ty),* $(,)?);
        $($rest:tt)*
    ) => {
        impl $joint {
            $(#[$doc])*
            pub fn $setter(&mut self, $($argument: $type),*) -> &mut Self {
                self.data.$setter($($($first,)*)? $($argument),*);
                self
            }
        }
        impl $builder {
            $(#[$doc])*
            pub fn $building(mut self, $($argument: $type),*) -> Self {
                self.0.$setter($($argument),*);
                self
            }
        }
        $crate::model::joint::kind::joint_methods! {
            $joint, $builder $([$($first),*])?; $($rest)*
        }
    };
}

/// The joint's axis on each of its bodies.
macro_rules! joint_axis_methods {
    ($joint:ident, $builder:ident) => {
        $crate::model::joint::kind::joint_methods! {
            $joint, $builder;
            /// The joint's axis on the first body, in that body's frame: of unit length.
            local_axis1() -> crate::dim::math::Vector;
            /// Sets the joint's axis on the first body, in that body's frame. Its length does not matter.
            local_axis1, set_local_axis1(axis: crate::dim::math::Vector);
            /// The joint's axis on the second body, in that body's frame: of unit length.
            local_axis2() -> crate::dim::math::Vector;
            /// Sets the joint's axis on the second body, in that body's frame. Its length does not matter.
            local_axis2, set_local_axis2(axis: crate::dim::math::Vector);
        }
    };
}

/// The joint's frame on each of its bodies.
macro_rules! joint_frame_methods {
    ($joint:ident, $builder:ident) => {
        $crate::model::joint::kind::joint_methods! {
            $joint, $builder;
            /// Sets the joint's frame on the first body, in that body's frame.
            local_frame1, set_local_frame1(frame: crate::dim::math::Pose);
            /// Sets the joint's frame on the second body, in that body's frame.
            local_frame2, set_local_frame2(frame: crate::dim::math::Pose);
        }
        impl $joint {
            /// The joint's frame on the first body, in that body's frame.
            pub fn local_frame1(&self) -> crate::dim::math::Pose {
                self.data.local_frame1
            }

            /// The joint's frame on the second body, in that body's frame.
            pub fn local_frame2(&self) -> crate::dim::math::Pose {
                self.data.local_frame2
            }
        }
    };
}

/// The motor of the one free axis, or (without an axis) of the axis that the caller names.
macro_rules! joint_motor_methods {
    ($joint:ident, $builder:ident, [$($axis:expr)?], ($($name:ident: $type:ty)?)) => {
        $crate::model::joint::kind::joint_methods! {
            $joint, $builder [$($axis)?];
            /// The motor; `None` if there is none.
            motor($($name: $type)?) -> Option<&$crate::model::joint::JointMotor>;
            /// Sets the motor model.
            motor_model, set_motor_model(
                $($name: $type,)? model: $crate::model::joint::MotorModel
            );
            /// Drives the axis at a velocity (length/s or rad/s); `factor` is the damping of the motor.
            motor_velocity, set_motor_velocity(
                $($name: $type,)? target_vel: $crate::dim::math::Real, factor: $crate::dim::math::Real
            );
            /// Drives the axis to a position (length units or radians), like a spring with a damper.
            motor_position, set_motor_position(
                $($name: $type,)? target_pos: $crate::dim::math::Real,
                stiffness: $crate::dim::math::Real, damping: $crate::dim::math::Real
            );
            /// Drives the axis to a position with `stiffness`, and at a velocity with `damping`.
            set_motor, set_motor(
                $($name: $type,)? target_pos: $crate::dim::math::Real,
                target_vel: $crate::dim::math::Real,
                stiffness: $crate::dim::math::Real, damping: $crate::dim::math::Real
            );
            /// Sets the largest force (or torque) of the motor.
            motor_max_force, set_motor_max_force(
                $($name: $type,)? max_force: $crate::dim::math::Real
            );
        }
        impl $builder {
            /// The same as [`Self::set_motor`].
            pub fn motor(
                self,
                $($name: $type,)?
                target_pos: $crate::dim::math::Real,
                target_vel: $crate::dim::math::Real,
                stiffness: $crate::dim::math::Real,
                damping: $crate::dim::math::Real,
            ) -> Self {
                self.set_motor($($name,)? target_pos, target_vel, stiffness, damping)
            }
        }
    };
}

/// Limits and motor of the one free axis, or (without an axis) of the axis that the caller names.
macro_rules! joint_drive_methods {
    ($joint:ident, $builder:ident, [$($axis:expr)?], ($($name:ident: $type:ty)?)) => {
        $crate::model::joint::kind::joint_methods! {
            $joint, $builder [$($axis)?];
            /// The range of the axis (length units or radians); `None` without limits.
            limits($($name: $type)?) -> Option<&$crate::model::joint::JointLimits>;
            /// Sets the range of the axis (length units or radians).
            limits, set_limits($($name: $type,)? limits: [$crate::dim::math::Real; 2]);
        }
        $crate::model::joint::kind::joint_motor_methods!(
            $joint, $builder, [$($axis)?], ($($name: $type)?)
        );
    };
}

pub(crate) use {
    joint_axis_methods, joint_drive_methods, joint_frame_methods, joint_kind, joint_methods,
    joint_motor_methods,
};
