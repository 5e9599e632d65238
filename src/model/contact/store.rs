//! Pairs that outlive a step: found by id, by their two colliders, or by one collider.
//!
//! A pair's id is stable from the first overlap of the two enlarged boxes to the last. Three views of
//! the same pairs are kept in step, each repaired in constant time when a pair goes:
//!
//! * `entries`: id → pair, with holes;
//! * `known`: two collider slots → id, for the broad phase, which asks whether it found something new
//!   (a hash map, never iterated: its order depends on the hash);
//! * `of_collider`: collider slot → ids, for edits and for walking islands;
//! * `awake`: what the narrow phase visits each step. Pairs of sleeping bodies are not in it.

use crate::base::hash::FastHashMap;
use crate::base::wide::prefetch;
use crate::dim::math::Real;
use crate::model::collider::ColliderHandle;
use crate::model::island::NONE;

/// Stable for the life of the pair.
pub(crate) type PairId = u32;

/// The slack of a pair that must be computed whether or not anything moved.
pub(crate) const DUE: Real = Real::NEG_INFINITY;

/// What a store needs to know of a pair.
pub(crate) trait Pair {
    /// The two colliders, in the pair's order.
    fn colliders(&self) -> [ColliderHandle; 2];

    /// Asks for what the pair keeps elsewhere in memory: for where it is, then for what is there.
    fn prefetch(&self, _what_is_there: bool) {}
}

/// A pair that the narrow phase visits, with all it needs to decide that nothing must be done.
#[derive(Copy, Clone, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct AwakePair {
    pub id: PairId,
    /// Slots of the two bodies; [`NONE`] for a collider without a body.
    pub bodies: [u32; 2],
    /// How far (length units) the two may still move against each other before the pair must be
    /// computed again. Every step takes off a bound of what the two bodies moved.
    pub slack: Real,
    /// Does somebody want to hear of strong contact forces of this pair?
    pub reports_force: bool,
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Entry<P> {
    pair: P,
    bodies: [u32; 2],
    /// Positions in the `of_collider` lists of the two colliders.
    positions: [u32; 2],
    /// Position in the `awake` list, or [`NONE`].
    awake: u32,
}

/// The parts of a store that differ in who may write them.
pub(crate) struct StoreParts<'a, P> {
    /// What the narrow phase visits.
    pub awake: &'a [AwakePair],
    /// The ids of the pairs of each collider slot.
    pub of_collider: &'a [Vec<PairId>],
    /// All entries by id.
    pub entries: &'a mut [Option<Entry<P>>],
}

/// All pairs of one kind. See the [module](self).
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct PairStore<P> {
    entries: Vec<Option<Entry<P>>>,
    free: Vec<PairId>,
    known: FastHashMap<(u32, u32), PairId>,
    of_collider: Vec<Vec<PairId>>,
    awake: Vec<AwakePair>,
}

impl<P> Default for PairStore<P> {
    fn default() -> Self {
        Self {
            entries: Vec::new(),
            free: Vec::new(),
            known: FastHashMap::default(),
            of_collider: Vec::new(),
            awake: Vec::new(),
        }
    }
}

fn slot(handle: ColliderHandle) -> u32 {
    handle.into_raw_parts().0
}

fn key(slot1: u32, slot2: u32) -> (u32, u32) {
    (slot1.min(slot2), slot1.max(slot2))
}

impl<P: Pair> PairStore<P> {
    /// Number of pairs.
    pub fn len(&self) -> usize {
        self.known.len()
    }

    /// Do these two collider slots have a pair?
    #[inline]
    pub fn contains(&self, slot1: u32, slot2: u32) -> bool {
        self.known.contains_key(&key(slot1, slot2))
    }

    /// The pair of two colliders, in either order.
    pub fn find(&self, collider1: ColliderHandle, collider2: ColliderHandle) -> Option<&P> {
        let id = *self.known.get(&key(slot(collider1), slot(collider2)))?;
        let pair = &self[id];
        // The slots may have had other tenants when the pair was made.
        let [c1, c2] = pair.colliders();
        let same = (c1 == collider1 && c2 == collider2) || (c1 == collider2 && c2 == collider1);
        same.then_some(pair)
    }

    /// All pairs in id order.
    pub fn iter(&self) -> impl Iterator<Item = &P> {
        self.entries.iter().flatten().map(|entry| &entry.pair)
    }

    /// Ids of the pairs of the collider in a slot.
    pub fn ids_of(&self, collider_slot: u32) -> &[PairId] {
        self.of_collider.get(collider_slot as usize).map_or(&[], Vec::as_slice)
    }

    /// Adds an awake pair that is due to be computed.
    pub fn insert(&mut self, pair: P, bodies: [u32; 2]) -> PairId {
        let slots = pair.colliders().map(slot);
        let id = self.free.pop().unwrap_or_else(|| {
            self.entries.push(None);
            self.entries.len() as u32 - 1
        });
        let clash = self.known.insert(key(slots[0], slots[1]), id);
        debug_assert!(clash.is_none(), "colliders {slots:?} already have a pair");
        let positions = slots.map(|slot| self.list_under(slot, id));
        self.entries[id as usize] = Some(Entry { pair, bodies, positions, awake: NONE });
        self.wake(id);
        id
    }

    fn list_under(&mut self, collider_slot: u32, id: PairId) -> u32 {
        let slot = collider_slot as usize;
        if slot >= self.of_collider.len() {
            self.of_collider.resize_with(slot + 1, Vec::new);
        }
        self.of_collider[slot].push(id);
        self.of_collider[slot].len() as u32 - 1
    }

    /// Takes a pair out.
    #[expect(
        clippy::expect_used,
        reason = "ids are ours, and those of pairs that went are forgotten"
    )]
    pub fn remove(&mut self, id: PairId) -> P {
        self.sleep(id);
        let entry = self.entries[id as usize].take().expect("the id is of a living pair");
        self.free.push(id);
        let slots = entry.pair.colliders().map(slot);
        self.known.remove(&key(slots[0], slots[1]));
        for side in 0..2 {
            self.unlist(slots[side], entry.positions[side], id);
        }
        entry.pair
    }

    /// Swap-removes a pair from a collider's list and repairs the entry that took its place.
    #[expect(
        clippy::expect_used,
        reason = "ids are ours, and those of pairs that went are forgotten"
    )]
    fn unlist(&mut self, collider_slot: u32, position: u32, id: PairId) {
        let list = &mut self.of_collider[collider_slot as usize];
        let removed = list.swap_remove(position as usize);
        debug_assert_eq!(removed, id);
        let Some(&moved) = list.get(position as usize) else { return };
        let entry = self.entries[moved as usize].as_mut().expect("lists hold living pairs");
        let side = usize::from(slot(entry.pair.colliders()[0]) != collider_slot);
        entry.positions[side] = position;
    }

    /// Puts a pair on the list of what the narrow phase visits, due to be computed.
    pub fn wake(&mut self, id: PairId) {
        let position = self.awake.len() as u32;
        let entry = self.entry_mut(id);
        if entry.awake == NONE {
            entry.awake = position;
            let bodies = entry.bodies;
            self.awake.push(AwakePair { id, bodies, slack: DUE, reports_force: false });
        }
    }

    /// Takes a pair off the list of what the narrow phase visits.
    pub fn sleep(&mut self, id: PairId) {
        let position = core::mem::replace(&mut self.entry_mut(id).awake, NONE);
        if position == NONE {
            return;
        }
        let removed = self.awake.swap_remove(position as usize);
        debug_assert_eq!(removed.id, id);
        if let Some(moved) = self.awake.get(position as usize).map(|pair| pair.id) {
            self.entry_mut(moved).awake = position;
        }
    }

    /// Must be computed in the next step, whether or not anything moves.
    pub fn invalidate(&mut self, id: PairId) {
        let position = self.entry_mut(id).awake;
        if position != NONE {
            self.awake[position as usize].slack = DUE;
        }
    }

    /// Is the pair visited by the narrow phase?
    pub fn is_awake(&self, id: PairId) -> bool {
        self.entry(id).awake != NONE
    }

    /// Slots of the two bodies; [`NONE`] for a collider without a body.
    pub fn bodies(&self, id: PairId) -> [u32; 2] {
        self.entry(id).bodies
    }

    /// Begins to bring a pair near to the processor.
    pub fn prefetch(&self, id: PairId) {
        if let Some(entry) = self.entries.get(id as usize) {
            prefetch(entry);
        }
    }

    /// What the narrow phase visits.
    pub fn awake(&self) -> &[AwakePair] {
        &self.awake
    }

    /// The store, taken apart.
    pub fn split(&mut self) -> StoreParts<'_, P> {
        StoreParts {
            awake: &self.awake,
            of_collider: &self.of_collider,
            entries: &mut self.entries,
        }
    }

    /// The pair of an entry; `None` if there is none with this id.
    pub fn pair(entry: &Option<Entry<P>>) -> Option<&P> {
        entry.as_ref().map(|entry| &entry.pair)
    }

    /// The pair of an entry; `None` if there is none with this id.
    pub fn pair_mut(entry: &mut Option<Entry<P>>) -> Option<&mut P> {
        entry.as_mut().map(|entry| &mut entry.pair)
    }

    /// What the narrow phase visits.
    pub fn awake_mut(&mut self) -> &mut [AwakePair] {
        &mut self.awake
    }

    #[expect(
        clippy::expect_used,
        reason = "ids are ours, and those of pairs that went are forgotten"
    )]
    #[inline]
    fn entry(&self, id: PairId) -> &Entry<P> {
        self.entries[id as usize].as_ref().expect("the id is of a living pair")
    }

    #[expect(
        clippy::expect_used,
        reason = "ids are ours, and those of pairs that went are forgotten"
    )]
    #[inline]
    fn entry_mut(&mut self, id: PairId) -> &mut Entry<P> {
        self.entries[id as usize].as_mut().expect("the id is of a living pair")
    }

    /// Checks that the views agree.
    pub fn validate(&self) {
        let living = self.entries.iter().flatten().count();
        assert_eq!(living, self.known.len());
        assert_eq!(living + self.free.len(), self.entries.len());
        for (id, entry) in self.entries.iter().enumerate() {
            let Some(entry) = entry else { continue };
            let slots = entry.pair.colliders().map(slot);
            assert_eq!(self.known.get(&key(slots[0], slots[1])), Some(&(id as u32)));
            for side in 0..2 {
                let list = &self.of_collider[slots[side] as usize];
                assert_eq!(list[entry.positions[side] as usize], id as u32);
            }
            if entry.awake != NONE {
                let awake = &self.awake[entry.awake as usize];
                assert_eq!((awake.id, awake.bodies), (id as u32, entry.bodies));
            }
        }
        for (position, awake) in self.awake.iter().enumerate() {
            assert_eq!(self.entry(awake.id).awake, position as u32);
        }
    }
}

impl<P: Pair> core::ops::Index<PairId> for PairStore<P> {
    type Output = P;

    #[inline]
    fn index(&self, id: PairId) -> &P {
        &self.entry(id).pair
    }
}

impl<P: Pair> core::ops::IndexMut<PairId> for PairStore<P> {
    #[inline]
    fn index_mut(&mut self, id: PairId) -> &mut P {
        &mut self.entry_mut(id).pair
    }
}
