//! Trees of boxes: which colliders may touch which.
//!
//! Each collider stands in one of two trees, with a box somewhat larger than itself. While it stays
//! inside, nothing is done; when it leaves, it gets a new box and is noted as moved, and only moved
//! colliders look for new neighbours. Fixed colliders have a tree of their own, so that they never
//! find each other. A step costs nothing for colliders that rest, however many there are.

mod enlarge;
mod placement;
mod proxy;
mod shape_box;
#[cfg(test)]
mod tests;

pub(crate) use enlarge::BoxMargin;
pub(crate) use placement::stays;
pub(crate) use proxy::{ColliderProxy, TreeKind};
pub(crate) use shape_box::shape_box;

use crate::base::bvh::{BoxProbe, BoxTree};
use crate::dim::math::Real;
use crate::model::collider::{ColliderHandle, InteractionGroups};
use crate::model::seal::Seal;
use parry::bounding_volume::Aabb;

/// Below this number of boxes the order of insertion does not matter.
const REBUILD_MIN: usize = 64;
/// A tree is rebuilt when its boxes have been put elsewhere, or had those above them grow, this often, on average.
const REBUILD_WEAR: usize = 8;

/// The enlarged boxes of all colliders.
#[derive(Clone, Debug, Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct BroadPhaseBvh {
    fixed: Tree,
    movable: Tree,
    /// Slots of the colliders that have a new box since the last search for pairs.
    moved: Vec<u32>,
    /// One bit for each slot: is it in `moved`?
    moved_bits: Vec<u64>,
    /// By slot: the binary exponent of the longest side of its enlarged box.
    sizes: Vec<u16>,
    /// Has any collider of a fixed body ever asked for pairs with others of its kind?
    fixed_meet: bool,
    /// Has any collider ever been on a kinematic body?
    has_kinematics: bool,
    /// Has any collider ever been a sensor?
    has_sensors: bool,
    /// All memberships and wishes that colliders of these trees ever had, together.
    groups: Option<InteractionGroups>,
    pub(crate) seal: Seal,
}

impl BroadPhaseBvh {
    /// Knows no collider.
    pub fn new() -> Self {
        Self::default()
    }

    /// Gives a collider its place in a tree: whatever it was before, afterwards its enlarged box
    /// covers `tight` and it stands in the tree of its kind. Returns whether the enlarged box changed.
    ///
    /// A box that is not finite, or beyond the limits of the world, cannot be placed: the collider is
    /// left out, with a warning when that begins.
    pub(crate) fn place(
        &mut self,
        handle: ColliderHandle,
        proxy: &mut ColliderProxy,
        kind: TreeKind,
        tight: &Aabb,
        margin: &BoxMargin,
    ) -> bool {
        let (slot, _) = handle.into_raw_parts();
        let Some(needed) = margin.needed(tight) else {
            if !proxy.is_refused {
                log::warn!("collider {slot} is left out of the world: its box is {tight:?}");
            }
            proxy.is_refused = true;
            return self.remove(slot, proxy);
        };
        proxy.is_refused = false;
        if proxy.keeps(kind, &needed) {
            return false;
        }
        // A stale entry may stand at the slot if its former tenant was removed: look in the other tree, too.
        self.tree_mut(kind.other()).boxes.remove(slot);
        proxy.fat_aabb = margin.enlarged(&needed, kind);
        proxy.clearance = proxy::clearance(&needed, &proxy.fat_aabb);
        proxy.tree = Some(kind);
        self.tree_mut(kind).insert(proxy.fat_aabb, slot);
        self.note_size(slot, &proxy.fat_aabb);
        self.mark_moved(slot);
        true
    }

    fn note_size(&mut self, slot: u32, aabb: &Aabb) {
        let slot = slot as usize;
        if slot >= self.sizes.len() {
            self.sizes.resize(slot + 1, 0);
        }
        self.sizes[slot] = exponent(aabb.extents().max_element());
    }

    /// How many times larger than 1 each collider is, as a power of two, from an origin that is the same for all: of the box
    /// that it last had.
    pub(crate) fn size(&self, slot: u32) -> u16 {
        self.sizes.get(slot as usize).copied().unwrap_or(0)
    }

    /// Which of two colliders has to bear that they are a pair: the smaller one, and of equals the later one.
    pub(crate) fn bears(&self, slot: u32, other_slot: u32) -> bool {
        (self.size(slot), other_slot) < (self.size(other_slot), slot)
    }

    /// Takes a collider out. Returns whether it was in.
    pub(crate) fn remove(&mut self, slot: u32, proxy: &mut ColliderProxy) -> bool {
        self.remove_slot(slot);
        proxy.tree.take().is_some()
    }

    /// Takes out whatever stands at the slot, after the collider is gone.
    pub(crate) fn remove_slot(&mut self, slot: u32) {
        self.fixed.boxes.remove(slot);
        self.movable.boxes.remove(slot);
    }

    /// Lets the next search look at all neighbours of the collider again, as after a change of its
    /// groups.
    pub(crate) fn mark_moved(&mut self, slot: u32) {
        let (word, bit) = (slot as usize / 64, 1_u64 << (slot % 64));
        if word >= self.moved_bits.len() {
            self.moved_bits.resize(word + 1, 0);
        }
        if self.moved_bits[word] & bit == 0 {
            self.moved_bits[word] |= bit;
            self.moved.push(slot);
        }
    }

    /// Slots of the colliders that must look for neighbours.
    pub(crate) fn moved(&self) -> &[u32] {
        &self.moved
    }

    /// Must the collider at this slot look for neighbours?
    pub(crate) fn is_moved(&self, slot: u32) -> bool {
        let word = self.moved_bits.get(slot as usize / 64).copied().unwrap_or(0);
        word & (1 << (slot % 64)) != 0
    }

    /// All have looked for neighbours.
    pub(crate) fn clear_moved(&mut self) {
        for slot in self.moved.drain(..) {
            self.moved_bits[slot as usize / 64] = 0;
        }
    }

    /// May any movable collider be on a kinematic body?
    pub(crate) fn has_kinematics(&self) -> bool {
        self.has_kinematics
    }

    /// May any collider be a sensor?
    pub(crate) fn has_sensors(&self) -> bool {
        self.has_sensors
    }

    /// Must a collider of this kind look for neighbours among those of the other?
    pub(crate) fn may_meet(&self, kind1: TreeKind, kind2: TreeKind) -> bool {
        self.fixed_meet || kind1 == TreeKind::Movable || kind2 == TreeKind::Movable
    }

    /// May a collider of these groups meet any other? Those that are there only to be found by queries, such as debris that
    /// nothing collides with, need not look around.
    pub(crate) fn may_meet_any(&self, groups: InteractionGroups) -> bool {
        self.groups.is_some_and(|all| groups.test(all))
    }

    /// The boxes of one kind of colliders, by slot.
    pub(crate) fn boxes(&self, kind: TreeKind) -> &BoxTree {
        match kind {
            TreeKind::Fixed => &self.fixed.boxes,
            TreeKind::Movable => &self.movable.boxes,
        }
    }

    /// Calls back for the slots of the colliders of one kind whose enlarged boxes overlap a box.
    pub(crate) fn for_each_overlapping(&self, kind: TreeKind, aabb: &Aabb, visit: impl FnMut(u32)) {
        self.boxes(kind).for_each_leaf(&BoxProbe(*aabb), visit);
    }

    /// Puts the trees in good order after many colliders came in, at a cost that these colliders
    /// have paid for: a tree is rebuilt only when half of its boxes are new.
    pub(crate) fn tidy(&mut self) {
        self.fixed.tidy();
        self.movable.tidy();
    }

    fn tree_mut(&mut self, kind: TreeKind) -> &mut Tree {
        match kind {
            TreeKind::Fixed => &mut self.fixed,
            TreeKind::Movable => &mut self.movable,
        }
    }
}

/// The binary exponent of a length. Halves and doubles of a size differ in it, on every machine alike.
fn exponent(length: Real) -> u16 {
    let bits = f64::from(length).to_bits();
    u16::try_from((bits >> 52) & 0x7ff).unwrap_or(0)
}

/// One tree and how much it grew.
#[derive(Clone, Debug, Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Tree {
    pub boxes: BoxTree,
    /// Number of boxes when the tree was last built as a whole.
    built: usize,
}

impl Tree {
    /// Gives a slot its box, whether or not it had one.
    pub fn insert(&mut self, aabb: Aabb, slot: u32) {
        self.boxes.insert(&aabb, slot);
    }

    /// Rebuilds the tree if half of its boxes are new, or all have been put elsewhere many times.
    pub fn tidy(&mut self) {
        let count = self.boxes.len();
        let is_worn = self.boxes.wear() > REBUILD_WEAR * count;
        if count >= REBUILD_MIN && (count / 2 > self.built || is_worn) {
            self.boxes.rebuild();
            self.built = count;
        }
    }
}
