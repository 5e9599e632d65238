//! The angle of a joint's free axis.

use crate::dim2::joint_axes::{JointAxesMask, JointAxis, twist};
use crate::dim2::math::{AngVector, Real, Rotation, SpatialVector};

/// Free rotations of a joint, and groups of them that are measured together.
#[derive(Copy, Clone, Debug)]
pub(crate) struct FreeRotations {
    free: JointAxesMask,
}

impl FreeRotations {
    /// With these axes of a joint free. One rotation cannot be coupled.
    pub fn new(free: JointAxesMask, _coupled: JointAxesMask) -> Self {
        Self { free }
    }

    /// Returns whether there is only one free rotation. Then its turns can be counted.
    pub fn is_single(&self) -> bool {
        self.free.contains(JointAxesMask::ANG_X)
    }
}

/// The angle of the axis of rotation (radians), and the factor from the relative angular velocity to its
/// derivative. `rotation` is the second frame's, seen from the first.
pub(crate) fn angle_about(
    _axis: JointAxis,
    _rotations: FreeRotations,
    rotation: &Rotation,
) -> (Real, AngVector) {
    (twist(rotation), 1.0)
}

/// The angular part of a joint's impulses.
pub(crate) fn couple_of(impulses: &SpatialVector) -> AngVector {
    impulses[2]
}

/// Sets the angular part of a joint's impulses.
pub(crate) fn set_couple(impulses: &mut SpatialVector, couple: AngVector) {
    impulses[2] = couple;
}
