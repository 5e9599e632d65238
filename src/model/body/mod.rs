//! # Rigid bodies
//!
//! A [`RigidBody`] is the user's record of one body; a [`RigidBodySet`] owns them. Setters refuse unusable
//! values (not finite, a negative mass). They record each change, so the next step visits changed bodies
//! only. The step contains the laws of motion.

mod activation;
mod body_type;
mod builder;
mod changes;
mod colliders;
mod energy_error;
mod forces;
mod handle;
mod mass;
mod motion;
mod quarantine;
mod rest;
mod rigid_body;
mod set;
mod settings;
mod velocity;

pub use activation::RigidBodyActivation;
pub use body_type::RigidBodyType;
pub use builder::{InvalidRigidBody, RigidBodyBuilder};
pub use changes::RigidBodyChanges;
pub(crate) use colliders::AttachedColliders;
pub(crate) use energy_error::EnergyError;
pub use handle::RigidBodyHandle;
pub use mass::{RigidBodyAdditionalMassProps, RigidBodyMassProps};
pub use quarantine::QuarantineCause;
pub(crate) use rest::RestPose;
pub use rigid_body::RigidBody;
pub(crate) use set::BODIES_PER_TASK;
pub use set::RigidBodySet;
pub use velocity::RigidBodyVelocity;

#[cfg(test)]
mod tests;
