//! The axes of a joint in 2D: two translations and one rotation of one body relative to the other.

use super::math::{Real, Rotation, Vector, rotation_to_angle};

/// One degree of freedom between two joined bodies, in the joint's frame on the first body.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub enum JointAxis {
    /// Translation along the frame's X axis.
    LinX = 0,
    /// Translation along the frame's Y axis.
    LinY,
    /// Rotation.
    AngX,
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
        /// Rotation.
        const ANG_X = 1 << 2;
        /// All translations.
        const LIN_AXES = Self::LIN_X.bits() | Self::LIN_Y.bits();
        /// All rotations: the only one.
        const ANG_AXES = Self::ANG_X.bits();
        /// Locked axes of a prismatic joint: all but the translation along X.
        const LOCKED_PRISMATIC_AXES = Self::LIN_Y.bits() | Self::ANG_X.bits();
        /// Locked axes of a revolute joint: the translations.
        const LOCKED_REVOLUTE_AXES = Self::LIN_AXES.bits();
        /// Locked axes of a pin-slot joint: the translation along Y.
        const LOCKED_PIN_SLOT_AXES = Self::LIN_Y.bits();
        /// Locked axes of a fixed joint: all.
        const LOCKED_FIXED_AXES = Self::LIN_AXES.bits() | Self::ANG_AXES.bits();
        /// Free axes of a prismatic joint.
        const FREE_PRISMATIC_AXES = Self::LIN_X.bits();
        /// Free axes of a revolute joint.
        const FREE_REVOLUTE_AXES = Self::ANG_X.bits();
        /// Free axes of a fixed joint: none.
        const FREE_FIXED_AXES = 0;
    }
}

impl JointAxis {
    /// All axes, those of translation first.
    pub const ALL: [Self; 3] = [Self::LinX, Self::LinY, Self::AngX];
}

/// The rotation that takes the X axis to `axis` (of unit length).
#[inline]
pub fn frame_along(axis: Vector) -> Rotation {
    Rotation::from_cos_sin_unchecked(axis.x, axis.y).normalize()
}

/// The angle of a rotation (radians, in `-π..=π`).
#[inline]
pub fn twist(rotation: &Rotation) -> Real {
    rotation_to_angle(rotation)
}
