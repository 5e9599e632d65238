//! Lockable axes of a body, and their effect on its inverse mass and inertia.

use crate::dim::math::{AngVector, AngularInertia, Real, Vector};

bitflags::bitflags! {
    /// World axes along and about which a dynamic body does not move.
    ///
    /// The inverse mass (or inertia) of a locked axis is zero: forces, gravity, impulses and contacts do not
    /// act along it. Velocities along it, set by the user or from before the lock, become zero. The user
    /// alone moves kinematic bodies: locks have no effect there.
    #[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
    #[derive(Copy, Clone, PartialEq, Eq, Debug, Default, Hash)]
    pub struct LockedAxes: u8 {
        /// No translation along X.
        const TRANSLATION_LOCKED_X = 1 << 0;
        /// No translation along Y.
        const TRANSLATION_LOCKED_Y = 1 << 1;
        /// No translation along Z.
        const TRANSLATION_LOCKED_Z = 1 << 2;
        /// No translation at all.
        const TRANSLATION_LOCKED = Self::TRANSLATION_LOCKED_X.bits()
            | Self::TRANSLATION_LOCKED_Y.bits() | Self::TRANSLATION_LOCKED_Z.bits();
        /// No rotation about X.
        const ROTATION_LOCKED_X = 1 << 3;
        /// No rotation about Y.
        const ROTATION_LOCKED_Y = 1 << 4;
        /// No rotation about Z.
        const ROTATION_LOCKED_Z = 1 << 5;
        /// No rotation at all.
        const ROTATION_LOCKED = Self::ROTATION_LOCKED_X.bits()
            | Self::ROTATION_LOCKED_Y.bits() | Self::ROTATION_LOCKED_Z.bits();
    }
}

/// The inverse mass along each world axis: zero along the locked ones.
#[inline]
pub fn inv_mass_per_axis(locked: LockedAxes, inv_mass: Real) -> Vector {
    let along = |axis| if locked.contains(axis) { 0.0 } else { inv_mass };
    Vector::new(
        along(LockedAxes::TRANSLATION_LOCKED_X),
        along(LockedAxes::TRANSLATION_LOCKED_Y),
        along(LockedAxes::TRANSLATION_LOCKED_Z),
    )
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
        along(LockedAxes::TRANSLATION_LOCKED_Z, linvel.z),
    );
    let angular = AngVector::new(
        along(LockedAxes::ROTATION_LOCKED_X, angvel.x),
        along(LockedAxes::ROTATION_LOCKED_Y, angvel.y),
        along(LockedAxes::ROTATION_LOCKED_Z, angvel.z),
    );
    (linear, angular)
}

/// The inverse inertia of a body that no torque can rotate about the locked world axes.
///
/// Locking the axis `e` adds the torque along `e` that keeps `ω·e` constant, which subtracts the part `K e
/// (eᵀ K e)⁻¹ eᵀ K` from the inverse inertia `K`. Its row and column of `e` become zero. The rest is
/// the inverse of the inertia's other rows and columns. (Merely clearing the row and the column of `K` would
/// make the inertia of a body with oblique axes too small.)
#[inline]
pub fn lock_rotations(locked: LockedAxes, mut k: AngularInertia) -> AngularInertia {
    if !locked.intersects(LockedAxes::ROTATION_LOCKED) {
        return k;
    }
    let part = |a: Real, b: Real, pivot: Real| if pivot > 0.0 { a * b / pivot } else { 0.0 };
    if locked.contains(LockedAxes::ROTATION_LOCKED_X) {
        k.m22 -= part(k.m12, k.m12, k.m11);
        k.m23 -= part(k.m12, k.m13, k.m11);
        k.m33 -= part(k.m13, k.m13, k.m11);
        (k.m11, k.m12, k.m13) = (0.0, 0.0, 0.0);
    }
    if locked.contains(LockedAxes::ROTATION_LOCKED_Y) {
        k.m11 -= part(k.m12, k.m12, k.m22);
        k.m13 -= part(k.m12, k.m23, k.m22);
        k.m33 -= part(k.m23, k.m23, k.m22);
        (k.m12, k.m22, k.m23) = (0.0, 0.0, 0.0);
    }
    if locked.contains(LockedAxes::ROTATION_LOCKED_Z) {
        k.m11 -= part(k.m13, k.m13, k.m33);
        k.m12 -= part(k.m13, k.m23, k.m33);
        k.m22 -= part(k.m23, k.m23, k.m33);
        (k.m13, k.m23, k.m33) = (0.0, 0.0, 0.0);
    }
    k
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dim::math::{Matrix, Rotation};
    use parry::mass_properties::MassProperties;

    /// The world-space inverse inertia of a body whose principal axes are oblique.
    fn askew() -> (Matrix, AngularInertia) {
        let rotation = Rotation::from_scaled_axis(AngVector::new(0.3, -0.7, 0.5));
        let moments = Vector::new(1.0, 2.0, 5.0);
        let axes = Matrix::from_quat(rotation);
        let inertia = axes * Matrix::from_diagonal(moments) * axes.transpose();
        let mass = MassProperties::new(Vector::ZERO, 1.0, moments);
        (inertia, mass.world_inv_inertia(&rotation))
    }

    #[test]
    fn a_locked_axis_takes_no_part_and_the_rest_behaves_like_the_rest_of_the_inertia() {
        let (inertia, inv_inertia) = askew();
        let locked = lock_rotations(LockedAxes::ROTATION_LOCKED_Y, inv_inertia);
        let torque = Vector::new(0.4, 100.0, -0.9);
        let angvel = locked.mul_vec(torque);
        assert_eq!(angvel.y, 0.0);
        // The rest must balance the torque about the free axes.
        let back = inertia * angvel;
        assert!((back.x - torque.x).abs() < 1.0e-5 && (back.z - torque.z).abs() < 1.0e-5, "{back}");
    }

    #[test]
    fn with_two_axes_locked_the_moment_about_the_third_is_left() {
        let (inertia, inv_inertia) = askew();
        let flags = LockedAxes::ROTATION_LOCKED_X | LockedAxes::ROTATION_LOCKED_Z;
        let angvel = lock_rotations(flags, inv_inertia).mul_vec(Vector::new(3.0, 1.0, 7.0));
        assert!(angvel.abs_diff_eq(Vector::Y / inertia.y_axis.y, 1.0e-6), "{angvel}");
    }

    #[test]
    fn with_all_axes_locked_nothing_is_left() {
        let (_, inv_inertia) = askew();
        assert!(lock_rotations(LockedAxes::ROTATION_LOCKED, inv_inertia).is_zero());
    }
}
