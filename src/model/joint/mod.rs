//! Joints between bodies: locked axes, limits and motors, and the sets that contain them.
//!
//! Every joint wraps a [`GenericJoint`]. Named joints lock a fixed set of axes and have methods for the free
//! axes. An [`ImpulseJoint`] is a joint between two bodies of a world.

mod angle;
mod builder;
mod error;
mod fixed;
mod generic;
mod impulse_joint;
pub(crate) mod kind;
mod limits;
mod links;
mod motor;
mod prismatic;
mod revolute;
mod rope;
mod set;
mod spring;
mod spring_joint;
mod transmission;
mod welds;
pub(crate) mod views;

pub use builder::GenericJointBuilder;
pub use error::InvalidJoint;
pub use fixed::{FixedJoint, FixedJointBuilder};
pub use generic::{GenericJoint, JointEnabled};
pub(crate) use generic::{mask_of, relative_rotation};
pub use impulse_joint::{BodyPair, ImpulseJoint, ImpulseJointHandle};
pub use limits::JointLimits;
pub(crate) use limits::nearest_turn;
pub(crate) use links::{JointForm, JointLink, JointLinks};
pub use motor::{JointMotor, MotorModel};
pub use prismatic::{PrismaticJoint, PrismaticJointBuilder};
pub use revolute::{RevoluteJoint, RevoluteJointBuilder};
pub use rope::{RopeJoint, RopeJointBuilder};
pub(crate) use set::Entry as JointEntry;
pub use set::ImpulseJointSet;
pub use spring::{JointSoftness, STIFFEST, SpringCoefficients, spring_of};
pub use spring_joint::{SpringJoint, SpringJointBuilder};
pub(crate) use transmission::TransmissionCount;
pub use transmission::{
    GearJoint, GearJointBuilder, PulleyJoint, PulleyJointBuilder, RackJoint, RackJointBuilder,
    Transmission, TransmissionEnd,
};
