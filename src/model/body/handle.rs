//! Handle of a rigid body.

use crate::base::arena::Index;

/// Finds a rigid body in its set until the body is removed, and nothing after that.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
#[repr(transparent)]
pub struct RigidBodyHandle(pub Index);

impl RigidBodyHandle {
    /// A handle that finds nothing in any set.
    pub const fn invalid() -> Self {
        Self(Index::INVALID)
    }

    /// Puts a handle together again from [`Self::into_raw_parts`].
    pub const fn from_raw_parts(id: u32, generation: u32) -> Self {
        Self(Index::from_raw_parts(id, generation))
    }

    /// The slot in the set, and which of the slot's successive tenants is meant.
    pub const fn into_raw_parts(self) -> (u32, u32) {
        self.0.into_raw_parts()
    }
}
