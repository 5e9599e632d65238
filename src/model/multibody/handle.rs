//! Handles of multibodies, their joints and their links.

use crate::base::arena::Index;

/// Finds a joint in its set until the joint is removed, and nothing after that.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
#[repr(transparent)]
pub struct MultibodyJointHandle(pub Index);

impl MultibodyJointHandle {
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

/// Finds a multibody in its set.
///
/// Inserting and removing joints merges and splits multibodies: an index that was kept may find nothing then.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
#[repr(transparent)]
pub struct MultibodyIndex(pub Index);

/// Says which link of which multibody a body is. Holds until a joint is inserted or removed.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct MultibodyLinkId {
    /// The multibody.
    pub multibody: MultibodyIndex,
    /// The link's position among the multibody's links.
    pub id: usize,
}
