//! Trees of boxes: the broad phase.
//!
//! Each collider is in one of three trees, with a box somewhat larger than itself. While it stays inside,
//! nothing is done. When it leaves, it gets a new box and is noted as moved, and only moved colliders search
//! for new neighbours. Fixed colliders have a tree of their own, so that they never find each other. The few
//! kinematic colliders have a tree, so that the search along paths of fast bodies does not visit all dynamic
//! ones. Colliders of fixed and sleeping bodies are free: no per-step loop visits them.

mod check;
mod enlarge;
mod box_update;
mod proxy;
mod shape_box;
#[cfg(test)]
mod tests;
mod trees;

pub(crate) use box_update::{MovedProxy, update_moved_proxy};
pub(crate) use enlarge::BoxMargin;
pub(crate) use proxy::{ColliderProxy, TreeKind};
pub(crate) use shape_box::shape_box;
pub(crate) use trees::{AllBoxes, Trees};

use crate::base::bvh::{BoxProbe, BoxTree};
use crate::base::in_place::clone_in_place;
use crate::dim::math::Real;
use crate::model::collider::{ColliderHandle, InteractionGroups};
use crate::model::stamp::WorldStamp;
use parry::bounding_volume::Aabb;

/// The broad phase of a world. It is the only implementation.
pub type DefaultBroadPhase = BroadPhaseBvh;

/// The fat AABBs of all colliders.
#[derive(Debug, Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct BroadPhaseBvh {
    trees: Trees,
    /// Slots of the colliders that have a new box since the last search for pairs.
    moved: Vec<u32>,
    /// One bit per slot: set if `moved` contains the slot.
    moved_bits: Vec<u64>,
    /// By slot: the binary exponent of the longest side of its fat AABB.
    sizes: Vec<u16>,
    /// Whether any collider of a fixed body ever requested pairs with others of its kind.
    fixed_meet: bool,
    /// Whether any collider was ever a sensor.
    has_sensors: bool,
    /// One bit per slot: set if its collider is a sensor.
    sensor_bits: Vec<u64>,
    /// Union of all groups and filters of the colliders of these trees.
    groups: Option<InteractionGroups>,
    pub(crate) stamp: WorldStamp,
}

clone_in_place!(BroadPhaseBvh {
    trees,
    moved,
    moved_bits,
    sizes,
    fixed_meet,
    has_sensors,
    sensor_bits,
    groups,
    stamp
});

impl BroadPhaseBvh {
    /// Empty trees.
    pub fn new() -> Self {
        Self::default()
    }

    /// Inserts or updates a collider in a tree: afterwards its fat AABB contains `tight`, in the tree of its
    /// kind. Returns whether the fat AABB changed.
    ///
    /// A box that is not finite, or beyond the limits of the world, is not inserted. The collider is left
    /// out, with a warning when that begins.
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
                log::warn!(
                    "collider {slot} has the invalid bounding box {tight:?} and does not collide"
                );
            }
            proxy.is_refused = true;
            return self.remove(slot, proxy);
        };
        proxy.is_refused = false;
        let is_new = proxy.fit(kind, &needed, margin);
        if is_new {
            self.put(handle, kind, &proxy.fat_aabb);
        }
        is_new
    }

    /// Gives a collider the box, in the tree of a kind, that its proxy has taken.
    pub(crate) fn put(&mut self, handle: ColliderHandle, kind: TreeKind, aabb: &Aabb) {
        let (slot, _) = handle.into_raw_parts();
        self.trees.put(slot, kind, aabb);
        self.note_size(slot, aabb);
        self.mark_moved(slot);
    }

    /// Prefetches the data that changes with the box of a collider.
    pub(crate) fn prefetch(&self, handle: ColliderHandle, kind: TreeKind) {
        self.boxes(kind).prefetch(handle.into_raw_parts().0);
    }

    fn note_size(&mut self, slot: u32, aabb: &Aabb) {
        let slot = slot as usize;
        if slot >= self.sizes.len() {
            self.sizes.resize(slot + 1, 0);
        }
        self.sizes[slot] = exponent(aabb.extents().max_element());
    }

    /// The binary exponent of the longest side of the last box at a slot.
    pub(crate) fn size(&self, slot: u32) -> u16 {
        self.sizes.get(slot as usize).copied().unwrap_or(0)
    }

    /// Returns whether a collider owns the pair with another: the smaller one does. Among equals it is the
    /// one that is no sensor, or else the later one.
    pub(crate) fn owns(&self, slot: u32, other_slot: u32) -> bool {
        let order = |slot: u32, other: u32| (self.size(slot), self.is_sensor(slot), other);
        order(slot, other_slot) < order(other_slot, slot)
    }

    /// Removes a collider. Returns whether it was in a tree.
    pub(crate) fn remove(&mut self, slot: u32, proxy: &mut ColliderProxy) -> bool {
        self.remove_slot(slot);
        proxy.tree.take().is_some()
    }

    /// Removes the box at the slot, after the collider was removed.
    pub(crate) fn remove_slot(&mut self, slot: u32) {
        self.trees.remove(slot);
    }

    /// Includes all neighbours of the collider in the next search, as after a change of its groups.
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

    /// Slots of the colliders that must search for partners.
    pub(crate) fn moved(&self) -> &[u32] {
        &self.moved
    }

    /// Returns whether the collider at this slot must search for partners.
    pub(crate) fn is_moved(&self, slot: u32) -> bool {
        let word = self.moved_bits.get(slot as usize / 64).copied().unwrap_or(0);
        word & (1 << (slot % 64)) != 0
    }

    /// Marks the search as complete.
    pub(crate) fn clear_moved(&mut self) {
        for slot in self.moved.drain(..) {
            self.moved_bits[slot as usize / 64] = 0;
        }
    }

    /// Notes whether the collider at a slot is a sensor.
    fn note_sensor(&mut self, slot: u32, is_sensor: bool) {
        self.has_sensors |= is_sensor;
        let (word, bit) = (slot as usize / 64, 1_u64 << (slot % 64));
        if !is_sensor {
            self.sensor_bits.get_mut(word).into_iter().for_each(|word| *word &= !bit);
            return;
        }
        if word >= self.sensor_bits.len() {
            self.sensor_bits.resize(word + 1, 0);
        }
        self.sensor_bits[word] |= bit;
    }

    /// Returns whether the collider at a slot is a sensor.
    #[inline]
    pub(crate) fn is_sensor(&self, slot: u32) -> bool {
        let word = self.sensor_bits.get(slot as usize / 64).copied().unwrap_or(0);
        word & (1 << (slot % 64)) != 0
    }

    /// Returns whether any collider may be a sensor.
    pub(crate) fn has_sensors(&self) -> bool {
        self.has_sensors
    }

    /// Returns whether a collider of this kind must search for partners of the other kind.
    pub(crate) fn may_meet(&self, kind1: TreeKind, kind2: TreeKind) -> bool {
        self.fixed_meet || kind1.is_movable() || kind2.is_movable()
    }

    /// Returns whether a collider of these groups may interact with any other. Colliders that only queries
    /// find, such as debris without collisions, need no search.
    pub(crate) fn may_meet_any(&self, groups: InteractionGroups) -> bool {
        self.groups.is_some_and(|all| groups.test(all))
    }

    /// The boxes of one kind of colliders, by slot.
    pub(crate) fn boxes(&self, kind: TreeKind) -> &BoxTree {
        self.trees.boxes(kind)
    }

    /// The boxes of all colliders, by slot, in trees.
    pub(crate) fn all_boxes(&self) -> AllBoxes<'_> {
        self.trees.all()
    }

    /// Calls back for the slots of the colliders of one kind whose fat AABBs overlap a box.
    pub(crate) fn for_each_overlapping(&self, kind: TreeKind, aabb: &Aabb, visit: impl FnMut(u32)) {
        self.boxes(kind).for_each_leaf(&BoxProbe(*aabb), visit);
    }

    /// See [`Trees::tidy`].
    pub(crate) fn tidy(&mut self) {
        self.trees.tidy();
    }
}

/// The binary exponent of a length. Halves and doubles of a size differ in it, on every machine alike.
fn exponent(length: Real) -> u16 {
    let bits = f64::from(length).to_bits();
    u16::try_from((bits >> 52) & 0x7ff).unwrap_or(0)
}
