//! Rigid bodies: which axes they can be pushed along and turned about, and gyroscopic forces.

use crate::dim::axes::LockedAxes;
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
    /// Says along which world axes the body can be pushed.
    pub fn enabled_translations(mut self, x: bool, y: bool, z: bool) -> Self {
        self.locked_axes = with_translations(self.locked_axes, x, y, z);
        self
    }

    /// Says about which world axes the body can be turned.
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

    /// Says whether gyroscopic forces act on the body. See
    /// [`RigidBody::enable_gyroscopic_forces`].
    pub fn gyroscopic_forces_enabled(mut self, enabled: bool) -> Self {
        self.gyroscopic_forces_enabled = enabled;
        self
    }
}

impl RigidBody {
    /// Says along which world axes the body can be pushed.
    pub fn set_enabled_translations(&mut self, x: bool, y: bool, z: bool, wake_up: bool) {
        self.set_locked_axes(with_translations(self.locked_axes(), x, y, z), wake_up);
    }

    /// Says about which world axes the body can be turned.
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

    /// Whether the body is kept from turning about each of the world axes X, Y and Z.
    pub fn is_rotation_locked(&self) -> [bool; 3] {
        [
            LockedAxes::ROTATION_LOCKED_X,
            LockedAxes::ROTATION_LOCKED_Y,
            LockedAxes::ROTATION_LOCKED_Z,
        ]
        .map(|axis| self.locked_axes().contains(axis))
    }

    /// Do gyroscopic forces act on the body?
    pub fn gyroscopic_forces_enabled(&self) -> bool {
        self.gyroscopic_forces_enabled
    }

    /// Says whether gyroscopic forces act on the body: those that keep the angular momentum constant
    /// while a body that is not round turns, so that a spinning top precesses and a thrown box
    /// tumbles. Without them the angular velocity stays constant instead.
    pub fn enable_gyroscopic_forces(&mut self, enabled: bool) {
        self.gyroscopic_forces_enabled = enabled;
    }
}
