//! Handles of multibodies, their joints and their links.

use crate::base::arena::Index;

/// Handle of a joint in its set. It is stale after the joint is removed, and a stale handle refers to no
/// joint.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
#[repr(transparent)]
pub struct MultibodyJointHandle(pub Index);

impl MultibodyJointHandle {
    /// A handle that refers to no joint in any set.
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

/// Index of a multibody in its set.
///
/// Insertion and removal of joints merge and split multibodies, so a stored index may become stale.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
#[repr(transparent)]
pub struct MultibodyIndex(pub Index);

/// The multibody and the link of a body. It is valid until a joint is inserted or removed.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct MultibodyLinkId {
    /// The multibody.
    pub multibody: MultibodyIndex,
    /// The link's index among the multibody's links.
    pub id: usize,
}
