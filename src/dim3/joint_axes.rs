//! The axes of a joint in 3D: three translations and three rotations of one body relative to the other.

use super::math::{Real, Rotation, Vector};
use crate::base::trig::atan2;

/// One degree of freedom between two joined bodies, in the joint's frame on the first body.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub enum JointAxis {
    /// Translation along the frame's X axis.
    LinX = 0,
    /// Translation along the frame's Y axis.
    LinY,
    /// Translation along the frame's Z axis.
    LinZ,
    /// Rotation about the frame's X axis: the *twist*.
    AngX,
    /// Rotation about the frame's Y axis.
    AngY,
    /// Rotation about the frame's Z axis.
    AngZ,
}

bitflags::bitflags! {
    /// A set of [`JointAxis`].
    #[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
    #[derive(Copy, Clone, PartialEq, Eq, Debug, Default, Hash)]
    pub struct JointAxesMask: u8 {
        /// Translation along X.
        const LIN_X = 1 << 0;
        /// Translation along Y.
        const LIN_Y = 1 << 1;
        /// Translation along Z.
        const LIN_Z = 1 << 2;
        /// Rotation about X.
        const ANG_X = 1 << 3;
        /// Rotation about Y.
        const ANG_Y = 1 << 4;
        /// Rotation about Z.
        const ANG_Z = 1 << 5;
        /// All translations.
        const LIN_AXES = Self::LIN_X.bits() | Self::LIN_Y.bits() | Self::LIN_Z.bits();
        /// All rotations.
        const ANG_AXES = Self::ANG_X.bits() | Self::ANG_Y.bits() | Self::ANG_Z.bits();
        /// Locked axes of a prismatic joint: all but the translation along X.
        const LOCKED_PRISMATIC_AXES =
            Self::LIN_Y.bits() | Self::LIN_Z.bits() | Self::ANG_AXES.bits();
        /// Locked axes of a revolute joint: all but the rotation about X.
        const LOCKED_REVOLUTE_AXES =
            Self::LIN_AXES.bits() | Self::ANG_Y.bits() | Self::ANG_Z.bits();
        /// Locked axes of a spherical joint: the translations.
        const LOCKED_SPHERICAL_AXES = Self::LIN_AXES.bits();
        /// Locked axes of a fixed joint: all.
        const LOCKED_FIXED_AXES = Self::LIN_AXES.bits() | Self::ANG_AXES.bits();
        /// Free axes of a prismatic joint.
        const FREE_PRISMATIC_AXES = Self::LIN_X.bits();
        /// Free axes of a revolute joint.
        const FREE_REVOLUTE_AXES = Self::ANG_X.bits();
        /// Free axes of a fixed joint: none.
        const FREE_FIXED_AXES = 0;
        /// Free axes of a spherical joint.
        const FREE_SPHERICAL_AXES = Self::ANG_AXES.bits();
    }
}

impl JointAxis {
    /// All axes, those of translation first.
    pub const ALL: [Self; 6] =
        [Self::LinX, Self::LinY, Self::LinZ, Self::AngX, Self::AngY, Self::AngZ];
}

/// The shortest rotation from the X axis to `axis` (of unit length).
///
/// `-X` is half a turn about Y away, as good as any other.
#[inline]
pub fn frame_along(axis: Vector) -> Rotation {
    if axis.x > -1.0 + 8.0 * Real::EPSILON {
        // The quaternion (1 + cos, X × axis) has the direction of half the angle.
        Rotation::from_xyzw(0.0, -axis.z, axis.y, 1.0 + axis.x).normalize()
    } else {
        Rotation::from_xyzw(0.0, 1.0, 0.0, 0.0)
    }
}

/// The twist (radians, in `-π..=π`) of a rotation about its own X axis, after the swing of X.
#[inline]
pub fn twist(rotation: &Rotation) -> Real {
    let (x, w) = (rotation.x, rotation.w);
    // A quaternion and its negative are the same rotation; both are 0 at half a turn about an axis across,
    // where any twist will do.
    2.0 * if w < 0.0 { atan2(-x, -w) } else { atan2(x, w) }
}
