//! Springs between two anchors.

use engine::dynamics::{GenericJoint, GenericJointBuilder, JointAxesMask, JointAxis, MotorModel};
use engine::math::{Real, Vector};

/// A damped spring between two anchors.
#[derive(Copy, Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
#[repr(transparent)]
pub struct SpringJoint {
    /// The joint with the spring as the motor of its distance.
    pub data: GenericJoint,
}

impl SpringJoint {
    /// A spring with this rest length (length units), stiffness and damping.
    pub fn new(rest_length: Real, stiffness: Real, damping: Real) -> Self {
        let data = GenericJointBuilder::new(JointAxesMask::empty())
            .coupled_axes(JointAxesMask::LIN_AXES)
            .motor_position(JointAxis::LinX, rest_length, stiffness, damping)
            .motor_model(JointAxis::LinX, MotorModel::ForceBased)
            .build();
        Self { data }
    }

    /// The underlying joint.
    pub fn data(&self) -> &GenericJoint {
        &self.data
    }

    /// Returns whether the joined bodies collide with each other.
    pub fn contacts_enabled(&self) -> bool {
        self.data.contacts_enabled()
    }

    /// Sets whether the joined bodies collide with each other.
    pub fn set_contacts_enabled(&mut self, enabled: bool) -> &mut Self {
        self.data.set_contacts_enabled(enabled);
        self
    }

    /// The anchor in the frame of the first body.
    pub fn local_anchor1(&self) -> Vector {
        self.data.local_anchor1()
    }

    /// Sets the anchor in the frame of the first body.
    pub fn set_local_anchor1(&mut self, anchor: Vector) -> &mut Self {
        self.data.set_local_anchor1(anchor);
        self
    }

    /// The anchor in the frame of the second body.
    pub fn local_anchor2(&self) -> Vector {
        self.data.local_anchor2()
    }

    /// Sets the anchor in the frame of the second body.
    pub fn set_local_anchor2(&mut self, anchor: Vector) -> &mut Self {
        self.data.set_local_anchor2(anchor);
        self
    }

    /// Sets the units of stiffness and damping.
    pub fn set_spring_model(&mut self, model: MotorModel) -> &mut Self {
        self.data.set_motor_model(JointAxis::LinX, model);
        self
    }
}

impl From<SpringJoint> for GenericJoint {
    fn from(spring: SpringJoint) -> Self {
        spring.data
    }
}

/// Builder of springs.
#[derive(Copy, Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct SpringJointBuilder(pub SpringJoint);

impl SpringJointBuilder {
    /// A spring with this rest length (length units), stiffness and damping.
    pub fn new(rest_length: Real, stiffness: Real, damping: Real) -> Self {
        Self(SpringJoint::new(rest_length, stiffness, damping))
    }

    /// Sets whether the joined bodies collide with each other.
    #[must_use]
    pub fn contacts_enabled(mut self, enabled: bool) -> Self {
        self.0.set_contacts_enabled(enabled);
        self
    }

    /// Sets the anchor in the frame of the first body.
    #[must_use]
    pub fn local_anchor1(mut self, anchor: Vector) -> Self {
        self.0.set_local_anchor1(anchor);
        self
    }

    /// Sets the anchor in the frame of the second body.
    #[must_use]
    pub fn local_anchor2(mut self, anchor: Vector) -> Self {
        self.0.set_local_anchor2(anchor);
        self
    }

    /// Sets the units of stiffness and damping.
    #[must_use]
    pub fn spring_model(mut self, model: MotorModel) -> Self {
        self.0.set_spring_model(model);
        self
    }

    /// The spring.
    #[must_use]
    pub fn build(self) -> SpringJoint {
        self.0
    }
}

impl From<SpringJointBuilder> for GenericJoint {
    fn from(builder: SpringJointBuilder) -> Self {
        builder.0.data
    }
}
