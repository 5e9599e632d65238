//! Lockable axes of a body, and their effect on its inverse mass and inertia.

use crate::dim::math::{AngVector, AngularInertia, Real, Vector};

bitflags::bitflags! {
    /// World axes along and about which a dynamic body does not move.
    ///
    /// The inverse mass (or inertia) of a locked axis is zero: forces, gravity, impulses and contacts do not
    /// act along it. Velocities along it, set by the user or from before the lock, become zero. The user
    /// alone moves kinematic bodies: locks have no effect there.
    ///
    /// The bits are those of the 3D engine, so that saved flags have the same meaning in both. The flags of
    /// axes out of the plane have no effect here.
    #[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
    #[derive(Copy, Clone, PartialEq, Eq, Debug, Default, Hash)]
    pub struct LockedAxes: u8 {
        /// No translation along X.
        const TRANSLATION_LOCKED_X = 1 << 0;
        /// No translation along Y.
        const TRANSLATION_LOCKED_Y = 1 << 1;
        /// No effect in 2D.
        const TRANSLATION_LOCKED_Z = 1 << 2;
        /// No translation at all.
        const TRANSLATION_LOCKED = Self::TRANSLATION_LOCKED_X.bits()
            | Self::TRANSLATION_LOCKED_Y.bits();
        /// No effect in 2D.
        const ROTATION_LOCKED_X = 1 << 3;
        /// No effect in 2D.
        const ROTATION_LOCKED_Y = 1 << 4;
        /// No rotation: the only axis of rotation in 2D.
        const ROTATION_LOCKED_Z = 1 << 5;
        /// No rotation at all.
        const ROTATION_LOCKED = Self::ROTATION_LOCKED_Z.bits();
    }
}

/// The inverse mass along each world axis: zero along the locked ones.
#[inline]
pub fn inv_mass_per_axis(locked: LockedAxes, inv_mass: Real) -> Vector {
    let along = |axis| if locked.contains(axis) { 0.0 } else { inv_mass };
    Vector::new(along(LockedAxes::TRANSLATION_LOCKED_X), along(LockedAxes::TRANSLATION_LOCKED_Y))
}

/// The linear and angular velocity without the components along and about locked axes.
#[inline]
pub fn unlocked_velocity(
    locked: LockedAxes,
    linvel: Vector,
    angvel: AngVector,
) -> (Vector, AngVector) {
    let along = |axis, speed| if locked.contains(axis) { 0.0 } else { speed };
    let linear = Vector::new(
        along(LockedAxes::TRANSLATION_LOCKED_X, linvel.x),
        along(LockedAxes::TRANSLATION_LOCKED_Y, linvel.y),
    );
    let angular = along(LockedAxes::ROTATION_LOCKED_Z, angvel);
    (linear, angular)
}

/// The inverse inertia of a body that no torque can rotate about the locked axis.
#[inline]
pub fn lock_rotations(locked: LockedAxes, inv_inertia: AngularInertia) -> AngularInertia {
    if locked.contains(LockedAxes::ROTATION_LOCKED_Z) { 0.0 } else { inv_inertia }
}
