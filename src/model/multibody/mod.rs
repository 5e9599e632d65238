//! # Multibodies: articulated bodies in reduced coordinates
//!
//! An impulse joint corrects the relative motion of two bodies; a multibody joint permits motion along its
//! free axes only. The bodies of a [`Multibody`] form a tree. The pose of each [`MultibodyLink`] except the
//! root follows from the pose of its parent and the coordinates of its [`MultibodyJoint`]. So joints have no
//! position error, the cost of a chain is proportional to its length, and motors act on the exact inertia.
//!
//! [`crate::multibody`] contains the laws of motion, and the solver of the step applies them.

mod attachment;
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
pub(crate) use record::DofLists;
pub use record::Multibody;
pub(crate) use set::MultibodyEdits;
pub use set::MultibodyJointSet;
pub(crate) use trajectory::{LinkTrajectory, LinkTravel};
