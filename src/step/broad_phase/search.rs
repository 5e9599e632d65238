//! The neighbours of one collider.

use super::owned_pairs::{HandlePair, OwnedPairs};
use super::{COLLIDERS_PER_TASK, KnownPairs};
use crate::base::marks::Marks;
use crate::base::pool::Pool;
use crate::base::tasks::Tasks;
use crate::base::wide::{PREFETCH_DISTANCE, prefetch};
use crate::model::collider::{Collider, ColliderHandle, ColliderSet, may_interact};
use crate::model::island::IslandManager;
use crate::model::params::IntegrationParameters;
use crate::model::tree::{BroadPhaseBvh, TreeKind};

/// Result of one thread.
#[derive(Default)]
pub(super) struct SearchResult {
    pub pairs: Vec<HandlePair>,
    /// Colliders that did not move and have at least the maximum number of partners, so that they must select
    /// their partners again.
    pub unmoved: Vec<u32>,
    /// Colliders with more candidates than they may own: of solids, and with sensors.
    pub refused: [Vec<u32>; 2],
    /// The pairs that one collider would own, by [`Kind`].
    owned: [OwnedPairs; Kind::ALL.len()],
    /// Known partners of the collider.
    known: Marks,
}

/// Pairs that are counted together.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
struct Kind {
    /// Whether one of the two is a sensor.
    is_sensed: bool,
    /// Whether the two have the same size. Otherwise the other one is larger than the owner.
    is_alike: bool,
}

impl Kind {
    const ALL: [Self; 4] = [
        Self { is_sensed: false, is_alike: false },
        Self { is_sensed: false, is_alike: true },
        Self { is_sensed: true, is_alike: false },
        Self { is_sensed: true, is_alike: true },
    ];

    fn index(self) -> usize {
        2 * usize::from(self.is_sensed) + usize::from(self.is_alike)
    }
}

/// Most pairs of each kind that a collider owns.
#[derive(Copy, Clone, Debug)]
pub(crate) struct NeighborLimits {
    /// Limit for solid colliders.
    pub solids: usize,
    /// With a sensor.
    pub sensors: usize,
}

impl NeighborLimits {
    pub fn of(params: &IntegrationParameters) -> Self {
        Self {
            solids: params.max_neighbors_per_collider,
            sensors: params.max_sensor_neighbors_per_collider,
        }
    }

    fn of_kind(self, kind: Kind) -> usize {
        if kind.is_sensed { self.sensors } else { self.solids }
    }
}

/// Context of the search.
pub(super) struct Search<'a, K> {
    pub tree: &'a BroadPhaseBvh,
    pub colliders: &'a ColliderSet,
    pub known: &'a K,
    pub islands: &'a IslandManager,
    pub most: NeighborLimits,
    /// Restricts the search to pairs that the searching collider would own.
    pub only_owned: bool,
}

/// The searching collider.
#[derive(Copy, Clone)]
struct SearchingCollider<'a> {
    slot: u32,
    handle: ColliderHandle,
    collider: &'a Collider,
    kind: TreeKind,
}

impl<K: KnownPairs> Search<'_, K> {
    /// Searches partners for the colliders at these slots.
    pub fn run(&self, tasks: Tasks<'_>, slots: &[u32], results: &Pool<SearchResult>) {
        tasks.par_for(slots.len(), COLLIDERS_PER_TASK, |range| {
            let mut found = results.take();
            for position in range {
                self.prefetch(slots.get(position + PREFETCH_DISTANCE));
                let slot = slots[position];
                // The collider may be gone since it moved, or disabled.
                let Some((handle, collider)) = self.colliders.at_slot(slot) else { continue };
                let Some(kind) = collider.proxy.tree else { continue };
                if !self.tree.may_meet_any(collider.collision_groups()) {
                    continue;
                }
                self.find_partners(SearchingCollider { slot, handle, collider, kind }, &mut found);
            }
            results.put(found);
        });
    }

    /// Prefetches the input of a collider's search.
    #[inline]
    fn prefetch(&self, slot: Option<&u32>) {
        let Some(&slot) = slot else { return };
        self.colliders.prefetch(slot);
        self.known.partners(slot).first().into_iter().for_each(prefetch);
    }

    /// Adds the new pairs of one collider. Nearly all results are known pairs.
    fn find_partners(&self, searching: SearchingCollider<'_>, found: &mut SearchResult) {
        for kind in Kind::ALL {
            found.owned[kind.index()].clear(self.most.of_kind(kind));
        }
        found.known.clear();
        let partners = self.known.partners(searching.slot);
        let all = partners.iter().chain(self.known.sensed(searching.slot));
        all.for_each(|&slot| found.known.mark(slot));
        found.known.mark(searching.slot);
        for other_kind in TreeKind::ALL {
            if !self.tree.may_meet(searching.kind, other_kind) {
                continue;
            }
            let is_movable = searching.kind.is_movable() && other_kind.is_movable();
            self.tree.for_each_overlapping(
                other_kind,
                &searching.collider.proxy.fat_aabb,
                |other| {
                    if !found.known.has(other) {
                        self.meet(searching, other, is_movable, found);
                    }
                },
            );
        }
        Kind::ALL.into_iter().for_each(|kind| self.take_nearest(searching.slot, kind, found));
    }

    /// Adds the pairs of a kind that a collider owns, up to the maximum.
    fn take_nearest(&self, slot: u32, kind: Kind, found: &mut SearchResult) {
        let owned = &mut found.owned[kind.index()];
        if owned.len() == 0 {
            return;
        }
        let mut places = self.most.of_kind(kind);
        if self.partners(slot, kind.is_sensed).len() + owned.len() > places {
            places -= self.count_owned(slot, kind).min(places);
        }
        if owned.len() > places {
            found.refused[usize::from(kind.is_sensed)].push(slot);
        }
        found.pairs.extend(owned.nearest(places));
    }

    /// The slots of the colliders that have pairs with one: as solids, or because of a sensor.
    fn partners(&self, slot: u32, is_sensed: bool) -> &[u32] {
        if is_sensed { self.known.sensed(slot) } else { self.known.partners(slot) }
    }

    /// Adds a new pair with the collider at another slot, if the two are to be one.
    #[inline]
    fn meet(
        &self,
        searching: SearchingCollider<'_>,
        other_slot: u32,
        is_movable: bool,
        found: &mut SearchResult,
    ) {
        let SearchingCollider { slot, handle, collider, .. } = searching;
        let owns = self.tree.owns(slot, other_slot);
        // If both moved, each finds the other.
        if !owns && (self.only_owned || self.tree.is_moved(other_slot)) {
            return;
        }
        let kind = self.kind_of(slot, other_slot);
        let owned = &mut found.owned[kind.index()];
        let slot_distance = slot.abs_diff(other_slot);
        if owns && is_movable && owned.leaves_out(slot_distance) {
            return;
        }
        let Some((other_handle, other)) = self.colliders.at_slot(other_slot) else { return };
        let is_parted = || !kind.is_sensed && self.islands.part_colliders(collider, other);
        if !may_interact(collider, other) || is_parted() {
            return;
        }
        let pair = if slot < other_slot { (handle, other_handle) } else { (other_handle, handle) };
        if self.only_owned && !is_movable {
            // New pairs of a moved partner were found by the first search.
            return;
        }
        if is_movable && owns {
            owned.push(slot_distance, pair);
        } else if is_movable && self.is_full(other_slot) {
            found.unmoved.push(other_slot);
        } else {
            found.pairs.push(pair);
        }
    }

    /// Returns whether a collider that did not move has to choose among new neighbours itself. It then
    /// finds the pairs of all kinds, so the answer is the same for all.
    fn is_full(&self, slot: u32) -> bool {
        self.partners(slot, false).len() >= self.most.solids
            || self.partners(slot, true).len() >= self.most.sensors
    }

    fn kind_of(&self, slot: u32, other_slot: u32) -> Kind {
        let is_sensed = self.tree.is_sensor(slot) || self.tree.is_sensor(other_slot);
        Kind { is_sensed, is_alike: self.tree.size(slot) == self.tree.size(other_slot) }
    }

    /// The number of pairs of one kind that the collider at a slot owns already.
    fn count_owned(&self, slot: u32, kind: Kind) -> usize {
        let is_movable = |other: u32| {
            let other = self.colliders.at_slot(other);
            other.is_some_and(|(_, other)| other.proxy.tree.is_some_and(TreeKind::is_movable))
        };
        let owned = |&other: &u32| {
            self.tree.owns(slot, other) && self.kind_of(slot, other) == kind && is_movable(other)
        };
        self.partners(slot, kind.is_sensed).iter().copied().filter(owned).count()
    }
}
