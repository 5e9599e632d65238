//! Sets whose structure is frozen: a stage writes their elements, and can neither insert nor remove any.
//!
//! A stage that gets a `&mut` to a set could insert into the set, remove from it, or replace the set.
//! [`Frozen`] hides the reference: only this file can use it. Reads go through `Deref`, and the methods below
//! are all the writes that exist. They have the names and the effects of the methods of the sets.

use crate::base::arena::SharedArena;
use crate::base::disjoint::DisjointMut;
use crate::base::tasks::{Gather, Tasks};
use crate::model::body::{RigidBody, RigidBodyHandle, RigidBodySet};
use crate::model::collider::{Collider, ColliderHandle, ColliderSet};
use crate::model::contact::{ContactLanes, ContactPair, NarrowPhase, PairId, PairStore};
use crate::model::island::{BodyMotion, IslandManager};
use crate::model::joint::{ImpulseJoint, ImpulseJointHandle, ImpulseJointSet, JointEntry};
use crate::model::multibody::{Multibody, MultibodyIndex, MultibodyJointSet};
use core::ops::Deref;

/// A set whose elements are writable, and whose structure is not.
pub(crate) struct Frozen<'a, S>(&'a mut S);

impl<'a, S> Frozen<'a, S> {
    pub fn new(set: &'a mut S) -> Self {
        Self(set)
    }

    /// The same rights for a shorter time.
    pub fn reborrow(&mut self) -> Frozen<'_, S> {
        Frozen(self.0)
    }
}

impl<S> Deref for Frozen<'_, S> {
    type Target = S;

    #[inline(always)]
    fn deref(&self) -> &S {
        self.0
    }
}

impl Frozen<'_, RigidBodySet> {
    #[inline]
    pub fn get_unnoted_mut(&mut self, handle: RigidBodyHandle) -> Option<&mut RigidBody> {
        self.0.get_unnoted_mut(handle)
    }

    /// # Safety
    /// No handle may occur twice.
    pub unsafe fn visit(
        &mut self,
        handles: &[RigidBodyHandle],
        tasks: Tasks<'_>,
        visit: impl Fn(usize, Option<&mut RigidBody>) + Sync,
    ) {
        // SAFETY: the caller's promise.
        unsafe { self.0.visit(handles, tasks, visit) }
    }

    /// # Safety
    /// No handle may occur twice.
    pub unsafe fn visit_gathering<T: Send>(
        &mut self,
        handles: &[RigidBodyHandle],
        tasks: Tasks<'_>,
        gather: &mut Gather<T>,
        visit: impl Fn(usize, Option<&mut RigidBody>, &mut Vec<T>) + Sync,
        list: &mut Vec<T>,
    ) {
        // SAFETY: the caller's promise.
        unsafe { self.0.visit_gathering(handles, tasks, gather, visit, list) }
    }
}

impl Frozen<'_, ColliderSet> {
    pub fn get_unnoted_mut(&mut self, handle: ColliderHandle) -> Option<&mut Collider> {
        self.0.get_unnoted_mut(handle)
    }

    pub fn share(&mut self) -> SharedArena<'_, Collider> {
        self.0.share()
    }

    pub fn note_box(&mut self, handle: ColliderHandle) {
        self.0.note_box(handle);
    }
}

impl Frozen<'_, NarrowPhase> {
    pub fn pair_mut(&mut self, id: PairId) -> &mut ContactPair {
        &mut self.0.contacts[id]
    }

    /// The pairs by id, to be written by several threads.
    pub fn share_pairs(&mut self) -> DisjointMut<'_, Option<ContactPair>> {
        DisjointMut::new(self.0.contacts.split().pairs)
    }

    /// The lanes, and the pairs whose impulses they store.
    pub fn lanes_mut(&mut self) -> (&mut ContactLanes, &PairStore<ContactPair>) {
        (&mut self.0.lanes, &self.0.contacts)
    }

    pub fn write_back_all(&mut self, tasks: Tasks<'_>) {
        self.0.write_back_all(tasks);
    }

    pub fn clear_renewed(&mut self) {
        self.0.contacts.clear_renewed();
    }
}

impl Frozen<'_, ImpulseJointSet> {
    pub fn get_unnoted_mut(&mut self, handle: ImpulseJointHandle) -> Option<&mut ImpulseJoint> {
        self.0.get_unnoted_mut(handle)
    }

    pub fn share(&mut self) -> SharedArena<'_, JointEntry> {
        self.0.share()
    }

    pub fn note_broken(&mut self, handle: ImpulseJointHandle) {
        self.0.note_broken(handle);
    }
}

impl Frozen<'_, MultibodyJointSet> {
    pub fn get_unnoted_mut(&mut self, index: MultibodyIndex) -> Option<&mut Multibody> {
        self.0.get_unnoted_mut(index)
    }

    pub fn note(&mut self, index: MultibodyIndex) {
        self.0.note(index);
    }
}

impl Frozen<'_, IslandManager> {
    pub fn motions_mut(&mut self, slot_count: usize) -> &mut [BodyMotion] {
        self.0.motions_mut(slot_count)
    }

    pub fn set_motion(&mut self, body_slot: u32, motion: BodyMotion) {
        self.0.set_motion(body_slot, motion);
    }
}
