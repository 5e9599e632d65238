//! The narrow phase's state: every pair of colliders whose fat AABBs overlap.

use super::lanes::ContactLanes;
use super::pair::{ContactPair, IntersectionPair};
use super::store::{Pair, PairId, PairStore};
use crate::base::tasks::Tasks;
use crate::model::collider::ColliderHandle;
use crate::model::stamp::WorldStamp;

/// All contact and intersection pairs, kept from step to step.
///
/// A pair of solid colliders is a [`ContactPair`]; one with a sensor in it is an [`IntersectionPair`]. Both
/// exist from the first overlap of the colliders' fat AABBs, so a pair may exist without touching: see
/// [`ContactPair::has_any_active_contact`] and [`IntersectionPair::intersecting`].
#[derive(Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Deserialize))]
pub struct NarrowPhase {
    pub(crate) contacts: PairStore<ContactPair>,
    pub(crate) intersections: PairStore<IntersectionPair>,
    #[cfg_attr(feature = "serde-serialize", serde(skip))]
    pub(crate) lanes: ContactLanes,
    pub(crate) stamp: WorldStamp,
}

impl Clone for NarrowPhase {
    fn clone(&self) -> Self {
        // Another thread may read for the first time meanwhile: after the write-back there are no writers.
        self.write_back_all_shared();
        Self {
            contacts: self.contacts.clone(),
            intersections: self.intersections.clone(),
            lanes: self.lanes.clone(),
            stamp: self.stamp,
        }
    }

    fn clone_from(&mut self, source: &Self) {
        source.write_back_all_shared();
        let Self { contacts, intersections, lanes, stamp } = source;
        self.contacts.clone_from(contacts);
        self.intersections.clone_from(intersections);
        self.lanes.clone_from(lanes);
        self.stamp = *stamp;
    }
}

impl core::fmt::Debug for NarrowPhase {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let contacts: Vec<_> = self.contact_pairs().map(|(.., pair)| pair).collect();
        let intersections: Vec<_> = self.intersections.iter().collect();
        f.debug_struct("NarrowPhase")
            .field("contacts", &contacts)
            .field("intersections", &intersections)
            .finish_non_exhaustive()
    }
}

/// Like a derived one, except that pending write-backs are done first.
#[cfg(feature = "serde-serialize")]
impl serde::Serialize for NarrowPhase {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(serde::Serialize)]
        #[serde(rename = "NarrowPhase")]
        struct Saved<'a> {
            contacts: &'a PairStore<ContactPair>,
            intersections: &'a PairStore<IntersectionPair>,
            stamp: WorldStamp,
        }
        self.write_back_all_shared();
        let Self { contacts, intersections, stamp, .. } = self;
        Saved { contacts, intersections, stamp: *stamp }.serialize(serializer)
    }
}

impl NarrowPhase {
    /// An empty narrow phase.
    pub fn new() -> Self {
        Self::default()
    }

    /// Resets the contact forces: reports of awake pairs are zero, and warm-start impulses are kept.
    pub(crate) fn clear_step_impulses(&mut self) {
        self.write_back_all(Tasks::SERIAL);
        self.contacts.for_each_awake_pair(Tasks::SERIAL, |_, pair| {
            let manifolds = pair.manifolds.iter_mut();
            for contact in manifolds.flat_map(|manifold| &mut manifold.data.points) {
                contact.impulse = 0.0;
            }
        });
    }

    /// A contact pair with the results of the last step.
    ///
    /// Every read of a pair behind a shared reference uses this function. Exceptions are the stages of a
    /// step, which have exclusive access.
    pub(crate) fn written_back(&self, id: PairId) -> &ContactPair {
        self.lanes.complete(id, || {
            // SAFETY: the lanes admit one writing thread at a time, and only if no thread has read the pair
            // since the lanes were stored.
            unsafe { self.contacts.write(id, |pair| self.lanes.write_back(id, pair)) }
        });
        &self.contacts[id]
    }

    /// Writes all pairs back.
    fn write_back_all_shared(&self) {
        self.contacts.ids().for_each(|id| {
            self.written_back(id);
        });
    }

    /// Writes the results of the last step back to a contact pair.
    pub(crate) fn complete(&mut self, id: PairId) {
        self.lanes.write_back(id, &mut self.contacts[id]);
    }

    /// See [`ContactLanes::has_results_of`], for all pairs.
    pub(crate) fn has_all_results(&self) -> bool {
        self.contacts.ids().all(|id| self.lanes.has_results_of(id, &self.contacts[id]))
    }

    /// See [`ContactLanes::are_indexed`].
    pub(crate) fn has_indexed_lanes(&self) -> bool {
        self.lanes.are_indexed(|at| self.contacts[at.pair].manifolds.get(at.manifold as usize))
    }

    /// Writes the results of the last step back to all contact pairs.
    pub(crate) fn write_back_all(&mut self, tasks: Tasks<'_>) {
        if self.lanes.has_pending_write_backs() {
            self.contacts.for_each_awake_pair(tasks, |id, pair| self.lanes.write_back(id, pair));
            self.lanes.mark_written_back();
        }
    }

    /// All contact pairs, as (first collider, second collider, pair), in an order that depends on the
    /// world's history alone.
    pub fn contact_pairs(
        &self,
    ) -> impl Iterator<Item = (ColliderHandle, ColliderHandle, &ContactPair)> {
        let pairs = self.contacts.ids().map(|id| self.written_back(id));
        pairs.map(|pair| (pair.collider1, pair.collider2, pair))
    }

    /// The contact pair of two colliders, given in either order. `None` if their boxes do not overlap, if one
    /// of them is a sensor, or if a filter excludes the pair.
    pub fn contact_pair(
        &self,
        collider1: ColliderHandle,
        collider2: ColliderHandle,
    ) -> Option<&ContactPair> {
        let colliders = [collider1, collider2];
        let pair = self.written_back(self.contacts.find(colliders)?);
        pair.is_of(colliders).then_some(pair)
    }

    /// All contact pairs of one collider. Empty for a stale handle.
    pub fn contact_pairs_with(
        &self,
        collider: ColliderHandle,
    ) -> impl Iterator<Item = &ContactPair> {
        let ids = self.contacts.ids_of(collider.into_raw_parts().0);
        ids.iter()
            .map(|&id| self.written_back(id))
            .filter(move |pair| pair.collider1 == collider || pair.collider2 == collider)
    }

    /// All pairs with a sensor, as (first collider, second collider, whether they intersect).
    pub fn intersection_pairs(
        &self,
    ) -> impl Iterator<Item = (ColliderHandle, ColliderHandle, bool)> {
        self.intersections.iter().map(|pair| (pair.collider1, pair.collider2, pair.intersecting))
    }

    /// Returns whether two colliders intersect, at least one of them a sensor. `None` if their boxes do not
    /// overlap, if neither is a sensor, or if a filter excludes the pair.
    pub fn intersection_pair(
        &self,
        collider1: ColliderHandle,
        collider2: ColliderHandle,
    ) -> Option<bool> {
        let colliders = [collider1, collider2];
        let pair = &self.intersections[self.intersections.find(colliders)?];
        pair.is_of(colliders).then_some(pair.intersecting)
    }

    /// All sensor pairs of one collider, as (first collider, second collider, whether they intersect).
    pub fn intersection_pairs_with(
        &self,
        collider: ColliderHandle,
    ) -> impl Iterator<Item = (ColliderHandle, ColliderHandle, bool)> {
        let ids = self.intersections.ids_of(collider.into_raw_parts().0);
        ids.iter()
            .map(|&id| &self.intersections[id])
            .filter(move |pair| pair.collider1 == collider || pair.collider2 == collider)
            .map(|pair| (pair.collider1, pair.collider2, pair.intersecting))
    }
}
