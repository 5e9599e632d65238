//! What is kept of the way of a multibody through a step.

use super::{MultibodyIndex, MultibodyJoint};
use crate::dim::math::{Pose, Real, SpatialVector};

/// The way of a multibody through a step: where it began, and how far it went. What follows from it stands in
/// `multibody/trajectory.rs`.
#[derive(Debug)]
pub(crate) struct LinkTrajectory {
    pub index: MultibodyIndex,
    /// The joints and the root's pose when the step began.
    pub start: (Vec<MultibodyJoint>, Pose),
    /// How far each degree of freedom moved.
    pub shift: Vec<Real>,
    /// How far a root without degrees of freedom moved.
    pub root: SpatialVector,
    /// The longest way of a link's centre of mass, and the greatest angle (rad) that one turned.
    pub travel: [Real; 2],
}
