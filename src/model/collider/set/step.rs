//! The step's access to colliders, and its notes of edits.

use super::{ColliderSet, Notes, RemovedCollider};
use crate::base::arena::SharedArena;
use crate::base::fault::{Fault, ensure};
use crate::model::body::RigidBodySet;
use crate::model::collider::journal::Bookmark;
use crate::model::collider::{Collider, ColliderChanges, ColliderHandle};
use std::collections::BTreeSet;

impl ColliderSet {
    /// Resets all references to other sets: for the next step all colliders are new. They are attached to
    /// their parent bodies, whose lists must be empty. Colliders of removed bodies are removed, too.
    pub(crate) fn begin_anew(&mut self, bodies: &mut RigidBodySet) {
        self.notes = Notes::default();
        let handles: Vec<_> = self.iter().map(|(handle, _)| handle).collect();
        for handle in handles {
            let Some(collider) = self.colliders.get_mut(handle.0) else { continue };
            if let Some(parent) = collider.parent() {
                let Some(body) = bodies.get_unnoted_mut(parent) else {
                    self.colliders.remove(handle.0);
                    continue;
                };
                body.attach_collider(handle);
            }
            collider.be_new(handle);
            collider.edit = self.notes.marks.mark(self.notes.modified.len());
            self.notes.modified.push(handle);
        }
    }

    /// The colliders that the user may have changed, in the order of the first change; some of them may have
    /// been removed. The caller must clear the `changes` of each.
    pub(crate) fn take_modified(&mut self) -> Vec<ColliderHandle> {
        self.notes.marks.clear();
        core::mem::take(&mut self.notes.modified)
    }

    /// The same list, which stays in place.
    pub(crate) fn modified(&self) -> &[ColliderHandle] {
        &self.notes.modified
    }

    /// The handles of the colliders that were removed, in that order.
    pub(crate) fn removed(&self) -> impl Iterator<Item = ColliderHandle> {
        self.notes.removed.iter().map(|removed| removed.handle)
    }

    /// Checks the notes of a loaded set: the list names exactly the colliders with changes. The step takes
    /// the changes of all listed colliders. A change that no step takes would hide a wrong reference forever.
    pub(crate) fn check_notes(&self) -> Result<(), Fault> {
        let is_noted =
            |collider: &Collider| collider.changes.contains(ColliderChanges::IN_MODIFIED_SET);
        let mut listed = BTreeSet::new();
        for handle in &self.notes.modified {
            let Some(collider) = self.get(*handle) else { continue };
            ensure!(is_noted(collider), "{handle:?} is listed as edited");
            listed.insert(*handle);
        }
        let changed = self.iter().filter(|(_, collider)| !collider.changes.is_empty()).count();
        ensure!(
            changed == listed.len(),
            "{} of {changed} edited colliders are listed",
            listed.len()
        );
        Ok(())
    }

    /// The colliders that were removed, in that order.
    pub(crate) fn take_removed(&mut self) -> Vec<RemovedCollider> {
        core::mem::take(&mut self.notes.removed)
    }

    /// Records that a collider got another box in the trees, or was removed.
    pub(crate) fn note_box(&mut self, handle: ColliderHandle) {
        self.notes.journal.note(handle.into_raw_parts().0, self.colliders.len());
    }

    /// The slots of colliders that changed since a bookmark, possibly with duplicates, and the next bookmark;
    /// `None` if all may have changed.
    pub(crate) fn changed_since(&self, bookmark: Bookmark) -> (Option<&[u32]>, Bookmark) {
        (self.notes.journal.since(bookmark), self.notes.journal.end())
    }

    /// Takes a collider out of the set and leaves a note, without access to its body: for colliders whose
    /// body is gone.
    pub(crate) fn take(&mut self, handle: ColliderHandle, wake_up: bool) -> Option<Collider> {
        let collider = self.colliders.remove(handle.0)?;
        if collider.changes.contains(ColliderChanges::IN_MODIFIED_SET) {
            self.notes.marks.retire(collider.edit);
        }
        self.note_box(handle);
        self.notes.removed.push(RemovedCollider { handle, wake_up });
        Some(collider)
    }

    /// A collider for the step's own use: does not mark it as changed.
    #[inline]
    pub(crate) fn get_unnoted_mut(&mut self, handle: ColliderHandle) -> Option<&mut Collider> {
        self.colliders.get_mut(handle.0)
    }

    /// Colliders for the step's own use, to be written by several threads: does not mark them as changed.
    /// They are read by the indices in their handles.
    pub(crate) fn share(&mut self) -> SharedArena<'_, Collider> {
        self.colliders.share()
    }

    /// The collider in a slot.
    #[inline]
    pub(crate) fn at_slot(&self, slot: u32) -> Option<(ColliderHandle, &Collider)> {
        let (index, collider) = self.colliders.at_slot(slot)?;
        Some((ColliderHandle(index), collider))
    }

    /// Prefetches the collider at a slot.
    #[inline(always)]
    pub(crate) fn prefetch(&self, slot: u32) {
        self.colliders.prefetch_front(slot, Collider::FRONT);
    }
}
