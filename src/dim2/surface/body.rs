//! Rigid bodies: which axes they can be pushed along, and whether they can be turned.

use crate::dim::axes::LockedAxes;
use crate::model::body::{RigidBody, RigidBodyBuilder};

/// `locked` with the translations replaced: those that are not enabled are locked.
fn with_translations(mut locked: LockedAxes, x: bool, y: bool) -> LockedAxes {
    locked.set(LockedAxes::TRANSLATION_LOCKED_X, !x);
    locked.set(LockedAxes::TRANSLATION_LOCKED_Y, !y);
    locked
}

impl RigidBodyBuilder {
    /// Says along which world axes the body can be pushed.
    pub fn enabled_translations(mut self, x: bool, y: bool) -> Self {
        self.locked_axes = with_translations(self.locked_axes, x, y);
        self
    }

    /// Says whether the body can be turned.
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
    /// Says along which world axes the body can be pushed.
    pub fn set_enabled_translations(&mut self, x: bool, y: bool, wake_up: bool) {
        self.set_locked_axes(with_translations(self.locked_axes(), x, y), wake_up);
    }

    /// Says whether the body can be turned.
    pub fn set_enabled_rotations(&mut self, enabled: bool, wake_up: bool) {
        let mut locked_axes = self.locked_axes();
        locked_axes.set(LockedAxes::ROTATION_LOCKED_Z, !enabled);
        self.set_locked_axes(locked_axes, wake_up);
    }

    /// [`Self::set_enabled_translations`].
    #[deprecated(note = "use `set_enabled_translations()`")]
    pub fn restrict_translations(&mut self, x: bool, y: bool, wake_up: bool) {
        self.set_enabled_translations(x, y, wake_up);
    }

    /// [`Self::set_enabled_rotations`].
    #[deprecated(note = "use `set_enabled_rotations()`")]
    pub fn restrict_rotations(&mut self, enabled: bool, wake_up: bool) {
        self.set_enabled_rotations(enabled, wake_up);
    }

    /// Is the body kept from turning?
    pub fn is_rotation_locked(&self) -> bool {
        self.locked_axes().contains(LockedAxes::ROTATION_LOCKED_Z)
    }
}
