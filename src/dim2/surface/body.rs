//! Rigid bodies: locks of single axes.

use crate::dim::axes::LockedAxes;
use crate::model::body::{RigidBody, RigidBodyBuilder};

/// `locked` with the translations replaced: those that are not enabled are locked.
fn with_translations(mut locked: LockedAxes, x: bool, y: bool) -> LockedAxes {
    locked.set(LockedAxes::TRANSLATION_LOCKED_X, !x);
    locked.set(LockedAxes::TRANSLATION_LOCKED_Y, !y);
    locked
}

impl RigidBodyBuilder {
    /// Sets the world axes along which forces and impulses move the body. Other translations are locked.
    pub fn enabled_translations(mut self, x: bool, y: bool) -> Self {
        self.locked_axes = with_translations(self.locked_axes, x, y);
        self
    }

    /// Sets whether torques and impulses rotate the body. Otherwise its rotation is locked.
    pub fn enabled_rotations(mut self, enabled: bool) -> Self {
        self.locked_axes.set(LockedAxes::ROTATION_LOCKED_Z, !enabled);
        self
    }

    /// [`Self::enabled_translations`].
    #[deprecated(note = "use `enabled_translations()`")]
    pub fn restrict_translations(self, x: bool, y: bool) -> Self {
        self.enabled_translations(x, y)
    }
}

impl RigidBody {
    /// Sets the world axes along which forces and impulses move the body. Other translations are locked.
    pub fn set_enabled_translations(&mut self, x: bool, y: bool, wake_up: bool) {
        self.set_locked_axes(with_translations(self.locked_axes(), x, y), wake_up);
    }

    /// Sets whether torques and impulses rotate the body. Otherwise its rotation is locked.
    #[cfg(not(feature = "upstream-signatures"))]
    pub fn set_enabled_rotations(&mut self, enabled: bool, wake_up: bool) {
        let mut locked_axes = self.locked_axes();
        locked_axes.set(LockedAxes::ROTATION_LOCKED_Z, !enabled);
        self.set_locked_axes(locked_axes, wake_up);
    }

    /// Sets whether torques and impulses rotate the body. The older API has a flag for each axis in two
    /// dimensions too: the last one decides.
    #[cfg(feature = "upstream-signatures")]
    pub fn set_enabled_rotations(&mut self, _x: bool, _y: bool, z: bool, wake_up: bool) {
        let mut locked_axes = self.locked_axes();
        locked_axes.set(LockedAxes::ROTATION_LOCKED_Z, !z);
        self.set_locked_axes(locked_axes, wake_up);
    }

    /// [`Self::set_enabled_translations`].
    #[deprecated(note = "use `set_enabled_translations()`")]
    pub fn restrict_translations(&mut self, x: bool, y: bool, wake_up: bool) {
        self.set_enabled_translations(x, y, wake_up);
    }

    /// [`Self::set_enabled_rotations`].
    #[cfg(not(feature = "upstream-signatures"))]
    #[deprecated(note = "use `set_enabled_rotations()`")]
    pub fn restrict_rotations(&mut self, enabled: bool, wake_up: bool) {
        self.set_enabled_rotations(enabled, wake_up);
    }

    /// [`Self::set_enabled_rotations`].
    #[cfg(feature = "upstream-signatures")]
    #[deprecated(note = "use `set_enabled_rotations()`")]
    pub fn restrict_rotations(&mut self, x: bool, y: bool, z: bool, wake_up: bool) {
        self.set_enabled_rotations(x, y, z, wake_up);
    }

    /// Returns whether the rotation of the body is locked.
    pub fn is_rotation_locked(&self) -> bool {
        self.locked_axes().contains(LockedAxes::ROTATION_LOCKED_Z)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dim::math::{Real, Rotation, Vector};

    #[test]
    fn axes_that_are_not_enabled_are_locked() {
        let builder = RigidBodyBuilder::dynamic().additional_mass(1.0);
        let mut body = builder.enabled_translations(true, false).enabled_rotations(false).build();
        assert!(body.is_rotation_locked() && !body.is_translation_locked());
        body.apply_impulse(Vector::ONE, true);
        assert_eq!(body.linvel(), Vector::X);
        body.set_enabled_translations(false, false, true);
        body.set_enabled_rotations(true, true);
        // The new lock stops the motion along X.
        body.apply_impulse(Vector::ONE, true);
        assert_eq!(body.linvel(), Vector::ZERO);
        assert!(!body.is_rotation_locked() && body.is_translation_locked());
    }

    #[test]
    fn rotations_get_unit_length() {
        let mut body = RigidBodyBuilder::dynamic().build();
        body.set_rotation(Rotation::from_cos_sin_unchecked(0.802, 0.6), true);
        assert!((body.rotation().length_squared() - 1.0).abs() < 4.0 * Real::EPSILON);
        let before = *body.rotation();
        body.set_rotation(Rotation::from_cos_sin_unchecked(0.0, 0.0), true);
        body.set_rotation(Rotation::from_cos_sin_unchecked(1.0, 1.0), true);
        assert_eq!(*body.rotation(), before);
    }
}
