//! Rigid bodies: locks of single axes, and gyroscopic forces.

use crate::dim::axes::LockedAxes;
use crate::dim::math::{AngVector, Real, ang_is_finite};
use crate::dim::motion::angvel_after;
use crate::model::body::{RigidBody, RigidBodyBuilder};

/// `locked` with the translations replaced: those that are not enabled are locked.
fn with_translations(mut locked: LockedAxes, x: bool, y: bool, z: bool) -> LockedAxes {
    locked.set(LockedAxes::TRANSLATION_LOCKED_X, !x);
    locked.set(LockedAxes::TRANSLATION_LOCKED_Y, !y);
    locked.set(LockedAxes::TRANSLATION_LOCKED_Z, !z);
    locked
}

/// `locked` with the rotations replaced: those that are not enabled are locked.
fn with_rotations(mut locked: LockedAxes, x: bool, y: bool, z: bool) -> LockedAxes {
    locked.set(LockedAxes::ROTATION_LOCKED_X, !x);
    locked.set(LockedAxes::ROTATION_LOCKED_Y, !y);
    locked.set(LockedAxes::ROTATION_LOCKED_Z, !z);
    locked
}

impl RigidBodyBuilder {
    /// Sets the world axes along which forces and impulses move the body. Other translations are locked.
    pub fn enabled_translations(mut self, x: bool, y: bool, z: bool) -> Self {
        self.locked_axes = with_translations(self.locked_axes, x, y, z);
        self
    }

    /// Sets the world axes about which torques and impulses rotate the body. Other rotations are locked.
    pub fn enabled_rotations(mut self, x: bool, y: bool, z: bool) -> Self {
        self.locked_axes = with_rotations(self.locked_axes, x, y, z);
        self
    }

    /// [`Self::enabled_translations`].
    #[deprecated(note = "use `enabled_translations()`")]
    pub fn restrict_translations(self, x: bool, y: bool, z: bool) -> Self {
        self.enabled_translations(x, y, z)
    }

    /// [`Self::enabled_rotations`].
    #[deprecated(note = "use `enabled_rotations()`")]
    pub fn restrict_rotations(self, x: bool, y: bool, z: bool) -> Self {
        self.enabled_rotations(x, y, z)
    }

    /// Sets whether gyroscopic forces act on the body. See [`RigidBody::enable_gyroscopic_forces`].
    pub fn gyroscopic_forces_enabled(mut self, enabled: bool) -> Self {
        self.gyroscopic_forces_enabled = enabled;
        self
    }
}

impl RigidBody {
    /// Sets the world axes along which forces and impulses move the body. Other translations are locked.
    pub fn set_enabled_translations(&mut self, x: bool, y: bool, z: bool, wake_up: bool) {
        self.set_locked_axes(with_translations(self.locked_axes(), x, y, z), wake_up);
    }

    /// Sets the world axes about which torques and impulses rotate the body. Other rotations are locked.
    pub fn set_enabled_rotations(&mut self, x: bool, y: bool, z: bool, wake_up: bool) {
        self.set_locked_axes(with_rotations(self.locked_axes(), x, y, z), wake_up);
    }

    /// [`Self::set_enabled_translations`].
    #[deprecated(note = "use `set_enabled_translations()`")]
    pub fn restrict_translations(&mut self, x: bool, y: bool, z: bool, wake_up: bool) {
        self.set_enabled_translations(x, y, z, wake_up);
    }

    /// [`Self::set_enabled_rotations`].
    #[deprecated(note = "use `set_enabled_rotations()`")]
    pub fn restrict_rotations(&mut self, x: bool, y: bool, z: bool, wake_up: bool) {
        self.set_enabled_rotations(x, y, z, wake_up);
    }

    /// Returns, for each of the world axes X, Y and Z, whether the rotation about it is locked.
    pub fn is_rotation_locked(&self) -> [bool; 3] {
        [
            LockedAxes::ROTATION_LOCKED_X,
            LockedAxes::ROTATION_LOCKED_Y,
            LockedAxes::ROTATION_LOCKED_Z,
        ]
        .map(|axis| self.locked_axes().contains(axis))
    }

    /// Returns whether gyroscopic forces act on the body.
    pub fn gyroscopic_forces_enabled(&self) -> bool {
        self.gyroscopic_forces_enabled
    }

    /// Sets whether gyroscopic forces act on the body. They keep the angular momentum of a rotating body
    /// constant: a spinning top precesses, and a thrown box tumbles. Without them the angular velocity stays
    /// constant instead.
    pub fn enable_gyroscopic_forces(&mut self, enabled: bool) {
        self.gyroscopic_forces_enabled = enabled;
    }

    /// The angular velocity (rad/s) of the body after free rotation for `dt` seconds under gyroscopic forces,
    /// also if they are disabled.
    pub fn angvel_with_gyroscopic_forces(&self, dt: Real) -> AngVector {
        let after =
            angvel_after(&self.mprops.local_mprops, self.pose.rotation, self.vels.angvel, dt);
        if ang_is_finite(after) { after } else { self.vels.angvel }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dim::mass::angular_momentum;
    use crate::dim::math::{Rotation, Vector};
    use parry::shape::{Cuboid, Shape};

    #[test]
    fn axes_that_are_not_enabled_are_locked() {
        let builder = RigidBodyBuilder::dynamic().additional_mass(1.0);
        let mut body = builder
            .enabled_translations(true, false, true)
            .enabled_rotations(false, true, true)
            .build();
        assert_eq!(body.is_rotation_locked(), [true, false, false]);
        body.apply_impulse(Vector::ONE, true);
        assert_eq!(body.linvel(), Vector::new(1.0, 0.0, 1.0));
        body.set_enabled_translations(false, true, false, true);
        // The new locks stop the motion along X and Z.
        body.apply_impulse(Vector::ONE, true);
        assert_eq!(body.linvel(), Vector::Y);
        assert_eq!(body.is_rotation_locked(), [true, false, false]);
    }

    /// Euler's equation: the angular velocity of a free body changes by `I⁻¹ (-ω × I ω)` a second.
    #[test]
    fn a_free_body_obeys_eulers_equation() {
        let mass = Cuboid::new(Vector::new(1.0, 0.6, 0.2)).mass_properties(1.0);
        let builder = RigidBodyBuilder::dynamic().additional_mass_properties(mass);
        let turned = builder.rotation(Vector::new(0.5, -1.0, 0.3));
        let body = turned.angvel(Vector::new(3.0, 5.0, -2.0)).build();
        let momentum = angular_momentum(&mass, *body.rotation(), body.angvel());
        let inv_inertia = mass.world_inv_inertia(body.rotation());
        let expected = inv_inertia.mul_vec(-body.angvel().cross(momentum));
        let dt = 1.0e-3;
        let rate = (body.angvel_with_gyroscopic_forces(dt) - body.angvel()) / dt;
        assert!(expected.length() > 10.0);
        assert!((rate - expected).length() < 0.02 * expected.length(), "{rate} is not {expected}");
    }

    #[test]
    fn a_turn_too_fast_for_the_numbers_leaves_them_finite() {
        let mass = Cuboid::new(Vector::new(1.0, 0.6, 0.2)).mass_properties(1.0);
        let mut body = RigidBodyBuilder::dynamic().additional_mass_properties(mass).build();
        for speed in [1.0e3, 1.0e15, Real::MAX] {
            body.set_angvel(Vector::ONE * speed, true);
            for dt in [0.0, 1.0, Real::MAX, Real::NAN] {
                assert!(body.angvel_with_gyroscopic_forces(dt).is_finite(), "{speed} {dt}");
            }
        }
    }

    /// A quaternion and its negative are one rotation, so the smaller angle is used.
    #[test]
    fn a_kinematic_body_turns_the_shorter_way() {
        let mut body = RigidBodyBuilder::kinematic_position_based().build();
        body.set_next_kinematic_rotation(-Rotation::from_rotation_z(0.1));
        let velocity = body.velocity_to_next_position(10.0);
        assert!(velocity.angvel.abs_diff_eq(Vector::Z, 1.0e-5), "{}", velocity.angvel);
    }

    #[test]
    fn rotations_get_unit_length() {
        let mut body = RigidBodyBuilder::dynamic().build();
        body.set_rotation(Rotation::from_xyzw(0.0, 0.6, 0.0, 0.802), true);
        assert!((body.rotation().length_squared() - 1.0).abs() < 4.0 * Real::EPSILON);
        let before = *body.rotation();
        body.set_rotation(Rotation::from_xyzw(0.0, 0.0, 0.0, 0.0), true);
        body.set_rotation(Rotation::from_xyzw(1.0, 1.0, 1.0, 1.0), true);
        assert_eq!(*body.rotation(), before);
    }
}
