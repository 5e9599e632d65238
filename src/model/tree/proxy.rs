//! What a collider knows of its place in the trees.

use crate::dim::math::{Real, Vector};
use parry::bounding_volume::{Aabb, BoundingVolume};

/// Which tree a collider stands in.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(crate) enum TreeKind {
    /// Colliders of fixed bodies and of none: they look for movable neighbours only.
    Fixed,
    /// Colliders of dynamic and kinematic bodies.
    Movable,
}

impl TreeKind {
    /// The kind that a collider of this kind is not.
    pub fn other(self) -> Self {
        match self {
            Self::Fixed => Self::Movable,
            Self::Movable => Self::Fixed,
        }
    }
}

/// A collider's place in the trees, kept inside the collider.
#[derive(Copy, Clone, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct ColliderProxy {
    /// The enlarged box in world space, as it stands in the tree.
    pub fat_aabb: Aabb,
    /// The tree; `None` while the collider is disabled, not yet taken in, or not finite.
    pub tree: Option<TreeKind>,
    /// How far (length units) points of the collider may move before its box can leave the enlarged
    /// one. Whoever moves the collider takes off a bound of the motion, and looks at the box when
    /// nothing is left.
    pub clearance: Real,
    /// Was the last box one that cannot be placed?
    pub is_refused: bool,
    /// Whose place it is: the collider's slot.
    pub slot: u32,
}

impl Default for ColliderProxy {
    fn default() -> Self {
        Self::outside(u32::MAX)
    }
}

impl ColliderProxy {
    /// Of a collider that stands in no tree yet.
    pub fn outside(slot: u32) -> Self {
        let fat_aabb = Aabb::new_invalid();
        Self { fat_aabb, tree: None, clearance: 0.0, is_refused: false, slot }
    }

    /// Is this still the place of a collider of this kind that needs this box? Then it knows how far from its walls it
    /// is.
    pub fn keeps(&mut self, kind: TreeKind, needed: &Aabb) -> bool {
        let keeps = self.tree == Some(kind) && self.fat_aabb.contains(needed);
        if keeps {
            self.clearance = clearance(needed, &self.fat_aabb);
        }
        keeps
    }
}

/// How far a box may grow on all sides before it leaves another that contains it.
pub(super) fn clearance(inner: &Aabb, outer: &Aabb) -> Real {
    let gaps: Vector = (inner.mins - outer.mins).min(outer.maxs - inner.maxs);
    gaps.min_element().max(0.0)
}
