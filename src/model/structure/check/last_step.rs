//! Bodies and colliders as the lists of the structure refer to them.

use super::Structure;
use crate::base::fault::{Fault, ensure};
use crate::model::body::{AttachedColliders, RigidBodyHandle, RigidBodySet};
use crate::model::collider::{ColliderChanges, ColliderHandle};
use crate::model::island::{BodyLink, NONE};
use std::collections::{BTreeMap, BTreeSet};

/// The state after the last step, without the edits since then. Allocates no memory if there were none.
pub(super) struct LastStep<'a> {
    bodies: &'a RigidBodySet,
    /// By slot: a body that was removed since, and its place in the lists.
    removed_places: BTreeMap<u32, (RigidBodyHandle, BodyLink)>,
    /// Bodies that were removed since, and the colliders that go with them; `None` for all that name the
    /// body.
    removed_bodies: BTreeMap<RigidBodyHandle, Option<AttachedColliders>>,
    /// Colliders that were removed since.
    removed_colliders: BTreeSet<ColliderHandle>,
}

/// The body of a collider in the last step.
pub(super) enum Parent {
    /// In this slot; [`NONE`] for no body.
    Slot(u32),
    /// The collider was removed, or attached elsewhere since.
    Changed,
    /// There is no such collider.
    Missing,
}

impl<'a> LastStep<'a> {
    pub fn of(structure: &'a Structure<'_>) -> Result<Self, Fault> {
        let bodies = &*structure.bodies;
        let mut then = Self {
            bodies,
            removed_places: BTreeMap::new(),
            removed_bodies: BTreeMap::new(),
            removed_colliders: BTreeSet::new(),
        };
        for (handle, colliders, link) in bodies.removed_notes() {
            ensure!(!bodies.contains(handle), "{handle:?} is there and removed");
            let other = then.removed_bodies.insert(handle, colliders);
            ensure!(other.is_none(), "{handle:?} is removed twice");
            let slot = handle.into_raw_parts().0;
            ensure!((slot as usize) < bodies.slot_count(), "{handle:?} was in no slot");
            if is_listed(link) {
                let other = then.removed_places.insert(slot, (handle, link));
                ensure!(other.is_none(), "{other:?} and {handle:?} are listed");
            }
        }
        for (handle, body) in bodies.iter() {
            let slot = handle.into_raw_parts().0;
            ensure!(body.link.slot == slot, "{handle:?} stores slot {}", body.link.slot);
            let other = then.removed_places.get(&slot).filter(|_| is_listed(body.link));
            ensure!(other.is_none(), "{other:?} and {handle:?} are listed");
        }
        for handle in structure.colliders.removed() {
            ensure!(!structure.colliders.contains(handle), "{handle:?} is there and removed");
            ensure!(then.removed_colliders.insert(handle), "{handle:?} is removed twice");
        }
        Ok(then)
    }

    /// The bodies in lists, and their places.
    pub fn listed(&self) -> impl Iterator<Item = (RigidBodyHandle, BodyLink)> {
        let there = self.bodies.iter().map(|(handle, body)| (handle, body.link));
        there.filter(|(_, link)| is_listed(*link)).chain(self.removed_places.values().copied())
    }

    /// The place of the body in a slot.
    pub fn link(&self, slot: u32) -> BodyLink {
        let removed = self.removed_places.get(&slot).map(|(_, link)| *link);
        let there = || self.bodies.at_slot(slot).map(|(_, body)| body.link);
        removed.or_else(there).unwrap_or(BodyLink::of_slot(slot))
    }

    /// Returns whether a list may refer to a slot.
    pub fn has_slot(&self, slot: u32) -> bool {
        slot == NONE || (slot as usize) < self.bodies.slot_count()
    }

    /// Whether each body of a pair of slots belongs to an island.
    pub fn dynamic(&self, slots: [u32; 2]) -> [Option<u32>; 2] {
        slots.map(|slot| (self.link(slot).island != NONE).then_some(slot))
    }

    pub fn is_awake(&self, slot: u32) -> bool {
        self.link(slot).awake != NONE
    }

    /// Returns whether a collider will go with a body that was removed.
    pub fn goes_with(&self, body: RigidBodyHandle, collider: ColliderHandle) -> bool {
        let colliders = self.removed_bodies.get(&body).map(Option::as_ref);
        colliders.is_some_and(|list| list.is_none_or(|list| list.contains(&collider)))
    }

    pub fn parent(&self, structure: &Structure<'_>, handle: ColliderHandle) -> Parent {
        match structure.colliders.get(handle) {
            Some(collider) if collider.changes.contains(ColliderChanges::PARENT) => Parent::Changed,
            Some(collider) => {
                Parent::Slot(collider.parent().map_or(NONE, |body| body.into_raw_parts().0))
            }
            None if self.removed_colliders.contains(&handle) => Parent::Changed,
            None => Parent::Missing,
        }
    }
}

fn is_listed(link: BodyLink) -> bool {
    [link.awake, link.island] != [NONE; 2]
}
