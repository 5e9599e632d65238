//! A collider's record of its place in the trees.

use super::BoxMargin;
use crate::dim::math::{Real, Vector};
use crate::model::body::RigidBodyType;
use parry::bounding_volume::{Aabb, BoundingVolume};

/// Tree of a collider, selected by its body.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(crate) enum TreeKind {
    /// Colliders of fixed bodies and of none: the search finds movable neighbours only.
    Fixed,
    Kinematic,
    Dynamic,
}

impl TreeKind {
    pub const ALL: [Self; 3] = [Self::Fixed, Self::Kinematic, Self::Dynamic];

    /// The kind of the colliders of a body of this type, or of none.
    pub fn of(body_type: Option<RigidBodyType>) -> Self {
        match body_type {
            None | Some(RigidBodyType::Fixed) => Self::Fixed,
            Some(RigidBodyType::Dynamic) => Self::Dynamic,
            Some(_) => Self::Kinematic,
        }
    }

    /// Returns whether colliders of this kind can move without an edit.
    pub fn is_movable(self) -> bool {
        self != Self::Fixed
    }
}

/// A collider's place in the trees, kept inside the collider.
#[derive(Copy, Clone, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct ColliderProxy {
    /// The fat AABB in world space, as in the tree.
    pub fat_aabb: Aabb,
    /// The tree; `None` while the collider is disabled, not yet inserted, or not finite.
    pub tree: Option<TreeKind>,
    /// Distance (length units) that points of the collider may move before its tight box can leave the fat
    /// one. Each motion subtracts its bound, and the box is checked when nothing is left.
    pub clearance: Real,
    /// Whether the last box was unusable.
    pub is_refused: bool,
    /// The collider's slot.
    pub slot: u32,
}

impl Default for ColliderProxy {
    fn default() -> Self {
        Self::outside(u32::MAX)
    }
}

impl ColliderProxy {
    /// The proxy of a collider that is in no tree yet.
    pub fn outside(slot: u32) -> Self {
        let fat_aabb = Aabb::new_invalid();
        Self { fat_aabb, tree: None, clearance: 0.0, is_refused: false, slot }
    }

    /// Becomes the place of a collider of this kind that needs this box: as it is, or with another box.
    /// Returns whether the box changed; the trees are not updated yet. The clearance to the walls of the fat
    /// AABB is updated.
    #[must_use]
    pub fn fit(&mut self, kind: TreeKind, needed: &Aabb, margin: &BoxMargin) -> bool {
        let stays = self.tree == Some(kind) && self.fat_aabb.contains(needed);
        if !stays {
            self.fat_aabb = margin.enlarged(needed, kind);
            self.tree = Some(kind);
        }
        self.clearance = clearance(needed, &self.fat_aabb);
        !stays
    }
}

/// Margin by which a box may grow on all sides before it leaves another that contains it.
fn clearance(inner: &Aabb, outer: &Aabb) -> Real {
    let gaps: Vector = (inner.mins - outer.mins).min(outer.maxs - inner.maxs);
    gaps.min_element().max(0.0)
}
