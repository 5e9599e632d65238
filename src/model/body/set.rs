//! The set of rigid bodies, and the record of the user's changes for the next step.

use super::{AttachedColliders, RigidBody, RigidBodyChanges, RigidBodyHandle};
use crate::base::arena::{Arena, SharedArena};
use crate::base::fault::{Fault, ensure};
use crate::base::in_place::clone_in_place;
use crate::base::tasks::{Gather, Tasks};
use crate::model::collider::{ColliderChanges, ColliderSet};
use crate::model::edit_mark::{EditMarks, first_notes};
use crate::model::island::BodyLink;
use crate::model::stamp::WorldStamp;
use core::ops::Range;
use std::collections::BTreeSet;

/// Smallest number of bodies that justifies a transfer to another thread.
pub(crate) const BODIES_PER_TASK: usize = 64;
/// Prefetch distance, in bodies: body records are spread over memory.
const BODY_PREFETCH_DISTANCE: usize = 3;

/// Data of a removed body for the step: its colliders, which are removed with it, and its place in the step's
/// lists. With `None`, the step finds the colliders by their parent.
pub(crate) type RemovedBody = (RigidBodyHandle, Option<AttachedColliders>, BodyLink);

/// The rigid bodies of a simulation, accessed by handle.
///
/// Indexing (`set[handle]`) panics if the handle is stale; [`Self::get`] returns `None` instead. Iteration is
/// in the order of the slots: the same insertions and removals give the same order.
#[derive(Debug, Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct RigidBodySet {
    bodies: Arena<RigidBody>,
    notes: Notes,
    pub(crate) stamp: WorldStamp,
}

clone_in_place!(RigidBodySet { bodies, notes, stamp });

/// Lists of changes.
#[derive(Debug, Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
struct Notes {
    /// Bodies that the user may have changed since the last step, each once.
    modified: Vec<RigidBodyHandle>,
    /// Their positions in the step's lists at the time of the change.
    places: Vec<BodyLink>,
    #[cfg_attr(feature = "serde-serialize", serde(skip))]
    marks: EditMarks,
    removed: Vec<RemovedBody>,
}

clone_in_place!(Notes { modified, places, marks, removed });

impl Notes {
    /// The user may be about to change a body.
    ///
    /// A `&mut` to a body lets the user replace it (assign a copy, swap two bodies), including its record of
    /// its *own* position. So the note stores the real position of the body.
    fn change(&mut self, handle: RigidBodyHandle, body: &mut RigidBody) {
        if !body.changes.contains(RigidBodyChanges::IN_MODIFIED_SET) {
            body.changes.insert(RigidBodyChanges::IN_MODIFIED_SET);
            body.edit = self.marks.mark(self.modified.len());
            self.modified.push(handle);
            self.places.push(body.link);
        }
    }
}

impl RigidBodySet {
    /// An empty set.
    pub fn new() -> Self {
        Self::default()
    }

    /// An empty set with the given `capacity`.
    pub fn with_capacity(capacity: usize) -> Self {
        Self { bodies: Arena::with_capacity(capacity), ..Self::default() }
    }

    /// Number of bodies.
    pub fn len(&self) -> usize {
        self.bodies.len()
    }

    /// Returns whether the set is empty.
    pub fn is_empty(&self) -> bool {
        self.bodies.is_empty()
    }

    /// Returns whether the handle refers to a body.
    pub fn contains(&self, handle: RigidBodyHandle) -> bool {
        self.bodies.contains(handle.0)
    }

    /// Inserts a body, or the body that a builder describes, and returns its handle.
    ///
    /// A copy of a body from a set is inserted without colliders: these stay attached to the original.
    pub fn insert(&mut self, body: impl Into<RigidBody>) -> RigidBodyHandle {
        let mut body = body.into();
        body.detach_from_set();
        body.changes.insert(RigidBodyChanges::IN_MODIFIED_SET);
        let handle = RigidBodyHandle(self.bodies.insert(body));
        let place = BodyLink::of_slot(handle.into_raw_parts().0);
        if let Some(body) = self.bodies.get_mut(handle.0) {
            body.link = place;
            body.edit = self.notes.marks.mark(self.notes.modified.len());
        }
        self.notes.modified.push(handle);
        self.notes.places.push(place);
        handle
    }

    /// Removes a body and returns it; `None` if the handle is stale.
    ///
    /// The next step or update removes its colliders and joints, and wakes the bodies that touched it. The
    /// returned body has no colliders, and can be inserted again.
    pub fn remove(&mut self, handle: RigidBodyHandle) -> Option<RigidBody> {
        let mut body = self.bodies.remove(handle.0)?;
        if body.changes.contains(RigidBodyChanges::IN_MODIFIED_SET) {
            self.notes.marks.retire(body.edit);
        }
        let (colliders, link) = body.detach_from_set();
        self.notes.removed.push((handle, Some(colliders), link));
        Some(body)
    }

    /// The body of a handle; `None` if the handle is stale.
    pub fn get(&self, handle: RigidBodyHandle) -> Option<&RigidBody> {
        self.bodies.get(handle.0)
    }

    /// Mutable access to the body of a handle; `None` if the handle is stale.
    pub fn get_mut(&mut self, handle: RigidBodyHandle) -> Option<&mut RigidBody> {
        let body = self.bodies.get_mut(handle.0)?;
        self.notes.change(handle, body);
        Some(body)
    }

    /// Mutable access to two bodies. `None` for each handle that refers to no body, and for the second one if
    /// both are equal.
    pub fn get_pair_mut(
        &mut self,
        handle1: RigidBodyHandle,
        handle2: RigidBodyHandle,
    ) -> (Option<&mut RigidBody>, Option<&mut RigidBody>) {
        let (mut body1, mut body2) = self.bodies.get2_mut(handle1.0, handle2.0);
        if let Some(body) = &mut body1 {
            self.notes.change(handle1, body);
        }
        if let Some(body) = &mut body2 {
            self.notes.change(handle2, body);
        }
        (body1, body2)
    }

    /// A body whose list of colliders is about to change. An older copy of it cannot take its place any more
    /// unnoticed.
    pub(crate) fn get_for_attachment(&mut self, handle: RigidBodyHandle) -> Option<&mut RigidBody> {
        let body = self.bodies.get_mut(handle.0)?;
        self.notes.change(handle, body);
        self.notes.marks.renew(&mut body.edit);
        Some(body)
    }

    /// Prefetches the front of the body in a slot for the step.
    #[inline(always)]
    pub(crate) fn prefetch(&self, slot: u32) {
        self.bodies.prefetch_front(slot, RigidBody::FRONT);
    }

    /// The body in a slot (the first number of a handle), with its handle.
    pub fn get_unknown_gen(&self, slot: u32) -> Option<(&RigidBody, RigidBodyHandle)> {
        self.at_slot(slot).map(|(handle, body)| (body, handle))
    }

    /// Mutable access to the body in a slot (the first number of a handle), with its handle.
    pub fn get_unknown_gen_mut(&mut self, slot: u32) -> Option<(&mut RigidBody, RigidBodyHandle)> {
        let (index, body) = self.bodies.at_slot_mut(slot)?;
        let handle = RigidBodyHandle(index);
        self.notes.change(handle, body);
        Some((body, handle))
    }

    /// All bodies with their handles, in the order of their slots.
    pub fn iter(&self) -> impl DoubleEndedIterator<Item = (RigidBodyHandle, &RigidBody)> {
        self.bodies.iter().map(|(index, body)| (RigidBodyHandle(index), body))
    }

    /// Mutable access to all bodies with their handles, in the order of their slots.
    ///
    /// The next step processes every visited body as changed.
    pub fn iter_mut(
        &mut self,
    ) -> impl DoubleEndedIterator<Item = (RigidBodyHandle, &mut RigidBody)> {
        let notes = &mut self.notes;
        self.bodies.iter_mut().map(move |(index, body)| {
            let handle = RigidBodyHandle(index);
            notes.change(handle, body);
            (handle, body)
        })
    }

    /// Moves the colliders of bodies whose pose changed since the last step, so that queries use the new
    /// poses. The next step does the same.
    pub fn propagate_modified_body_positions_to_colliders(&self, colliders: &mut ColliderSet) {
        let moved = self.notes.modified.iter().filter_map(|handle| self.get(*handle));
        for body in moved.filter(|body| body.changes.contains(RigidBodyChanges::POSITION)) {
            for &handle in &body.colliders {
                let Some(collider) = colliders.get(handle) else { continue };
                let Some(parent) = &collider.parent else { continue };
                let pose = body.pose * parent.pos_wrt_parent;
                // A write would be a change, which each query until the next step would process again.
                if collider.pose == pose {
                    continue;
                }
                let Some(collider) = colliders.get_mut(handle) else { continue };
                collider.pose = pose;
                collider.changes.insert(ColliderChanges::POSITION);
            }
        }
    }

    // ---- For the step ----

    /// The bodies that the user may have changed, in the order of the first change; some of them may have
    /// been removed. The caller must clear the `changes` of each.
    pub(crate) fn take_modified(&mut self) -> Vec<RigidBodyHandle> {
        self.notes.places.clear();
        self.notes.marks.clear();
        core::mem::take(&mut self.notes.modified)
    }

    /// The same list, which stays in place.
    pub(crate) fn modified(&self) -> &[RigidBodyHandle] {
        &self.notes.modified
    }

    /// Corrects the stored positions of bodies that replaced others, and returns their handles. The step must
    /// process them as new bodies.
    pub(crate) fn register_replaced(&mut self) -> Vec<RigidBodyHandle> {
        let mut replaced = Vec::new();
        // Backwards: a replaced body may have left a second note, and the first one is right.
        for note in (0..self.notes.modified.len()).rev() {
            let (handle, place) = (self.notes.modified[note], self.notes.places[note]);
            let Some(body) = self.bodies.get_mut(handle.0) else { continue };
            let is_noted = body.changes.contains(RigidBodyChanges::IN_MODIFIED_SET);
            // Without its note it is an older copy of itself.
            if body.link != place || !is_noted || !self.notes.marks.is_of(body.edit, note) {
                body.link = place;
                body.edit = self.notes.marks.mark(note);
                body.changes = RigidBodyChanges::everything() | RigidBodyChanges::IN_MODIFIED_SET;
                replaced.push(handle);
            }
        }
        replaced
    }

    /// Resets all references to other sets: for the next step all bodies are new, awake, and without
    /// colliders.
    pub(crate) fn begin_anew(&mut self) {
        self.notes = Notes::default();
        for (index, body) in self.bodies.iter_mut() {
            body.detach_from_set();
            body.link = BodyLink::of_slot(index.into_raw_parts().0);
            body.activation.wake_up(true);
            body.changes = RigidBodyChanges::everything() | RigidBodyChanges::IN_MODIFIED_SET;
            body.edit = self.notes.marks.mark(self.notes.modified.len());
            self.notes.modified.push(RigidBodyHandle(index));
            self.notes.places.push(body.link);
        }
    }

    /// Updates the positions in the notes, after the step's lists changed while notes were pending.
    pub(crate) fn renew_places(&mut self) {
        let Notes { modified, places, .. } = &mut self.notes;
        for (&handle, place) in modified.iter().zip(places) {
            if let Some(body) = self.bodies.get(handle.0) {
                *place = body.link;
            }
        }
    }

    /// The handles of the bodies that the user removed, in that order.
    pub(crate) fn removed(&self) -> impl Iterator<Item = RigidBodyHandle> {
        self.notes.removed.iter().map(|(handle, ..)| *handle)
    }

    /// The list that [`Self::take_removed`] will return.
    pub(crate) fn removed_notes(&self) -> Vec<RemovedBody> {
        let mut removed = self.notes.removed.clone();
        self.correct_places(&mut removed);
        removed
    }

    /// Checks the notes of a loaded set: the list names exactly the bodies with changes, and holds their
    /// places. The step takes the changes of all listed bodies. A change that no step takes would hide a
    /// wrong reference forever.
    pub(crate) fn check_notes(&self) -> Result<(), Fault> {
        let Notes { modified, places, .. } = &self.notes;
        ensure!(modified.len() == places.len(), "{} notes of bodies", places.len());
        let is_noted = |body: &RigidBody| body.changes.contains(RigidBodyChanges::IN_MODIFIED_SET);
        let mut listed = BTreeSet::new();
        for (handle, place) in modified.iter().zip(places) {
            let Some(body) = self.get(*handle) else { continue };
            ensure!(is_noted(body) && body.link == *place, "{handle:?} is noted at {place:?}");
            listed.insert(*handle);
        }
        let changed = self.iter().filter(|(_, body)| !body.changes.is_empty()).count();
        ensure!(changed == listed.len(), "{} of {changed} edited bodies are listed", listed.len());
        Ok(())
    }

    /// The bodies that the user removed, in that order.
    ///
    /// A body that replaced another one before it was removed gets the place of that body. Its own list of
    /// colliders is discarded: it may be older than the last attachment.
    pub(crate) fn take_removed(&mut self) -> Vec<RemovedBody> {
        let mut removed = core::mem::take(&mut self.notes.removed);
        self.correct_places(&mut removed);
        removed
    }

    fn correct_places(&self, removed: &mut [RemovedBody]) {
        if removed.is_empty() {
            return;
        }
        let notes = first_notes(self.notes.modified.iter().map(|handle| handle.into_raw_parts()));
        for (handle, colliders, link) in removed {
            let Some(&note) = notes.get(&handle.into_raw_parts()) else { continue };
            let place = self.notes.places[note];
            if place != *link || !self.notes.marks.was_of(note) {
                *link = place;
                *colliders = None;
            }
        }
    }

    /// A body for the step's own use: does not mark it as changed.
    #[inline]
    pub(crate) fn get_unnoted_mut(&mut self, handle: RigidBodyHandle) -> Option<&mut RigidBody> {
        self.bodies.get_mut(handle.0)
    }

    /// Visits bodies for the step's own use, on several threads, with their positions in the list: does not
    /// mark them as changed. `None` for a stale handle.
    ///
    /// # Safety
    /// No handle may occur twice.
    pub(crate) unsafe fn visit(
        &mut self,
        handles: &[RigidBodyHandle],
        tasks: Tasks<'_>,
        visit: impl Fn(usize, Option<&mut RigidBody>) + Sync,
    ) {
        let bodies = self.bodies.share();
        tasks.par_for(handles.len(), BODIES_PER_TASK, |range| {
            // SAFETY: the caller's promise; each position belongs to one task.
            unsafe { visit_range(&bodies, handles, range, &visit) };
        });
    }

    /// The same, with a list to which each visit may add. The additions are appended to `list` in the order
    /// of the bodies.
    ///
    /// # Safety
    /// No handle may occur twice.
    pub(crate) unsafe fn visit_gathering<T: Send>(
        &mut self,
        handles: &[RigidBodyHandle],
        tasks: Tasks<'_>,
        gather: &mut Gather<T>,
        visit: impl Fn(usize, Option<&mut RigidBody>, &mut Vec<T>) + Sync,
        list: &mut Vec<T>,
    ) {
        let bodies = self.bodies.share();
        let visit = |range: Range<usize>, found: &mut Vec<T>| {
            // SAFETY: the caller's promise; each position belongs to one task.
            unsafe { visit_range(&bodies, handles, range, |at, body| visit(at, body, found)) };
        };
        gather.run(tasks, (handles.len(), BODIES_PER_TASK), visit, list);
    }

    /// The body in a slot, with its handle.
    #[inline]
    pub(crate) fn at_slot(&self, slot: u32) -> Option<(RigidBodyHandle, &RigidBody)> {
        let (index, body) = self.bodies.at_slot(slot)?;
        Some((RigidBodyHandle(index), body))
    }

    /// Number of slots, and upper bound of slot numbers.
    pub(crate) fn slot_count(&self) -> usize {
        self.bodies.slot_count()
    }
}

/// Visits the bodies at some positions of a list.
///
/// # Safety
/// The caller has exclusive access to these bodies, and none occurs twice.
unsafe fn visit_range(
    bodies: &SharedArena<'_, RigidBody>,
    handles: &[RigidBodyHandle],
    range: Range<usize>,
    mut visit: impl FnMut(usize, Option<&mut RigidBody>),
) {
    for position in range {
        if let Some(later) = handles.get(position + BODY_PREFETCH_DISTANCE) {
            bodies.prefetch_front(later.into_raw_parts().0, RigidBody::FRONT);
        }
        // SAFETY: the caller's promise.
        visit(position, unsafe { bodies.get_mut(handles[position].0) });
    }
}

impl core::ops::Index<RigidBodyHandle> for RigidBodySet {
    type Output = RigidBody;

    /// # Panics
    /// If the handle is stale.
    #[expect(clippy::panic, reason = "`Index` cannot return an error")]
    fn index(&self, handle: RigidBodyHandle) -> &RigidBody {
        match self.get(handle) {
            Some(body) => body,
            None => panic!("{handle:?} finds no rigid body in this set"),
        }
    }
}

impl core::ops::IndexMut<RigidBodyHandle> for RigidBodySet {
    /// # Panics
    /// If the handle is stale.
    #[expect(clippy::panic, reason = "`Index` cannot return an error")]
    fn index_mut(&mut self, handle: RigidBodyHandle) -> &mut RigidBody {
        match self.get_mut(handle) {
            Some(body) => body,
            None => panic!("{handle:?} finds no rigid body in this set"),
        }
    }
}
