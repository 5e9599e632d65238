//! The trees, one for each kind of colliders.

use super::TreeKind;
use crate::base::bvh::{BoxTree, BuildScratch};
use crate::base::in_place::clone_in_place;
use parry::bounding_volume::Aabb;

/// Below this number of boxes the order of insertion does not matter.
const REBUILD_MIN: usize = 64;
/// Average number of moves per box, including growth of the boxes above it, at which a tree is rebuilt.
const MOVES_PER_BOX_MAX: usize = 8;

/// The boxes of all kinds.
pub(crate) type AllBoxes<'a> = [&'a BoxTree; TreeKind::ALL.len()];

/// Boxes of colliders, by slot. Each is in one tree.
#[derive(Debug, Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Trees {
    /// By kind.
    trees: [Tree; TreeKind::ALL.len()],
    #[cfg_attr(feature = "serde-serialize", serde(skip))]
    scratch: BuildScratch,
}

clone_in_place!(Trees { trees, scratch });

/// One tree and its growth.
#[derive(Debug, Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
struct Tree {
    boxes: BoxTree,
    /// Number of boxes when the tree was last built as a whole.
    built: usize,
}

clone_in_place!(Tree { boxes, built });

impl Trees {
    /// The boxes of one kind.
    pub fn boxes(&self, kind: TreeKind) -> &BoxTree {
        &self.trees[kind as usize].boxes
    }

    /// The boxes of all kinds.
    pub fn all(&self) -> AllBoxes<'_> {
        TreeKind::ALL.map(|kind| self.boxes(kind))
    }

    /// Sets the box of a slot in the tree of a kind. The slot may already have a box in this or another tree,
    /// for example that of an earlier collider.
    pub fn put(&mut self, slot: u32, kind: TreeKind, aabb: &Aabb) {
        let others = TreeKind::ALL.into_iter().filter(|&other| other != kind);
        others.for_each(|other| self.trees[other as usize].boxes.remove(slot));
        self.trees[kind as usize].boxes.insert(aabb, slot);
    }

    /// Removes a slot from all trees.
    pub fn remove(&mut self, slot: u32) {
        self.trees.iter_mut().for_each(|tree| tree.boxes.remove(slot));
    }

    /// Rebuilds trees after many insertions, at an amortised cost. A tree is rebuilt only when half of its
    /// boxes are new, or all have moved many times.
    pub fn tidy(&mut self) {
        for Tree { boxes, built } in &mut self.trees {
            let count = boxes.len();
            let is_worn = boxes.wear() > MOVES_PER_BOX_MAX * count;
            if count >= REBUILD_MIN && (count / 2 > *built || is_worn) {
                boxes.rebuild(&mut self.scratch);
                *built = count;
            }
        }
    }
}
