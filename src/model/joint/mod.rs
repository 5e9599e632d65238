//! Joints between bodies.
//!
//! This version has no joints yet: the two sets exist because the step takes them, and are always
//! empty. What they hold has no value, so the compiler knows it too.

use crate::base::arena::Arena;

/// The joint that cannot be made.
#[derive(Copy, Clone, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
enum Never {}

/// The joints that hold bodies together by impulses.
#[derive(Clone, Debug, Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct ImpulseJointSet {
    joints: Arena<Never>,
}

impl ImpulseJointSet {
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
