//! Bodies, joints and the parameters of a step.

mod ccd;
#[cfg(rapier036)]
mod couplings;
mod islands;
mod joints;
mod multibody;
#[cfg_attr(rapier036, path = "parameters036.rs")]
mod parameters;
mod sets;
#[cfg(rapier036)]
mod soft;
mod spring;

pub use crate::components::{
    BodyStatus, RigidBodyCcd, RigidBodyColliders, RigidBodyDamping, RigidBodyDominance,
    RigidBodyForces, RigidBodyPosition,
};
pub use ccd::CCDSolver;
#[cfg(rapier036)]
pub use couplings::MultibodyDofCoupling;
pub use engine::control::AxesMask;
pub use engine::dynamics::*;
pub use islands::IslandManager;
pub use joints::ImpulseJointSet;
pub use multibody::{Multibody, MultibodyJointSet};
#[cfg(feature = "dim3")]
pub use parameters::FrictionModel;
pub use parameters::IntegrationParameters;
pub use sets::RigidBodySet;
#[cfg(rapier036)]
pub use soft::*;
pub use spring::{SpringJoint, SpringJointBuilder};
