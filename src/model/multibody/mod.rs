//! # Multibodies: articulated bodies in reduced coordinates
//!
//! An impulse joint lets two bodies go where they like and pulls them together; a multibody joint has no
//! other directions than its free axes. The bodies of a [`Multibody`] form a tree: each [`MultibodyLink`] but
//! the root stands where its parent, its [`MultibodyJoint`] and that joint's coordinates say. So joints never
//! come apart, a chain costs as much as it is long, and a motor turns exactly what it has to turn.
//!
//! The laws of motion are in [`crate::multibody`]; the step's part is in its solver.

mod coupling;
mod trajectory;
mod handle;
mod joint;
mod link;
mod record;
mod set;
mod split;
#[cfg(test)]
mod tests;

pub use coupling::MultibodyDofCoupling;
pub use handle::{MultibodyIndex, MultibodyJointHandle, MultibodyLinkId};
pub use joint::MultibodyJoint;
pub use link::MultibodyLink;
pub use record::Multibody;
pub(crate) use set::MultibodyEdits;
pub use set::MultibodyJointSet;
pub(crate) use trajectory::LinkTrajectory;
