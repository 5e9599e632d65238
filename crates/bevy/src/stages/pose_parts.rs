//! The two parts of a pose. The user may edit one of them while the plugin writes the other.

use crate::dim::{has_translation_of, set_translation};
use bevy::transform::components::Transform;

/// Translation and rotation, or one of them. In 2D the z coordinate belongs to neither.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(crate) struct PoseParts {
    pub translation: bool,
    pub rotation: bool,
}

impl PoseParts {
    /// Both parts.
    pub const ALL: Self = Self { translation: true, rotation: true };

    /// The parts that differ between two transforms.
    pub fn of_difference(transform: &Transform, other: &Transform) -> Self {
        Self {
            translation: !has_translation_of(transform, other),
            rotation: transform.rotation != other.rotation,
        }
    }

    /// Returns whether there is a part.
    pub fn is_any(self) -> bool {
        self.translation || self.rotation
    }

    /// The other parts.
    pub fn complement(self) -> Self {
        Self { translation: !self.translation, rotation: !self.rotation }
    }

    /// The parts of both sets.
    pub fn and(self, other: Self) -> Self {
        Self {
            translation: self.translation && other.translation,
            rotation: self.rotation && other.rotation,
        }
    }

    /// Copies these parts.
    pub fn copy(self, from: &Transform, to: &mut Transform) {
        if self.translation {
            set_translation(to, from.translation);
        }
        if self.rotation {
            to.rotation = from.rotation;
        }
    }
}
