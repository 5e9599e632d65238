//! Pairs that outlive a step: found by id, by their two colliders, or by one collider.
//!
//! A pair's id is stable from the first overlap of the two fat AABBs to the last. Several views of the same
//! pairs are kept in step, each repaired in constant time when a pair goes:
//!
//! * `pairs`: id → pair, with holes. Large, so most stages avoid it;
//! * `states`: id → the data that each step reads if the pair is awake, 16 bytes, contiguous;
//! * `of_collider`: collider slot → ids and partners; and `places`: id → the two colliders, and the positions
//!   in their lists;
//! * `awake`: the ids that the narrow phase visits each step, in their order, which is that of memory. Pairs
//!   of sleeping bodies are not in it;
//! * `reporting`: the awake pairs whose strong forces are reported as events. Most worlds have none;
//! * `renewed`: the ids of pairs that changed since the solver's last reading.
//!
//! The rejected alternative is a hash map from two colliders to their pair. The broad phase finds the same
//! neighbours step after step, and would need a map access for each. Instead it marks the few partners of a
//! collider. The map also had to be updated for each new and removed pair. Together that took a tenth of the
//! step of 9,600 bodies in flight.

mod check;

use super::lanes::ContactLanes;
use crate::base::disjoint::DisjointMut;
use crate::base::id_set::IdSet;
use crate::base::in_place::clone_in_place;
use crate::base::late::Late;
use crate::base::tasks::{Gather, Tasks};
use crate::base::wide::prefetch;
use crate::dim::math::Real;
use crate::model::collider::ColliderHandle;
use core::ops::Range;

/// Number of pages of 512 ids per parallel task.
const PAGES_PER_TASK: usize = 2;

/// Id of a pair, stable for its lifetime.
pub(crate) type PairId = u32;

/// The slack of a due pair, which must be computed even without motion.
pub(crate) const SLACK_DUE: Real = Real::NEG_INFINITY;

/// The store's data of a pair.
pub(crate) trait Pair {
    /// The two colliders, in the pair's order.
    fn colliders(&self) -> [ColliderHandle; 2];

    /// Returns whether the pair was reported as started and not yet as stopped.
    fn began(&self) -> bool;

    /// Returns whether it is the pair of these two, in either order.
    fn is_of(&self, [one, two]: [ColliderHandle; 2]) -> bool {
        let colliders = self.colliders();
        colliders == [one, two] || colliders == [two, one]
    }

    /// Prefetches the results of the last step for the pair.
    fn prefetch_report(&self, _lanes: &ContactLanes) {}

    /// Prefetches the head of the pair's data elsewhere in memory, which contains the address of the content.
    fn prefetch_address(&self) {}

    /// Prefetches that content, after its address has arrived.
    fn prefetch_content(&self) {}
}

/// Data with which the narrow phase decides whether to skip a pair.
#[derive(Copy, Clone, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct PairState {
    /// Slots of the two bodies; [`NONE`](crate::model::island::NONE) for a collider without a body.
    pub bodies: [u32; 2],
    /// Admissible relative motion (length units) of the two until the pair must be computed again. Every step
    /// subtracts a bound on the relative motion of the two bodies.
    pub slack: Real,
    /// Whether contacts of a dynamic body with a non-dynamic collider were ever found. Ghost contacts are
    /// searched among such pairs alone, and most of a body's pairs are none.
    pub touched_non_dynamic: bool,
}

/// Positions of a pair in the lists of its two colliders.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
struct Place {
    slots: [u32; 2],
    positions: [u32; 2],
}

impl Place {
    /// The value for an id without a pair.
    const NOWHERE: Self = Self { slots: [u32::MAX; 2], positions: [u32::MAX; 2] };
}

/// The pairs of one collider.
#[derive(Debug, Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Partners {
    pub ids: Vec<PairId>,
    /// The slot of the other one of each.
    slots: Vec<u32>,
}

clone_in_place!(Partners { ids, slots });

/// The parts of a store with separate write access.
pub(crate) struct StoreParts<'a, P> {
    /// The narrow phase's data, by id.
    pub states: &'a mut [PairState],
    pub slots: PairSlots<'a>,
    /// The pairs of each collider slot.
    pub of_collider: &'a [Partners],
    /// The awake pairs whose strong forces are reported.
    pub reporting: &'a IdSet,
    /// All pairs by id.
    pub pairs: &'a mut [Option<P>],
}

/// By id, the slots of the two colliders of a pair.
#[derive(Copy, Clone)]
pub(crate) struct PairSlots<'a>(&'a [Place]);

impl PairSlots<'_> {
    pub fn of(&self, id: PairId) -> [u32; 2] {
        self.0[id as usize].slots
    }

    /// Prefetches the two colliders of a pair.
    pub fn prefetch(&self, id: PairId) {
        prefetch(&self.0[id as usize]);
    }
}

/// All pairs of one kind. See the [module](self).
#[derive(Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde-serialize", serde(remote = "Self"))]
pub(crate) struct PairStore<P> {
    pairs: Vec<Late<Option<P>>>,
    states: Vec<PairState>,
    places: Vec<Place>,
    free: Vec<PairId>,
    of_collider: Vec<Partners>,
    awake: IdSet,
    reporting: IdSet,
    /// Pairs whose force reached the threshold in their last step awake.
    strong: IdSet,
    #[cfg_attr(feature = "serde-serialize", serde(skip))]
    renewed: IdSet,
}

clone_in_place!(PairStore<P> { pairs, states, places, free, of_collider, awake, reporting, strong, renewed });

impl<P> Default for PairStore<P> {
    fn default() -> Self {
        Self {
            pairs: Vec::new(),
            states: Vec::new(),
            places: Vec::new(),
            free: Vec::new(),
            of_collider: Vec::new(),
            awake: IdSet::default(),
            reporting: IdSet::default(),
            strong: IdSet::default(),
            renewed: IdSet::default(),
        }
    }
}

fn slot(handle: ColliderHandle) -> u32 {
    handle.into_raw_parts().0
}

impl<P: Pair> PairStore<P> {
    /// Number of pairs.
    pub fn len(&self) -> usize {
        self.pairs.len() - self.free.len()
    }

    /// The pair of two collider slots, in either order. When it was made other colliders may have been there.
    ///
    /// The cost is linear in the smaller of the two numbers of partners.
    pub fn find(&self, colliders: [ColliderHandle; 2]) -> Option<PairId> {
        let [slot1, slot2] = colliders.map(slot);
        let is_shorter = self.ids_of(slot1).len() <= self.ids_of(slot2).len();
        let (few, other) = if is_shorter { (slot1, slot2) } else { (slot2, slot1) };
        let list = self.of_collider.get(few as usize)?;
        list.slots.iter().position(|&slot| slot == other).map(|position| list.ids[position])
    }

    /// The partners of the collider in a slot.
    #[inline]
    pub fn partners(&self, collider_slot: u32) -> &[u32] {
        self.of_collider.get(collider_slot as usize).map_or(&[], |list| &list.slots)
    }

    /// Writes to a pair behind a shared reference.
    ///
    /// # Safety
    /// The caller has exclusive access to the pair.
    pub unsafe fn write(&self, id: PairId, write: impl FnOnce(&mut P)) {
        // SAFETY: the caller's promise.
        unsafe {
            self.pairs[id as usize].write(|pair| {
                if let Some(pair) = pair {
                    write(pair)
                }
            })
        };
    }

    /// All pairs in id order.
    pub fn iter(&self) -> impl Iterator<Item = &P> {
        self.pairs.iter().filter_map(|pair| pair.get().as_ref())
    }

    /// The ids of all pairs, in their order. Reads no pair.
    pub fn ids(&self) -> impl Iterator<Item = PairId> {
        let living = |(id, place): (usize, &Place)| (*place != Place::NOWHERE).then_some(id as u32);
        self.places.iter().enumerate().filter_map(living)
    }

    /// Exclusive upper bound of the ids.
    pub fn id_bound(&self) -> usize {
        self.pairs.len()
    }

    /// Ids of the pairs of the collider in a slot.
    pub fn ids_of(&self, collider_slot: u32) -> &[PairId] {
        self.of_collider.get(collider_slot as usize).map_or(&[], |list| &list.ids)
    }

    /// Adds an awake pair that is due to be computed.
    pub fn insert(&mut self, pair: P, bodies: [u32; 2]) -> PairId {
        let slots = pair.colliders().map(slot);
        let id = self.free.pop().unwrap_or(self.pairs.len() as u32);
        debug_assert!(
            self.find(pair.colliders()).is_none(),
            "colliders {slots:?} already have a pair"
        );
        let place = Place { slots, positions: self.list(slots, id) };
        let state = PairState { bodies, slack: SLACK_DUE, touched_non_dynamic: false };
        if let Some(free) = self.pairs.get_mut(id as usize) {
            *free.get_mut() = Some(pair);
            self.states[id as usize] = state;
            self.places[id as usize] = place;
        } else {
            self.pairs.push(Late::new(Some(pair)));
            self.states.push(state);
            self.places.push(place);
        }
        self.awake.insert(id);
        self.renewed.insert(id);
        id
    }

    /// Puts a pair into the lists of both colliders. Returns its positions there.
    fn list(&mut self, [slot1, slot2]: [u32; 2], id: PairId) -> [u32; 2] {
        let bound = slot1.max(slot2) as usize + 1;
        if bound > self.of_collider.len() {
            self.of_collider.resize_with(bound, Partners::default);
        }
        [(slot1, slot2), (slot2, slot1)].map(|(own, other)| {
            let list = &mut self.of_collider[own as usize];
            list.ids.push(id);
            list.slots.push(other);
            list.ids.len() as u32 - 1
        })
    }

    /// Takes a pair out. Returns the two colliders if their begin event was emitted, and no end event since.
    pub fn remove(&mut self, id: PairId) -> Option<[ColliderHandle; 2]> {
        self.sleep(id);
        self.strong.remove(id);
        let reported = self[id].began().then(|| self[id].colliders());
        // The address of the pair: a pair has some hundred bytes.
        *self.pairs[id as usize].get_mut() = None;
        self.free.push(id);
        let Place { slots, positions } =
            core::mem::replace(&mut self.places[id as usize], Place::NOWHERE);
        for side in 0..2 {
            self.unlist(slots[side], positions[side], id);
        }
        reported
    }

    /// Swap-removes a pair from a collider's list and repairs the place of the one that took its place.
    fn unlist(&mut self, collider_slot: u32, position: u32, id: PairId) {
        let list = &mut self.of_collider[collider_slot as usize];
        let removed = list.ids.swap_remove(position as usize);
        debug_assert_eq!(removed, id);
        list.slots.swap_remove(position as usize);
        let Some(&moved) = list.ids.get(position as usize) else { return };
        let place = &mut self.places[moved as usize];
        let side = usize::from(place.slots[0] != collider_slot);
        place.positions[side] = position;
    }

    /// Inserts a pair into the list that the narrow phase visits. A pair that was outside is due.
    pub fn wake(&mut self, id: PairId) {
        if self.awake.insert(id) {
            self.invalidate(id);
        }
    }

    /// Removes a pair from the list that the narrow phase visits.
    pub fn sleep(&mut self, id: PairId) {
        self.awake.remove(id);
        self.reporting.remove(id);
    }

    /// The pairs whose force reached the threshold in their last step awake.
    pub fn strong_mut(&mut self) -> &mut IdSet {
        &mut self.strong
    }

    /// Sets whether strong forces of an awake pair are reported.
    pub fn set_reporting(&mut self, id: PairId, reports: bool) {
        if reports {
            self.reporting.insert(id);
        } else {
            self.reporting.remove(id);
            self.strong.remove(id);
        }
    }

    /// The awake pairs whose strong forces are reported, in the order of the ids.
    pub fn reporting(&self) -> impl Iterator<Item = PairId> {
        self.reporting.iter()
    }

    /// Marks pairs as changed for the solver. They come in the order of the ids.
    pub fn renew(&mut self, ids: impl Iterator<Item = PairId>) {
        self.renewed.extend(ids);
    }

    /// Marks all awake pairs as changed for the solver.
    pub fn renew_all(&mut self) {
        self.renewed = self.awake.clone();
    }

    /// Returns whether a pair changed since the solver's last reading.
    #[inline]
    pub fn is_renewed(&self, id: PairId) -> bool {
        self.renewed.contains(id)
    }

    /// Marks all pairs as read by the solver.
    pub fn clear_renewed(&mut self) {
        self.renewed.clear();
    }

    /// Marks the pair as due in the next step, independent of motion.
    pub fn invalidate(&mut self, id: PairId) {
        self.states[id as usize].slack = SLACK_DUE;
    }

    /// Marks all pairs as due in the next step.
    pub fn invalidate_all(&mut self) {
        self.states.iter_mut().for_each(|state| state.slack = SLACK_DUE);
    }

    /// Returns whether the narrow phase visits the pair.
    pub fn is_awake(&self, id: PairId) -> bool {
        self.awake.contains(id)
    }

    /// Slots of the two bodies; [`NONE`](crate::model::island::NONE) for a collider without a body.
    #[inline]
    pub fn bodies(&self, id: PairId) -> [u32; 2] {
        self.states[id as usize].bodies
    }

    /// The slots of its two colliders.
    #[inline]
    pub fn collider_slots(&self, id: PairId) -> [u32; 2] {
        self.places[id as usize].slots
    }

    /// Prefetches the slot of the pair that is inserted after `after` others.
    pub fn prefetch_vacancy(&self, after: usize) {
        let last = self.free.len().checked_sub(1 + after);
        last.into_iter().for_each(|last| self.prefetch(self.free[last]));
    }

    /// Prefetches a pair.
    pub fn prefetch(&self, id: PairId) {
        if let Some(pair) = self.pairs.get(id as usize) {
            prefetch(pair);
        }
    }

    /// Prefetches the lists of a pair's two colliders.
    pub fn prefetch_lists(&self, collider_slots: [u32; 2]) {
        let lists = collider_slots.map(|slot| self.of_collider.get(slot as usize));
        lists.into_iter().flatten().for_each(prefetch);
    }

    /// Visits the awake pairs, in the order of the ids.
    pub fn for_each_awake_pair(&mut self, tasks: Tasks<'_>, visit: impl Fn(PairId, &mut P) + Sync)
    where
        P: Send + Sync,
    {
        let (awake, pairs) = (&self.awake, DisjointMut::new(Late::slice_mut(&mut self.pairs)));
        tasks.par_for(awake.page_count(), PAGES_PER_TASK, |pages| {
            awake.iter_in(pages).for_each(|id| {
                // SAFETY: the set names each pair once, and the pages of two tasks differ.
                let pair = unsafe { pairs.get_mut(id as usize) };
                pair.iter_mut().for_each(|pair| visit(id, pair));
            });
        });
    }

    /// Appends the awake pairs for which `is_selected` to a list, in their order. The callback may change the
    /// narrow phase's data of the pairs.
    pub fn list_awake(
        &mut self,
        tasks: Tasks<'_>,
        gather: &mut Gather<PairId>,
        is_selected: impl Fn(&mut PairState) -> bool + Sync,
        list: &mut Vec<PairId>,
    ) {
        let (awake, states) = (&self.awake, DisjointMut::new(&mut self.states));
        let find = |pages: Range<usize>, found: &mut Vec<PairId>| {
            awake.iter_in(pages).for_each(|id| {
                // SAFETY: the set names each pair once, and the pages of two tasks differ.
                if is_selected(unsafe { states.get_mut(id as usize) }) {
                    found.push(id);
                }
            });
        };
        gather.run(tasks, (awake.page_count(), PAGES_PER_TASK), find, list);
    }

    /// The admissible relative motion of the two until the pair must be computed again.
    pub fn slack(&self, id: PairId) -> Real {
        self.states[id as usize].slack
    }

    /// The narrow phase's data of a pair.
    pub fn state_mut(&mut self, id: PairId) -> &mut PairState {
        &mut self.states[id as usize]
    }

    /// The store, taken apart.
    pub fn split(&mut self) -> StoreParts<'_, P> {
        StoreParts {
            states: &mut self.states,
            slots: PairSlots(&self.places),
            of_collider: &self.of_collider,
            reporting: &self.reporting,
            pairs: Late::slice_mut(&mut self.pairs),
        }
    }
}

impl<P: Pair> core::ops::Index<PairId> for PairStore<P> {
    type Output = P;

    #[expect(
        clippy::expect_used,
        reason = "the store creates all ids, and drops the ids of removed pairs"
    )]
    #[inline]
    fn index(&self, id: PairId) -> &P {
        self.pairs[id as usize].get().as_ref().expect("the id is of a living pair")
    }
}

impl<P: Pair> core::ops::IndexMut<PairId> for PairStore<P> {
    #[expect(
        clippy::expect_used,
        reason = "the store creates all ids, and drops the ids of removed pairs"
    )]
    #[inline]
    fn index_mut(&mut self, id: PairId) -> &mut P {
        self.pairs[id as usize].get_mut().as_mut().expect("the id is of a living pair")
    }
}
