//! Handle of a collider.

use crate::base::arena::Index;

/// Handle of a collider in its set. It is stale after the collider is removed, and a stale handle refers to
/// no collider.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
#[repr(transparent)]
pub struct ColliderHandle(pub Index);

impl ColliderHandle {
    /// A handle that refers to no collider in any set.
    pub const fn invalid() -> Self {
        Self(Index::INVALID)
    }

    /// Restores a handle from the result of [`Self::into_raw_parts`].
    pub const fn from_raw_parts(id: u32, generation: u32) -> Self {
        Self(Index::from_raw_parts(id, generation))
    }

    /// The slot in the set, and the generation of the slot. Each reuse of a slot gets a new generation.
    pub const fn into_raw_parts(self) -> (u32, u32) {
        self.0.into_raw_parts()
    }
}
