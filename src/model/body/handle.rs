//! Handle of a rigid body.

use crate::base::arena::Index;

/// Handle of a rigid body in its set. It is stale after the body is removed, and a stale handle refers to no
/// body.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
#[repr(transparent)]
pub struct RigidBodyHandle(pub Index);

impl RigidBodyHandle {
    /// A handle that refers to no body in any set.
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
