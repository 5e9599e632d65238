//! Bodies, islands, joints, and the parameters of a step.

pub use crate::dim::axes::LockedAxes;
pub use crate::model::body::{
    InvalidRigidBody, RigidBody, RigidBodyActivation, RigidBodyAdditionalMassProps,
    RigidBodyBuilder, RigidBodyChanges, RigidBodyHandle, RigidBodyMassProps, RigidBodySet,
    RigidBodyType, RigidBodyVelocity,
};
pub use crate::model::collider::CoefficientCombineRule;
pub use crate::model::island::IslandManager;
pub use crate::model::joint::{ImpulseJointSet, MultibodyJointSet};
pub use crate::model::params::{
    CONTACT_SHARE, CONTACT_YIELD, FrictionModel, IntegrationParameters, InvalidParameters, Softness,
};
pub use parry::mass_properties::MassProperties;
