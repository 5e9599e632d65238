//! Springs between two anchors, with the constructor of Rapier 0.32.

use crate::wrapper::forward;
use engine::dynamics::{GenericJoint, MotorModel};
use engine::math::{Real, Vector};

/// A damped spring between two anchors.
#[derive(Copy, Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde-serialize", serde(transparent))]
#[repr(transparent)]
pub struct SpringJoint(engine::dynamics::SpringJoint);

forward!(SpringJoint, engine::dynamics::SpringJoint);

impl SpringJoint {
    /// A spring with this rest length (length units), stiffness and damping.
    pub fn new(rest_length: Real, stiffness: Real, damping: Real) -> Self {
        let (anchor1, anchor2) = (Vector::ZERO, Vector::ZERO);
        let mut spring =
            engine::dynamics::SpringJoint::new(anchor1, anchor2, rest_length, stiffness);
        spring.set_damping(damping);
        Self(spring)
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

/// Defines functions of the builder that call a setter of the spring.
macro_rules! setters {
    ($($(#[$doc:meta])* $name:ident, $setter:ident($argument:ident: $type:ty);)*) => {
        impl SpringJointBuilder {
            $(
                $(#[$doc])*
                #[must_use]
                pub fn $name(mut self, $argument: $type) -> Self {
                    self.0.$setter($argument);
                    self
                }
            )*
        }
    };
}

setters! {
    /// Sets whether the joined bodies collide with each other.
    contacts_enabled, set_contacts_enabled(enabled: bool);
    /// Sets the anchor in the frame of the first body.
    local_anchor1, set_local_anchor1(anchor: Vector);
    /// Sets the anchor in the frame of the second body.
    local_anchor2, set_local_anchor2(anchor: Vector);
    /// Sets the units of stiffness and damping.
    spring_model, set_spring_model(model: MotorModel);
}

impl SpringJointBuilder {
    /// A spring with this rest length (length units), stiffness and damping.
    pub fn new(rest_length: Real, stiffness: Real, damping: Real) -> Self {
        Self(SpringJoint::new(rest_length, stiffness, damping))
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
