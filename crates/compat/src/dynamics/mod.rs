//! Bodies, joints and the parameters of a step.

mod ccd;
mod islands;
mod joints;
mod parameters;
mod sets;
mod spring;

pub use ccd::CCDSolver;
pub use engine::dynamics::*;
pub use islands::IslandManager;
pub use joints::ImpulseJointSet;
#[cfg(feature = "dim3")]
pub use parameters::FrictionModel;
pub use parameters::IntegrationParameters;
pub use sets::RigidBodySet;
pub use spring::{SpringJoint, SpringJointBuilder};
