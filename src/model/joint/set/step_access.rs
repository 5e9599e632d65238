//! The step's access to the set: changes of the user, joints without notes, and checks of loaded sets.

use super::{Entry, ImpulseJointSet, Note, slots_of};
use crate::base::arena::SharedArena;
use crate::base::fault::{Fault, ensure};
use crate::base::loading::Loaded;
use crate::model::joint::{ImpulseJoint, ImpulseJointHandle, JointEnabled, JointLinks};
use std::collections::BTreeSet;

impl ImpulseJointSet {
    /// The joints that the user may have changed, in the order of the first change, and whether their
    /// bodies are to wake. A joint that is as before wakes none.
    pub(crate) fn modified(&self) -> impl Iterator<Item = (ImpulseJointHandle, bool)> {
        self.modified.iter().enumerate().filter_map(|(note, &handle)| {
            let entry = self.joints.get(handle.0)?;
            let seen = self.seen.get(note).and_then(Option::as_ref);
            Some((handle, entry.note.wakes && seen != Some(&entry.joint)))
        })
    }

    /// Returns whether the user may have changed a joint since the last step.
    pub(crate) fn is_noted(&self, handle: ImpulseJointHandle) -> bool {
        self.joints.get(handle.0).is_some_and(|entry| entry.note.listed)
    }

    /// Checks the change lists of a loaded set: the list contains each joint that is marked, and the set
    /// contains no removed joint.
    pub(crate) fn check_notes(&self) -> Result<(), Fault> {
        let mut listed = BTreeSet::new();
        for handle in self.modified.iter().filter(|handle| self.contains(**handle)) {
            ensure!(self.is_noted(*handle), "{handle:?} is listed as edited");
            listed.insert(*handle);
        }
        let noted = self.joints.iter().filter(|(_, entry)| entry.note.listed).count();
        ensure!(noted == listed.len(), "{} of {noted} edited joints are listed", listed.len());
        let there = self.removed.iter().find(|(handle, _)| self.contains(*handle));
        ensure!(there.is_none(), "{there:?} is removed, and there");
        Ok(())
    }

    /// Marks all joints as new to the next step.
    pub(crate) fn begin_anew(&mut self) {
        (self.modified, self.removed, self.seen) = (Vec::new(), Vec::new(), Vec::new());
        for (index, entry) in self.joints.iter_mut() {
            entry.note = Note { listed: true, wakes: true };
            self.modified.push(ImpulseJointHandle(index));
        }
    }

    /// The joints that were removed, in that order, and whether their bodies are to wake.
    pub(crate) fn removed(&self) -> impl Iterator<Item = (ImpulseJointHandle, bool)> {
        self.removed.iter().copied()
    }

    /// Ends the step's update: removes joints without a body, and marks joints with a body that takes no part
    /// and joints whose anchors a program may have separated.
    pub(crate) fn apply_changes(&mut self, links: &mut JointLinks) {
        for handle in core::mem::take(&mut links.orphans) {
            // A joint that replaced another may have other bodies, and was applied again.
            let known = links.get(handle.into_raw_parts().0);
            if known.is_none_or(|link| link.handle != handle) {
                self.remove(handle, false);
            }
        }
        for (handle, blocked) in links.blocked.drain(..) {
            if let Some(joint) = self.get_unnoted_mut(handle) {
                joint.forget_frames();
                joint.data.enabled = match (joint.data.enabled, blocked) {
                    (JointEnabled::Enabled, true) => JointEnabled::DisabledByAttachedBody,
                    (JointEnabled::DisabledByAttachedBody, false) => JointEnabled::Enabled,
                    (unchanged, _) => unchanged,
                };
            }
        }
        for handle in links.displaced.drain(..) {
            if let Some(joint) = self.get_unnoted_mut(handle) {
                joint.is_displaced = true;
                joint.forget_frames();
            }
        }
        self.removed.clear();
        self.seen.clear();
        for handle in core::mem::take(&mut self.modified) {
            self.refile(handle);
            if let Some(entry) = self.joints.get_mut(handle.0) {
                entry.note = Note::default();
                if !entry.joint.data.is_enabled() {
                    entry.joint.forget_frames();
                }
            }
        }
    }

    /// Records a broken joint for the next step.
    pub(crate) fn note_broken(&mut self, handle: ImpulseJointHandle) {
        if self.get_mut(handle).is_some() && self.modified.last() == Some(&handle) {
            // It is disabled already.
            self.seen.pop();
        }
    }

    /// Prefetches the front of the joint in a slot.
    #[inline(always)]
    pub(crate) fn prefetch(&self, slot: u32) {
        self.joints.prefetch_front(slot, ImpulseJoint::FRONT);
    }

    /// A joint for the step's own use: leaves no note.
    pub(crate) fn get_unnoted_mut(
        &mut self,
        handle: ImpulseJointHandle,
    ) -> Option<&mut ImpulseJoint> {
        self.joints.get_mut(handle.0).map(|entry| &mut entry.joint)
    }

    /// Joints for the step's own use, to be written by several threads: leaves no notes. They are read by the
    /// indices in their handles.
    pub(crate) fn share(&mut self) -> SharedArena<'_, Entry> {
        self.joints.share()
    }
}

/// Each joint is filed under its bodies, and nothing else is.
impl Loaded for ImpulseJointSet {
    fn check_loaded(&self) -> Result<(), Fault> {
        // By joint slot: a bit for each of its bodies under which the joint was found.
        let mut found = vec![0_u8; self.joints.slot_count()];
        for (&slot, handles) in &self.of_body {
            for handle in handles {
                let entry = self.joints.get(handle.0);
                let side = entry.and_then(|it| slots_of(it.filed).position(|filed| filed == slot));
                let Some(side) = side else {
                    return Err(Fault::new(format_args!("{handle:?} is filed under body {slot}")));
                };
                let found = &mut found[handle.into_raw_parts().0 as usize];
                ensure!(*found >> side & 1 == 0, "{handle:?} is filed twice under body {slot}");
                *found |= 1 << side;
            }
        }
        for (index, entry) in self.joints.iter() {
            let bodies = slots_of(entry.filed).count() as u32;
            let found = found[index.into_raw_parts().0 as usize].count_ones();
            ensure!(found == bodies, "joint {index:?} is filed under {found} of {bodies} bodies");
        }
        Ok(())
    }
}
