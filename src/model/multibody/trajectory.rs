//! Record of a multibody's trajectory through a step.

use super::{MultibodyIndex, MultibodyJoint};
use crate::dim::math::{Pose, Real, SpatialVector};

/// The trajectory of a multibody through a step: its start and its displacement. Derived quantities are in
/// `multibody/trajectory.rs`.
#[derive(Debug)]
pub(crate) struct LinkTrajectory {
    pub index: MultibodyIndex,
    /// The joints and the root's pose when the step began.
    pub start: (Vec<MultibodyJoint>, Pose),
    /// Displacement of each degree of freedom.
    pub shift: Vec<Real>,
    /// Displacement of a root without degrees of freedom.
    pub root: SpatialVector,
    /// The longest path of a link's centre of mass, and the largest rotation angle (rad) of a link.
    pub travel: [Real; 2],
}
