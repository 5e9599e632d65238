//! Lengths that may depend on the size of the character.

use crate::dim::math::Real;

/// A length, absolute or as a fraction of the character's size.
#[derive(Copy, Clone, PartialEq, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub enum CharacterLength {
    /// A fraction of the character's height or width, depending on the setting. The height is the extent of
    /// the shape along the up direction, the width is the largest extent perpendicular to it.
    Relative(Real),
    /// A length (length units).
    Absolute(Real),
}

impl CharacterLength {
    /// The same length with its number changed by `f`, if it is [`Self::Absolute`].
    #[must_use]
    pub fn map_absolute(self, f: impl FnOnce(Real) -> Real) -> Self {
        match self {
            Self::Absolute(length) => Self::Absolute(f(length)),
            Self::Relative(_) => self,
        }
    }

    /// The same length with its number changed by `f`, if it is [`Self::Relative`].
    #[must_use]
    pub fn map_relative(self, f: impl FnOnce(Real) -> Real) -> Self {
        match self {
            Self::Relative(fraction) => Self::Relative(f(fraction)),
            Self::Absolute(_) => self,
        }
    }

    /// The length (length units) for a character of this size.
    pub(super) fn of(self, size: Real) -> Real {
        match self {
            Self::Relative(fraction) => fraction * size,
            Self::Absolute(length) => length,
        }
    }
}
