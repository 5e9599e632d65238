//! Bodies, islands, joints, and the parameters of a step.

pub use crate::dim::axes::LockedAxes;
pub use crate::dim::joint_axes::{JointAxesMask, JointAxis};
pub use crate::model::body::{
    InvalidRigidBody, QuarantineCause, RigidBody, RigidBodyActivation,
    RigidBodyAdditionalMassProps, RigidBodyBuilder, RigidBodyChanges, RigidBodyHandle,
    RigidBodyMassProps, RigidBodySet, RigidBodyType, RigidBodyVelocity,
};
pub use crate::model::collider::CoefficientCombineRule;
pub use crate::model::island::IslandManager;
pub use crate::model::joint::{
    BodyPair, FixedJoint, FixedJointBuilder, GearJoint, GearJointBuilder, GenericJoint,
    GenericJointBuilder, ImpulseJoint, ImpulseJointHandle, ImpulseJointSet, InvalidJoint,
    JointEnabled, JointLimits, JointMotor, MotorModel, PrismaticJoint, PrismaticJointBuilder,
    PulleyJoint, PulleyJointBuilder, RackJoint, RackJointBuilder, RevoluteJoint,
    RevoluteJointBuilder, RopeJoint, RopeJointBuilder, SpringCoefficients, SpringJoint,
    SpringJointBuilder, Transmission, TransmissionEnd,
};
// A glob, because each of the two dimensions has a joint of its own.
pub use crate::base::square::SquareMatrix;
pub use crate::dim::surface::joint::*;
pub use crate::model::multibody::{
    Multibody, MultibodyDofCoupling, MultibodyIndex, MultibodyJoint, MultibodyJointHandle,
    MultibodyJointSet, MultibodyLink, MultibodyLinkId,
};
pub use crate::model::params::{
    CONTACT_COMPLIANCE, CONTACT_ERP_SCALE, FrictionModel, IntegrationParameters, InvalidParameters,
    JOINT_ERP_SCALE, Softness,
};
#[cfg(feature = "upstream-036")]
pub use crate::model::upstream036::{SoftBodyHandle, SoftMeshId, SoftMeshRef};
pub use crate::multibody::InverseKinematicsOption;
pub use parry::mass_properties::MassProperties;
