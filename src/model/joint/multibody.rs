//! The joints that make bodies links of an articulated whole.
//!
//! This version has none yet: the set exists because the step takes it, and is always empty. What it holds
//! has no value, so the compiler knows it too.

use crate::base::arena::Arena;

/// The joint that cannot be made.
#[derive(Copy, Clone, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
enum Never {}

/// The joints that make bodies links of an articulated whole.
#[derive(Clone, Debug, Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct MultibodyJointSet {
    joints: Arena<Never>,
}

impl MultibodyJointSet {
    /// An empty set.
    pub fn new() -> Self {
        Self::default()
    }

    /// Number of joints.
    pub fn len(&self) -> usize {
        self.joints.len()
    }

    /// Is there no joint?
    pub fn is_empty(&self) -> bool {
        self.joints.is_empty()
    }
}
