//! The set of impulse joints, and the record of the user's changes for the next step.

mod step_access;

use super::{BodyPair, GenericJoint, ImpulseJoint, ImpulseJointHandle, InvalidJoint};
use crate::base::arena::Arena;
use crate::base::in_place::clone_in_place;
use crate::base::loading::check_when_loaded;
use crate::model::body::RigidBodyHandle;
use crate::model::stamp::WorldStamp;
use std::collections::BTreeMap;

/// A joint in its slot. The order of the fields is fixed (`repr(C)`): see [`ImpulseJoint::FRONT`].
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
#[repr(C)]
pub(crate) struct Entry {
    pub joint: ImpulseJoint,
    note: Note,
    /// The bodies under which the joint is filed.
    filed: [RigidBodyHandle; 2],
}

/// Record of a joint's changes. It belongs to the handle, also if the user replaces the joint.
#[derive(Copy, Clone, Debug, Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
struct Note {
    /// Whether the list of modified joints contains the handle.
    listed: bool,
    /// Whether the bodies wake when the step applies the change.
    wakes: bool,
}

/// The impulse joints of a simulation, accessed by handle.
///
/// Iteration is in the order of the slots: the same insertions and removals give the same order.
///
/// If one of its bodies is removed, a joint is removed at the latest in the next step or update.
#[derive(Debug, Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde-serialize", serde(remote = "Self"))]
pub struct ImpulseJointSet {
    joints: Arena<Entry>,
    /// By body slot: the joints that are filed there, in the order of insertion. A tree, because nothing
    /// bounds the slots of handles that a user made up.
    of_body: BTreeMap<u32, Vec<ImpulseJointHandle>>,
    /// Joints that the user may have changed since the last step, each once.
    modified: Vec<ImpulseJointHandle>,
    /// Their states before the first change, in the same order; `None` for new joints. Loaded notes have
    /// none: these joints count as changed.
    #[cfg_attr(feature = "serde-serialize", serde(skip))]
    seen: Vec<Option<ImpulseJoint>>,
    /// Joints that were removed since the last step, and whether their bodies wake.
    removed: Vec<(ImpulseJointHandle, bool)>,
    pub(crate) stamp: WorldStamp,
}

clone_in_place!(ImpulseJointSet { joints, modified, seen, removed, stamp } unless_equal { of_body });

impl ImpulseJointSet {
    /// An empty set.
    pub fn new() -> Self {
        Self::default()
    }

    /// Number of joints.
    pub fn len(&self) -> usize {
        self.joints.len()
    }

    /// Returns whether the set is empty.
    pub fn is_empty(&self) -> bool {
        self.joints.is_empty()
    }

    /// Returns whether the handle refers to a joint.
    pub fn contains(&self, handle: ImpulseJointHandle) -> bool {
        self.joints.contains(handle.0)
    }

    /// Inserts a joint between two bodies, and wakes them if `wake_up` is `true`.
    ///
    /// A joint between a body and itself, or with an unusable number, is logged and inserted disabled.
    /// [`Self::try_insert`] returns the error instead. The next step removes a joint whose body handles are
    /// stale.
    pub fn insert(
        &mut self,
        body1: RigidBodyHandle,
        body2: RigidBodyHandle,
        data: impl Into<GenericJoint>,
        wake_up: bool,
    ) -> ImpulseJointHandle {
        let mut data = data.into();
        if let Err(error) = check(body1, body2, &data) {
            log::warn!("a joint was inserted disabled: {error}");
            data.set_enabled(false);
        }
        self.insert_new(body1, body2, data, wake_up)
    }

    /// Inserts a joint between two bodies, and wakes them if `wake_up` is `true`.
    ///
    /// # Errors
    /// If the two bodies are the same, or a number of the joint is not usable.
    pub fn try_insert(
        &mut self,
        body1: RigidBodyHandle,
        body2: RigidBodyHandle,
        data: impl Into<GenericJoint>,
        wake_up: bool,
    ) -> Result<ImpulseJointHandle, InvalidJoint> {
        let data = data.into();
        check(body1, body2, &data)?;
        Ok(self.insert_new(body1, body2, data, wake_up))
    }

    fn insert_new(
        &mut self,
        body1: RigidBodyHandle,
        body2: RigidBodyHandle,
        data: GenericJoint,
        wake_up: bool,
    ) -> ImpulseJointHandle {
        let entry = Entry {
            joint: ImpulseJoint::new(body1, body2, data),
            note: Note { listed: true, wakes: wake_up },
            filed: [body1, body2],
        };
        let handle = ImpulseJointHandle(self.joints.insert(entry));
        self.file(handle, [body1, body2]);
        self.modified.push(handle);
        handle
    }

    /// Mutable access to a joint. Notes it as edited, and whether a change of it wakes its bodies.
    fn edit(&mut self, handle: ImpulseJointHandle, wakes: bool) -> Option<&mut ImpulseJoint> {
        let entry = self.joints.get_mut(handle.0)?;
        note(&mut self.modified, &mut self.seen, (handle, wakes), entry);
        Some(&mut entry.joint)
    }

    /// Removes a joint and returns it; `None` if the handle is stale. Its bodies wake if `wake_up` is `true`.
    pub fn remove(&mut self, handle: ImpulseJointHandle, wake_up: bool) -> Option<ImpulseJoint> {
        let Entry { joint, filed, .. } = self.joints.remove(handle.0)?;
        self.unfile(handle, filed);
        self.removed.push((handle, wake_up));
        Some(joint)
    }

    /// Removes all joints of a body, wakes their bodies, and returns their handles.
    ///
    /// The next step removes the joints of removed bodies without this call.
    pub fn remove_joints_attached_to_rigid_body(
        &mut self,
        body: RigidBodyHandle,
    ) -> Vec<ImpulseJointHandle> {
        let handles: Vec<_> = self.attached_joints(body).map(|(_, _, handle, _)| handle).collect();
        for &handle in &handles {
            self.remove(handle, true);
        }
        handles
    }

    /// The joint of a handle; `None` if the handle is stale.
    pub fn get(&self, handle: ImpulseJointHandle) -> Option<&ImpulseJoint> {
        self.joints.get(handle.0).map(|entry| &entry.joint)
    }

    /// Mutable access to the joint of a handle; `None` if the handle is stale. Its bodies wake in the next
    /// step if the joint changed.
    pub fn get_mut(&mut self, handle: ImpulseJointHandle) -> Option<&mut ImpulseJoint> {
        self.edit(handle, true)
    }

    /// [`Self::get_mut`], except that the bodies wake only if an earlier edit since the last step wakes them.
    pub fn get_mut_without_waking(
        &mut self,
        handle: ImpulseJointHandle,
    ) -> Option<&mut ImpulseJoint> {
        self.edit(handle, false)
    }

    /// The joint in a slot (the first number of a handle), with its handle.
    pub fn get_unknown_gen(&self, slot: u32) -> Option<(&ImpulseJoint, ImpulseJointHandle)> {
        let (index, entry) = self.joints.at_slot(slot)?;
        Some((&entry.joint, ImpulseJointHandle(index)))
    }

    /// Mutable access to the joint in a slot (the first number of a handle), with its handle. Its bodies wake
    /// in the next step if the joint changed.
    pub fn get_unknown_gen_mut(
        &mut self,
        slot: u32,
    ) -> Option<(&mut ImpulseJoint, ImpulseJointHandle)> {
        let (_, handle) = self.get_unknown_gen(slot)?;
        Some((self.edit(handle, true)?, handle))
    }

    /// Changes the bodies of a joint. The old bodies and the new ones wake. A stale handle, or two equal
    /// bodies, changes nothing.
    pub fn set_bodies(
        &mut self,
        handle: ImpulseJointHandle,
        body1: RigidBodyHandle,
        body2: RigidBodyHandle,
    ) {
        if body1 == body2 {
            return log::warn!("{}; the old bodies stay", InvalidJoint::SameBody { body: body1 });
        }
        if let Some(joint) = self.get_mut(handle) {
            joint.bodies = BodyPair { body1, body2 };
            joint.clear_history();
            self.refile(handle);
        }
    }

    /// All joints with their handles, in the order of their slots.
    pub fn iter(&self) -> impl DoubleEndedIterator<Item = (ImpulseJointHandle, &ImpulseJoint)> {
        self.joints.iter().map(|(index, entry)| (ImpulseJointHandle(index), &entry.joint))
    }

    /// Mutable access to all joints with their handles, in the order of their slots. The bodies of changed
    /// joints wake in the next step.
    pub fn iter_mut(
        &mut self,
    ) -> impl DoubleEndedIterator<Item = (ImpulseJointHandle, &mut ImpulseJoint)> {
        self.iter_noted_mut(true)
    }

    /// [`Self::iter_mut`], except that the bodies of a joint wake only if an earlier edit since the last step
    /// wakes them.
    pub fn iter_mut_without_waking(
        &mut self,
    ) -> impl DoubleEndedIterator<Item = (ImpulseJointHandle, &mut ImpulseJoint)> {
        self.iter_noted_mut(false)
    }

    /// Mutable access to all joints. Each visited joint is noted as edited.
    fn iter_noted_mut(
        &mut self,
        wakes: bool,
    ) -> impl DoubleEndedIterator<Item = (ImpulseJointHandle, &mut ImpulseJoint)> {
        let (modified, seen) = (&mut self.modified, &mut self.seen);
        self.joints.iter_mut().map(move |(index, entry)| {
            let handle = ImpulseJointHandle(index);
            note(modified, seen, (handle, wakes), entry);
            (handle, &mut entry.joint)
        })
    }

    /// The joints of a body, as (first body, second body, handle, joint), in the order of insertion.
    pub fn attached_joints(
        &self,
        body: RigidBodyHandle,
    ) -> impl Iterator<Item = (RigidBodyHandle, RigidBodyHandle, ImpulseJointHandle, &ImpulseJoint)>
    {
        self.handles_of(body.into_raw_parts().0).iter().filter_map(move |&handle| {
            let joint = self.get(handle)?;
            let is_own = joint.body1 == body || joint.body2 == body;
            is_own.then_some((joint.body1, joint.body2, handle, joint))
        })
    }

    /// The enabled ones of [`Self::attached_joints`].
    pub fn attached_enabled_joints(
        &self,
        body: RigidBodyHandle,
    ) -> impl Iterator<Item = (RigidBodyHandle, RigidBodyHandle, ImpulseJointHandle, &ImpulseJoint)>
    {
        self.attached_joints(body).filter(|(.., joint)| joint.data.is_enabled())
    }

    /// Calls a function with mutable access to each joint of a body, in the order of insertion. The bodies of
    /// changed joints wake in the next step.
    pub fn map_attached_joints_mut(
        &mut self,
        body: RigidBodyHandle,
        mut change: impl FnMut(RigidBodyHandle, RigidBodyHandle, ImpulseJointHandle, &mut ImpulseJoint),
    ) {
        let handles: Vec<_> = self.attached_joints(body).map(|(_, _, handle, _)| handle).collect();
        for handle in handles {
            if let Some(joint) = self.get_mut(handle) {
                change(joint.body1, joint.body2, handle, joint);
            }
        }
    }

    /// The joints between two bodies, given in either order.
    pub fn joints_between(
        &self,
        body1: RigidBodyHandle,
        body2: RigidBodyHandle,
    ) -> impl Iterator<Item = (ImpulseJointHandle, &ImpulseJoint)> {
        self.attached_joints(body1)
            .filter(move |&(first, second, ..)| first == body2 || second == body2)
            .map(|(_, _, handle, joint)| (handle, joint))
    }

    /// The joints that are filed under a body slot, in the order of insertion.
    fn handles_of(&self, body_slot: u32) -> &[ImpulseJointHandle] {
        self.of_body.get(&body_slot).map_or(&[], Vec::as_slice)
    }

    /// Files a joint under its bodies. Impulses and turns of other bodies are cleared.
    fn refile(&mut self, handle: ImpulseJointHandle) {
        let Some(entry) = self.joints.get_mut(handle.0) else { return };
        let (old, new) = (entry.filed, [entry.joint.body1, entry.joint.body2]);
        if old != new {
            entry.filed = new;
            entry.joint.clear_history();
            self.unfile(handle, old);
            self.file(handle, new);
        }
    }

    fn file(&mut self, handle: ImpulseJointHandle, bodies: [RigidBodyHandle; 2]) {
        for slot in slots_of(bodies) {
            self.of_body.entry(slot).or_default().push(handle);
        }
    }

    fn unfile(&mut self, handle: ImpulseJointHandle, bodies: [RigidBodyHandle; 2]) {
        for slot in slots_of(bodies) {
            let Some(filed) = self.of_body.get_mut(&slot) else { continue };
            filed.retain(|&other| other != handle);
            if filed.is_empty() {
                self.of_body.remove(&slot);
            }
        }
    }
}

check_when_loaded!(ImpulseJointSet);

/// The slots under which a joint of these bodies is filed.
fn slots_of(bodies: [RigidBodyHandle; 2]) -> impl Iterator<Item = u32> {
    let [slot1, slot2] = bodies.map(|body| body.into_raw_parts().0);
    core::iter::once(slot1).chain((slot1 != slot2).then_some(slot2))
}

fn check(
    body1: RigidBodyHandle,
    body2: RigidBodyHandle,
    data: &GenericJoint,
) -> Result<(), InvalidJoint> {
    if body1 == body2 {
        return Err(InvalidJoint::SameBody { body: body1 });
    }
    data.validate()
}

/// Notes a joint as edited, and whether a change of it wakes its bodies.
fn note(
    modified: &mut Vec<ImpulseJointHandle>,
    seen: &mut Vec<Option<ImpulseJoint>>,
    (handle, wakes): (ImpulseJointHandle, bool),
    entry: &mut Entry,
) {
    entry.note.wakes = wakes || entry.note.listed && entry.note.wakes;
    if !entry.note.listed {
        entry.note.listed = true;
        seen.resize(modified.len(), None);
        seen.push(Some(entry.joint.clone()));
        modified.push(handle);
    }
}

impl core::ops::Index<ImpulseJointHandle> for ImpulseJointSet {
    type Output = ImpulseJoint;

    /// # Panics
    /// If the handle is stale.
    #[expect(clippy::panic, reason = "`Index` cannot return an error")]
    fn index(&self, handle: ImpulseJointHandle) -> &ImpulseJoint {
        match self.get(handle) {
            Some(joint) => joint,
            None => panic!("{handle:?} finds no impulse joint in this set"),
        }
    }
}

impl core::ops::IndexMut<ImpulseJointHandle> for ImpulseJointSet {
    /// # Panics
    /// If the handle is stale.
    #[expect(clippy::panic, reason = "`Index` cannot return an error")]
    fn index_mut(&mut self, handle: ImpulseJointHandle) -> &mut ImpulseJoint {
        match self.get_mut(handle) {
            Some(joint) => joint,
            None => panic!("{handle:?} finds no impulse joint in this set"),
        }
    }
}
