//! The set of colliders, and the record of the user's changes for the next step.

mod step;

use super::journal::Journal;
use super::{Collider, ColliderChanges, ColliderEnabled, ColliderHandle, ColliderParent};
use crate::base::arena::Arena;
use crate::base::in_place::clone_in_place;
use crate::dim::math::Pose;
use crate::model::body::{RigidBody, RigidBodyHandle, RigidBodySet};
use crate::model::edit_mark::{EditMarks, first_notes};
use crate::model::island::IslandManager;
use crate::model::stamp::WorldStamp;
use crate::model::tree::ColliderProxy;

/// Data of a removed collider for the step.
#[derive(Copy, Clone, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct RemovedCollider {
    pub handle: ColliderHandle,
    /// Whether touching bodies wake.
    pub wake_up: bool,
}

/// The colliders of a simulation, accessed by handle.
///
/// Indexing (`set[handle]`) panics if the handle is stale; [`Self::get`] returns `None` instead. Iteration is
/// in the order of the slots: the same insertions and removals give the same order.
#[derive(Debug, Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde-serialize", serde(remote = "Self"))]
pub struct ColliderSet {
    colliders: Arena<Collider>,
    notes: Notes,
    pub(crate) stamp: WorldStamp,
}

clone_in_place!(ColliderSet { colliders, notes, stamp });

/// Lists of changes.
#[derive(Debug, Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
struct Notes {
    /// Colliders that the user may have changed since the last step, each once.
    modified: Vec<ColliderHandle>,
    #[cfg_attr(feature = "serde-serialize", serde(skip))]
    marks: EditMarks,
    removed: Vec<RemovedCollider>,
    #[cfg_attr(feature = "serde-serialize", serde(skip))]
    journal: Journal,
}

clone_in_place!(Notes { modified, marks, removed, journal });

impl Notes {
    /// The user may be about to change a collider. `count` is the number of colliders.
    fn change(&mut self, handle: ColliderHandle, collider: &mut Collider, count: usize) {
        self.journal.note(handle.into_raw_parts().0, count);
        if !collider.changes.contains(ColliderChanges::IN_MODIFIED_SET) {
            collider.changes.insert(ColliderChanges::IN_MODIFIED_SET);
            collider.edit = self.marks.mark(self.modified.len());
            self.modified.push(handle);
        }
    }
}

impl ColliderSet {
    /// An empty set.
    pub fn new() -> Self {
        Self::default()
    }

    /// An empty set with the given `capacity`.
    pub fn with_capacity(capacity: usize) -> Self {
        Self { colliders: Arena::with_capacity(capacity), ..Self::default() }
    }

    /// A handle that refers to no collider in any set.
    pub fn invalid_handle() -> ColliderHandle {
        ColliderHandle::invalid()
    }

    /// Number of colliders.
    pub fn len(&self) -> usize {
        self.colliders.len()
    }

    /// Returns whether the set is empty.
    pub fn is_empty(&self) -> bool {
        self.colliders.is_empty()
    }

    /// Returns whether the handle refers to a collider.
    pub fn contains(&self, handle: ColliderHandle) -> bool {
        self.colliders.contains(handle.0)
    }

    /// Inserts a collider, or the collider that a builder describes, without a body. It stays at its
    /// position, like a collider of a fixed body.
    pub fn insert(&mut self, collider: impl Into<Collider>) -> ColliderHandle {
        let mut collider = collider.into();
        collider.replace_broken_shape();
        collider.leave_body();
        self.insert_new(collider)
    }

    /// Inserts a collider, or the collider that a builder describes, attached to a body. Its position is
    /// relative to the body, and its mass is added to the body's.
    ///
    /// Before the first step with the body, its velocity becomes that of the new centre of mass. Later, every
    /// point of the body keeps its velocity, and the body wakes if its mass properties change.
    ///
    /// If the body's handle is stale, the log contains a warning, and the collider is inserted disabled and
    /// without a body. To repair it, call [`Self::set_parent`] and [`Collider::set_enabled`].
    pub fn insert_with_parent(
        &mut self,
        collider: impl Into<Collider>,
        parent_handle: RigidBodyHandle,
        bodies: &mut RigidBodySet,
    ) -> ColliderHandle {
        let mut collider = collider.into();
        collider.replace_broken_shape();
        let pos_wrt_parent = collider.parent.map_or(collider.pose, |old| old.pos_wrt_parent);
        collider.leave_body();
        let Some(body) = bodies.get_for_attachment(parent_handle) else {
            log::warn!(
                "{parent_handle:?} is not the handle of a body: the collider is inserted without a body and disabled"
            );
            collider.set_enabled(false);
            return self.insert_new(collider);
        };
        collider.join_body(parent_handle, pos_wrt_parent, body);
        body.add_collider_mass(&collider);
        let handle = self.insert_new(collider);
        body.attach_collider(handle);
        self.note_attachment(bodies);
        handle
    }

    /// Marks both sets: an attachment edits them together.
    fn note_attachment(&mut self, bodies: &mut RigidBodySet) {
        WorldStamp::note_attachment([&mut self.stamp, &mut bodies.stamp]);
    }

    /// Inserts a collider whose body, if it has one, already has its mass.
    fn insert_new(&mut self, mut collider: Collider) -> ColliderHandle {
        let new = ColliderChanges::everything() - ColliderChanges::LOCAL_MASS_PROPERTIES;
        collider.changes = new | ColliderChanges::IN_MODIFIED_SET;
        let handle = ColliderHandle(self.colliders.insert(collider));
        if let Some(collider) = self.colliders.get_mut(handle.0) {
            // It may be the copy of one that is in a set.
            collider.proxy = ColliderProxy::outside(handle.into_raw_parts().0);
            collider.edit = self.notes.marks.mark(self.notes.modified.len());
        }
        self.notes.journal.note(handle.into_raw_parts().0, self.colliders.len());
        self.notes.modified.push(handle);
        handle
    }

    /// Attaches a collider to another body, or to none.
    ///
    /// It keeps its position relative to the body, on the new body. A collider without a body is placed at
    /// the origin of the new body. A detached collider keeps its pose in the world. A stale handle of the
    /// collider or of the body changes nothing, and the log contains a warning.
    pub fn set_parent(
        &mut self,
        handle: ColliderHandle,
        new_parent_handle: Option<RigidBodyHandle>,
        bodies: &mut RigidBodySet,
    ) {
        let count = self.colliders.len();
        self.mend(handle, bodies);
        let Some(collider) = self.colliders.get_mut(handle.0) else {
            log::warn!(
                "ColliderSet::set_parent ignored: {handle:?} is not the handle of a collider"
            );
            return;
        };
        if let Some(stale) = new_parent_handle.filter(|parent| !bodies.contains(*parent)) {
            log::warn!("ColliderSet::set_parent ignored: {stale:?} is not the handle of a body");
            return;
        }
        if collider.parent() == new_parent_handle {
            return;
        }
        let old_parent = collider.parent;
        if let Some(old_body) = old_parent.and_then(|old| bodies.get_for_attachment(old.handle)) {
            old_body.detach_collider(handle);
            old_body.wake_up(true);
        }
        collider.leave_body();
        if let Some(parent_handle) = new_parent_handle {
            let place = old_parent.map_or(Pose::IDENTITY, |old| old.pos_wrt_parent);
            if let Some(body) = bodies.get_for_attachment(parent_handle) {
                collider.join_body(parent_handle, place, body);
                body.add_collider_mass(collider);
                body.attach_collider(handle);
                body.wake_up(true);
            }
        }
        self.notes.change(handle, collider, count);
        self.notes.marks.renew(&mut collider.edit);
        self.note_attachment(bodies);
    }

    /// Removes a collider from the set and from its body, and returns it; `None` if the handle is stale.
    ///
    /// `wake_up` selects whether its body, and the bodies that touched it, wake. Bodies that lost their
    /// support float until they wake.
    pub fn remove(
        &mut self,
        handle: ColliderHandle,
        islands: &mut IslandManager,
        bodies: &mut RigidBodySet,
        wake_up: bool,
    ) -> Option<Collider> {
        self.mend(handle, bodies);
        let collider = self.take(handle, wake_up)?;
        if let Some(parent) = collider.parent() {
            if let Some(body) = bodies.get_for_attachment(parent) {
                body.detach_collider(handle);
            }
            if wake_up {
                islands.wake_up(bodies, parent, true);
            }
            self.note_attachment(bodies);
        }
        Some(collider)
    }

    /// The collider of a handle; `None` if the handle is stale.
    #[inline]
    pub fn get(&self, handle: ColliderHandle) -> Option<&Collider> {
        self.colliders.get(handle.0)
    }

    /// Mutable access to the collider of a handle; `None` if the handle is stale.
    pub fn get_mut(&mut self, handle: ColliderHandle) -> Option<&mut Collider> {
        let count = self.colliders.len();
        let collider = self.colliders.get_mut(handle.0)?;
        self.notes.change(handle, collider, count);
        Some(collider)
    }

    /// Mutable access to two colliders. `None` for each handle that refers to no collider, and for the second
    /// one if both are equal.
    pub fn get_pair_mut(
        &mut self,
        handle1: ColliderHandle,
        handle2: ColliderHandle,
    ) -> (Option<&mut Collider>, Option<&mut Collider>) {
        let count = self.colliders.len();
        let (mut collider1, mut collider2) = self.colliders.get2_mut(handle1.0, handle2.0);
        if let Some(collider) = &mut collider1 {
            self.notes.change(handle1, collider, count);
        }
        if let Some(collider) = &mut collider2 {
            self.notes.change(handle2, collider, count);
        }
        (collider1, collider2)
    }

    /// The collider in a slot (the first number of a handle), with its handle.
    pub fn get_unknown_gen(&self, slot: u32) -> Option<(&Collider, ColliderHandle)> {
        let (index, collider) = self.colliders.at_slot(slot)?;
        Some((collider, ColliderHandle(index)))
    }

    /// Mutable access to the collider in a slot (the first number of a handle), with its handle.
    pub fn get_unknown_gen_mut(&mut self, slot: u32) -> Option<(&mut Collider, ColliderHandle)> {
        let count = self.colliders.len();
        let (index, collider) = self.colliders.at_slot_mut(slot)?;
        let handle = ColliderHandle(index);
        self.notes.change(handle, collider, count);
        Some((collider, handle))
    }

    /// All colliders with their handles, in the order of their slots.
    pub fn iter(&self) -> impl DoubleEndedIterator<Item = (ColliderHandle, &Collider)> {
        self.colliders.iter().map(|(index, collider)| (ColliderHandle(index), collider))
    }

    /// All enabled colliders with their handles, in the order of their slots.
    pub fn iter_enabled(&self) -> impl DoubleEndedIterator<Item = (ColliderHandle, &Collider)> {
        self.iter().filter(|(_, collider)| collider.is_enabled())
    }

    /// Mutable access to all colliders with their handles, in the order of their slots.
    ///
    /// The next step processes every visited collider as changed.
    pub fn iter_mut(&mut self) -> impl DoubleEndedIterator<Item = (ColliderHandle, &mut Collider)> {
        let (count, notes) = (self.colliders.len(), &mut self.notes);
        self.colliders.iter_mut().map(move |(index, collider)| {
            let handle = ColliderHandle(index);
            notes.change(handle, collider, count);
            (handle, collider)
        })
    }

    /// Mutable access to all enabled colliders with their handles, in the order of their slots.
    pub fn iter_enabled_mut(
        &mut self,
    ) -> impl DoubleEndedIterator<Item = (ColliderHandle, &mut Collider)> {
        let (count, notes) = (self.colliders.len(), &mut self.notes);
        self.colliders.iter_mut().filter(|(_, collider)| collider.is_enabled()).map(
            move |(index, collider)| {
                let handle = ColliderHandle(index);
                notes.change(handle, collider, count);
                (handle, collider)
            },
        )
    }
}

/// A `&mut` to a collider lets the user replace it (assign a copy, swap two colliders), including its record
/// of its *own* position.
impl ColliderSet {
    /// Returns whether the collider of a handle replaced another collider.
    fn is_replaced(&self, handle: ColliderHandle) -> bool {
        let slot = handle.into_raw_parts().0;
        self.get(handle).is_some_and(|collider| {
            let is_noted = collider.changes.contains(ColliderChanges::IN_MODIFIED_SET);
            collider.proxy.slot != slot || is_noted && !self.notes.marks.matches_note(collider.edit)
        })
    }

    /// Registers a replaced collider: as part of the body that it names, and as new to the step.
    fn mend(&mut self, handle: ColliderHandle, bodies: &mut RigidBodySet) {
        if self.is_replaced(handle) {
            self.register(handle, bodies);
        }
    }

    fn register(&mut self, handle: ColliderHandle, bodies: &mut RigidBodySet) {
        let Some(collider) = self.colliders.get_mut(handle.0) else { return };
        let parent = collider.parent().filter(|parent| bodies.contains(*parent));
        detach_from_others(handle, parent, bodies);
        let place = collider.parent.map_or(Pose::IDENTITY, |parent| parent.pos_wrt_parent);
        collider.leave_body();
        if let Some((parent, body)) =
            parent.and_then(|parent| Some((parent, bodies.get_for_attachment(parent)?)))
        {
            collider.join_body(parent, place, body);
            if !body.colliders().contains(&handle) {
                body.attach_collider(handle);
            }
            body.wake_up(true);
        }
        collider.be_new(handle);
        if let Some(note) = self.notes.modified.iter().position(|noted| *noted == handle) {
            collider.edit = self.notes.marks.mark(note);
        }
        self.note_attachment(bodies);
    }

    /// Registers the colliders that replaced others. One whose note is gone is an older copy of itself, and
    /// one with two notes was put in the place of another between them.
    pub(crate) fn register_replaced(&mut self, bodies: &mut RigidBodySet) {
        for note in 0..self.notes.modified.len() {
            let handle = self.notes.modified[note];
            let Some(collider) = self.get(handle) else { continue };
            let is_noted = collider.changes.contains(ColliderChanges::IN_MODIFIED_SET);
            let is_own = is_noted && self.notes.marks.is_of(collider.edit, note);
            if !is_own || self.is_replaced(handle) {
                self.register(handle, bodies);
            }
        }
        self.detach_removed(bodies);
    }

    /// Removes removed colliders from the lists of bodies. A collider is detached from the body that it names
    /// when it is removed, but one that replaced another may name another body.
    fn detach_removed(&mut self, bodies: &mut RigidBodySet) {
        if self.notes.removed.is_empty() {
            return;
        }
        let notes = first_notes(self.notes.modified.iter().map(|handle| handle.into_raw_parts()));
        for removed in &self.notes.removed {
            let note = notes.get(&removed.handle.into_raw_parts());
            if note.is_some_and(|&note| !self.notes.marks.was_of(note)) {
                detach_from_others(removed.handle, None, bodies);
            }
        }
    }
}

/// Detaches a collider from all bodies that list it, except its parent, and wakes them.
fn detach_from_others(
    handle: ColliderHandle,
    parent: Option<RigidBodyHandle>,
    bodies: &mut RigidBodySet,
) {
    let listed = bodies.iter().filter(|(_, body)| body.colliders().contains(&handle));
    let others = listed.map(|(body, _)| body).filter(|body| Some(*body) != parent);
    for body in others.collect::<Vec<_>>() {
        if let Some(body) = bodies.get_for_attachment(body) {
            body.detach_collider(handle);
            body.wake_up(true);
        }
    }
}

impl Collider {
    /// Marks the collider as new to the next step. The list of modified colliders must contain it.
    fn be_new(&mut self, handle: ColliderHandle) {
        self.proxy = ColliderProxy::outside(handle.into_raw_parts().0);
        let unchecked = self.changes & ColliderChanges::UNCHECKED_SHAPE;
        self.changes = ColliderChanges::everything() | ColliderChanges::IN_MODIFIED_SET | unchecked;
    }

    /// Detaches the collider from its body. Its pose in the world stays.
    fn leave_body(&mut self) {
        self.parent = None;
        self.parent_type = None;
        if self.flags.enabled == ColliderEnabled::DisabledByParent {
            self.flags.enabled = ColliderEnabled::Enabled;
            self.changes |= ColliderChanges::ENABLED_OR_DISABLED;
        }
        self.changes |= ColliderChanges::PARENT;
    }

    /// Attaches the collider to a body. It had none before.
    fn join_body(&mut self, handle: RigidBodyHandle, pos_wrt_parent: Pose, body: &RigidBody) {
        debug_assert!(self.parent.is_none());
        self.parent = Some(ColliderParent { handle, pos_wrt_parent });
        self.parent_type = Some(body.body_type());
        self.pose = body.pose * pos_wrt_parent;
        if !body.is_enabled() && self.flags.enabled == ColliderEnabled::Enabled {
            self.flags.enabled = ColliderEnabled::DisabledByParent;
            self.changes |= ColliderChanges::ENABLED_OR_DISABLED;
        }
        self.changes |= ColliderChanges::PARENT | ColliderChanges::POSITION;
    }
}

impl core::ops::Index<ColliderHandle> for ColliderSet {
    type Output = Collider;

    /// # Panics
    /// If the handle is stale.
    #[expect(clippy::panic, reason = "`Index` cannot return an error")]
    fn index(&self, handle: ColliderHandle) -> &Collider {
        match self.get(handle) {
            Some(collider) => collider,
            None => panic!("{handle:?} finds no collider in this set"),
        }
    }
}

impl core::ops::IndexMut<ColliderHandle> for ColliderSet {
    /// # Panics
    /// If the handle is stale.
    #[expect(clippy::panic, reason = "`Index` cannot return an error")]
    fn index_mut(&mut self, handle: ColliderHandle) -> &mut Collider {
        match self.get_mut(handle) {
            Some(collider) => collider,
            None => panic!("{handle:?} finds no collider in this set"),
        }
    }
}
