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
    /// The longest path and the largest angle of its links.
    pub travel: LinkTravel,
}

/// The motion of a link to and fro, which its displacement does not contain.
#[derive(Copy, Clone, Debug, Default)]
pub(crate) struct LinkTravel {
    /// The path length of the centre of mass.
    pub path_length: Real,
    /// The angle that the link rotated (rad).
    pub angle: Real,
}

impl LinkTravel {
    /// The longer path and the larger angle.
    pub fn max(self, other: &Self) -> Self {
        let path_length = self.path_length.max(other.path_length);
        Self { path_length, angle: self.angle.max(other.angle) }
    }
}
