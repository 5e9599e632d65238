//! Bodies, joints and the parameters of a step.

mod ccd;
mod islands;
mod joints;
mod multibody;
#[cfg_attr(rapier036, path = "parameters036.rs")]
mod parameters;
mod sets;
#[cfg(rapier036)]
mod soft;
mod spring;

pub use ccd::CCDSolver;
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
