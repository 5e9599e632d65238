//! The spring between two points.

use super::kind::joint_kind;
use super::{GenericJoint, MotorModel};
use crate::dim::joint_axes::{JointAxesMask, JointAxis};
use crate::dim::math::{Real, Vector};

joint_kind! {
    /// A spring between two points, one on each body: `force = stiffness · (rest_length - distance) - damping
    /// · velocity`.
    ///
    /// It is undamped by default: a mass `m` on it oscillates with the period `2π √(m / stiffness)`.
    /// [`Self::set_damping`] adds damping.
    ///
    /// ```
    /// # use rapier3d::prelude::*;
    /// let spring = SpringJoint::new(Vector::ZERO, vector![0.0, 0.5, 0.0], 2.0, 100.0);
    /// assert_eq!((spring.rest_length(), spring.stiffness(), spring.damping()), (2.0, 100.0, 0.0));
    /// ```
    SpringJoint, SpringJointBuilder
}

impl SpringJoint {
    /// An undamped spring between a point of each body (in that body's frame). `rest_length` is the distance
    /// without force, and `stiffness` the force per unit of length.
    pub fn new(anchor1: Vector, anchor2: Vector, rest_length: Real, stiffness: Real) -> Self {
        let mut data = GenericJoint::new(JointAxesMask::empty());
        data.coupled_axes = JointAxesMask::LIN_AXES;
        data.set_motor_position(JointAxis::LinX, 0.0, 0.0, 0.0)
            .set_motor_model(JointAxis::LinX, MotorModel::ForceBased)
            .set_local_anchor1(anchor1)
            .set_local_anchor2(anchor2);
        let mut spring = Self { data };
        spring.set_rest_length(rest_length).set_stiffness(stiffness);
        spring
    }

    /// The distance at which the spring exerts no force (length units).
    pub fn rest_length(&self) -> Real {
        self.data.motors[JointAxis::LinX as usize].target_pos
    }

    /// Force per unit of length (or, with
    /// [`AccelerationBased`](MotorModel::AccelerationBased), acceleration).
    pub fn stiffness(&self) -> Real {
        self.data.motors[JointAxis::LinX as usize].stiffness
    }

    /// Force per unit of velocity (or acceleration).
    pub fn damping(&self) -> Real {
        self.data.motors[JointAxis::LinX as usize].damping
    }

    /// Sets the distance at which the spring exerts no force (length units).
    pub fn set_rest_length(&mut self, rest_length: Real) -> &mut Self {
        self.data.set_motor_position(
            JointAxis::LinX,
            rest_length,
            self.stiffness(),
            self.damping(),
        );
        self
    }

    /// Sets the force per unit of length.
    pub fn set_stiffness(&mut self, stiffness: Real) -> &mut Self {
        self.data.set_motor_position(
            JointAxis::LinX,
            self.rest_length(),
            stiffness,
            self.damping(),
        );
        self
    }

    /// Sets the force per unit of velocity.
    pub fn set_damping(&mut self, damping: Real) -> &mut Self {
        self.data.set_motor_position(
            JointAxis::LinX,
            self.rest_length(),
            self.stiffness(),
            damping,
        );
        self
    }

    /// Sets whether stiffness and damping give forces (the default) or accelerations.
    pub fn set_spring_model(&mut self, model: MotorModel) -> &mut Self {
        self.data.set_motor_model(JointAxis::LinX, model);
        self
    }
}

impl SpringJointBuilder {
    /// An undamped spring: see [`SpringJoint::new`].
    pub fn new(anchor1: Vector, anchor2: Vector, rest_length: Real, stiffness: Real) -> Self {
        Self(SpringJoint::new(anchor1, anchor2, rest_length, stiffness))
    }

    /// Sets the force per unit of velocity.
    pub fn damping(mut self, damping: Real) -> Self {
        self.0.set_damping(damping);
        self
    }

    /// Sets whether stiffness and damping give forces (the default) or accelerations.
    pub fn spring_model(mut self, model: MotorModel) -> Self {
        self.0.set_spring_model(model);
        self
    }
}
