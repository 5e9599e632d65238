//! The set of multibodies, and the record of the user's changes for the next step.

mod step;

use super::{
    Multibody, MultibodyIndex, MultibodyJoint, MultibodyJointHandle, MultibodyLink, MultibodyLinkId,
};
use crate::base::arena::Arena;
use crate::base::in_place::clone_in_place;
use crate::dim::joint_axes::JointAxesMask;
use crate::model::body::RigidBodyHandle;
use crate::model::island::GroupMember;
use crate::model::joint::{GenericJoint, InvalidJoint};
use crate::model::stamp::WorldStamp;
use std::collections::BTreeMap;

/// Changes of multibodies since the last step. Each comes with whether it wakes.
#[derive(Debug, Default)]
pub(crate) struct MultibodyEdits {
    /// Bodies that lost a joint.
    pub cut: Vec<(RigidBodyHandle, bool)>,
    /// The bodies of each multibody that is new or was changed.
    pub groups: Vec<(Vec<GroupMember>, bool)>,
}

/// The multibody joints of a simulation, accessed by handle, and their [`Multibody`]s.
///
/// ```
/// # use rapier3d::prelude::*;
/// let mut world = PhysicsWorld::new();
/// let ceiling = world.insert_body(RigidBodyBuilder::fixed());
/// let bob = RigidBodyBuilder::dynamic().translation(vector![1.0, 0.0, 0.0]);
/// let (bob, _) = world.insert(bob, ColliderBuilder::ball(0.1));
/// let hinge = RevoluteJointBuilder::new(vector![0.0, 0.0, 1.0]).local_anchor2(vector![-1.0, 0.0, 0.0]);
/// let joint = world.multibody_joints.insert(ceiling, bob, hinge.build(), true).unwrap();
/// for _ in 0..60 {
///     world.step();
/// }
/// let (pendulum, link) = world.multibody_joints.get(joint).unwrap();
/// assert_eq!((pendulum.ndofs(), link), (1, 1));
/// assert!((world.bodies[bob].translation().length() - 1.0).abs() < 1.0e-4, "it swings, and stays on its rod");
/// ```
#[derive(Debug, Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde-serialize", serde(remote = "Self"))]
pub struct MultibodyJointSet {
    multibodies: Arena<Multibody>,
    joints: Arena<MultibodyLinkId>,
    /// By body: its link. It is a tree, because slots of forged handles are unbounded. The whole handle is
    /// the key, because a stale one may have the slot of another link.
    of_body: BTreeMap<u64, MultibodyLinkId>,
    /// By slot of a multibody: the number of its links in the lists.
    link_counts: Vec<usize>,
    /// Multibodies whose links changed since the last step, and whether they wake.
    modified: Vec<(MultibodyIndex, bool)>,
    /// Their states before the first change, for those that were borrowed since the last step and neither new
    /// nor extended. If they are as before, they do not wake. Loaded notes have none.
    #[cfg_attr(feature = "serde-serialize", serde(skip))]
    seen: BTreeMap<MultibodyIndex, Option<Multibody>>,
    /// Bodies that lost a joint since the last step, and whether they wake.
    cut: Vec<(RigidBodyHandle, bool)>,
    pub(crate) stamp: WorldStamp,
}

clone_in_place!(MultibodyJointSet { multibodies, joints, link_counts, modified, seen, cut, stamp } unless_equal { of_body });

impl MultibodyJointSet {
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
    pub fn contains(&self, handle: MultibodyJointHandle) -> bool {
        self.joints.contains(handle.0)
    }

    // ---- Inserting ----

    /// Makes `body2` a child of `body1`, and wakes both if `wake_up` is `true`. Their multibodies are merged.
    ///
    /// The next step reads the joint's coordinates from the poses of the bodies, and moves `body2` to the
    /// pose of the coordinates. Degrees of freedom of a root, masses and poses are unknown until then, or
    /// until [`Multibody::forward_kinematics`]. `PhysicsWorld::insert_multibody_joint` reads them at once.
    ///
    /// `None`, with a warning in the log, if `body2` already has a parent, or is `body1` or one of its
    /// ancestors. The same if a number of the joint is unusable. The next step removes joints with stale body
    /// handles.
    pub fn insert(
        &mut self,
        body1: RigidBodyHandle,
        body2: RigidBodyHandle,
        data: impl Into<GenericJoint>,
        wake_up: bool,
    ) -> Option<MultibodyJointHandle> {
        self.insert_or_warn([body1, body2], MultibodyJoint::new(data.into(), false), wake_up)
    }

    /// The same as [`Self::insert`], for a joint that moves at a velocity prescribed by the user
    /// ([`Multibody::generalized_velocity_mut`]), independent of forces.
    pub fn insert_kinematic(
        &mut self,
        body1: RigidBodyHandle,
        body2: RigidBodyHandle,
        data: impl Into<GenericJoint>,
        wake_up: bool,
    ) -> Option<MultibodyJointHandle> {
        self.insert_or_warn([body1, body2], MultibodyJoint::new(data.into(), true), wake_up)
    }

    /// The same as [`Self::insert`].
    ///
    /// # Errors
    /// If `body2` already has a parent, if it is `body1` or one of its ancestors, or if a number of the joint
    /// is unusable.
    pub fn try_insert(
        &mut self,
        body1: RigidBodyHandle,
        body2: RigidBodyHandle,
        data: impl Into<GenericJoint>,
        wake_up: bool,
    ) -> Result<MultibodyJointHandle, InvalidJoint> {
        self.insert_joint([body1, body2], MultibodyJoint::new(data.into(), false), wake_up)
    }

    fn insert_or_warn(
        &mut self,
        bodies: [RigidBodyHandle; 2],
        joint: MultibodyJoint,
        wake_up: bool,
    ) -> Option<MultibodyJointHandle> {
        let warn = |reason: &_| log::warn!("a multibody joint was not inserted: {reason}");
        self.insert_joint(bodies, joint, wake_up).inspect_err(warn).ok()
    }

    fn insert_joint(
        &mut self,
        bodies: [RigidBodyHandle; 2],
        joint: MultibodyJoint,
        wake_up: bool,
    ) -> Result<MultibodyJointHandle, InvalidJoint> {
        self.check(bodies, &joint.data)?;
        for body in bodies {
            self.drop_if_broken(body);
        }
        let [body1, body2] = bodies;
        let parent = self.rigid_body_link(body1).copied().unwrap_or_else(|| self.add_root(body1));
        let child = self.rigid_body_link(body2).copied();
        let other = child.and_then(|child| self.multibodies.remove(child.multibody.0));
        let multibody = self.multibodies.get_mut(parent.multibody.0);
        let multibody = multibody.ok_or(InvalidJoint::MissingBody { body: body1 })?;
        let id = multibody.num_links();
        match other {
            Some(other) => multibody.append(other, parent.id, joint),
            None => drop(multibody.push(MultibodyLink::new(body2, joint, Some(parent.id)))),
        }
        let link = MultibodyLinkId { multibody: parent.multibody, id };
        let handle = MultibodyJointHandle(self.joints.insert(link));
        multibody.links[id].handle = Some(handle);
        self.file(parent.multibody, id);
        self.modified.push((parent.multibody, wake_up));
        self.seen.insert(parent.multibody, None);
        Ok(handle)
    }

    /// Returns whether a joint may connect these bodies.
    fn check(
        &self,
        [body1, body2]: [RigidBodyHandle; 2],
        data: &GenericJoint,
    ) -> Result<(), InvalidJoint> {
        data.validate()?;
        if data.transmission.is_some() {
            return Err(InvalidJoint::TransmissionInMultibody);
        }
        let axes = data.coupled_axes & !data.locked_axes & JointAxesMask::LIN_AXES;
        if axes.intersects(data.limit_axes | data.motor_axes) {
            return Err(InvalidJoint::DistanceInMultibody { axes });
        }
        if body1 == body2 {
            return Err(InvalidJoint::SameBody { body: body1 });
        }
        for body in [body1, body2] {
            if body == RigidBodyHandle::invalid() {
                return Err(InvalidJoint::MissingBody { body });
            }
        }
        let [link1, link2] = [body1, body2].map(|body| self.rigid_body_link(body));
        match (link1, link2) {
            (_, Some(child)) if child.id != 0 => Err(InvalidJoint::SecondParent { body: body2 }),
            (Some(parent), Some(child)) if parent.multibody == child.multibody => {
                Err(InvalidJoint::Loop { parent: body1, child: body2 })
            }
            _ => Ok(()),
        }
    }

    fn add_root(&mut self, body: RigidBodyHandle) -> MultibodyLinkId {
        let multibody = MultibodyIndex(self.multibodies.insert(Multibody::with_root(body)));
        self.file(multibody, 0);
        MultibodyLinkId { multibody, id: 0 }
    }

    /// Maps bodies and handles to the links of a multibody, from the position `first` on.
    fn file(&mut self, index: MultibodyIndex, first: usize) {
        let Some(multibody) = self.multibodies.get(index.0) else { return };
        let slot = index.0.slot();
        if slot >= self.link_counts.len() {
            self.link_counts.resize(slot + 1, 0);
        }
        self.link_counts[slot] = multibody.num_links();
        for link in multibody.links.iter().skip(first) {
            let place = MultibodyLinkId { multibody: index, id: link.id };
            if let Some(joint) = link.handle.and_then(|handle| self.joints.get_mut(handle.0)) {
                *joint = place;
            }
            self.of_body.insert(key(link.body), place);
        }
    }

    // ---- Removing ----

    /// Removes a joint and returns it; `None` if the handle is stale. Its bodies wake if `wake_up` is `true`.
    ///
    /// The link becomes the root of its descendants. A body without descendants is no longer a link.
    pub fn remove(
        &mut self,
        handle: MultibodyJointHandle,
        wake_up: bool,
    ) -> Option<MultibodyJoint> {
        let place = *self.joints.get(handle.0)?;
        let joint = self.get_link(handle)?.joint.clone();
        self.take_apart(place.multibody, wake_up, |link| link.id == place.id);
        Some(joint)
    }

    /// Removes all joints of the multibody of a joint. Its bodies wake if `wake_up` is `true`. A stale handle
    /// has no effect.
    pub fn remove_multibody_articulations(&mut self, handle: MultibodyJointHandle, wake_up: bool) {
        if let Some(place) = self.joints.get(handle.0).copied() {
            self.take_apart(place.multibody, wake_up, |_| true);
        }
    }

    /// Removes all joints of a body, and wakes their bodies.
    ///
    /// The next step removes the joints of removed bodies without this call.
    pub fn remove_joints_attached_to_rigid_body(&mut self, body: RigidBodyHandle) {
        if let Some(place) = self.rigid_body_link(body).copied() {
            let is_cut =
                |link: &MultibodyLink| link.id == place.id || link.parent == Some(place.id);
            self.take_apart(place.multibody, true, is_cut);
        }
    }

    /// Cuts joints. Parts of a single body are no longer multibodies.
    fn take_apart(
        &mut self,
        index: MultibodyIndex,
        wake_up: bool,
        is_cut: impl Fn(&MultibodyLink) -> bool,
    ) {
        if self.is_broken(index) {
            return self.drop_broken(index);
        }
        let Some(whole) = self.multibodies.remove(index.0) else { return };
        for link in &whole.links {
            self.cut.push((link.body, wake_up));
            self.of_body.remove(&key(link.body));
            if let Some(handle) = link.handle.filter(|_| is_cut(link)) {
                self.joints.remove(handle.0);
            }
        }
        for part in whole.split(is_cut) {
            if part.num_links() > 1 {
                let part = MultibodyIndex(self.multibodies.insert(part));
                self.file(part, 0);
                self.modified.push((part, wake_up));
                self.seen.insert(part, None);
            }
        }
    }

    // ---- Multibodies and links that were put in the place of others ----

    /// Returns whether the multibody at an index, or its links, were replaced.
    fn is_broken(&self, index: MultibodyIndex) -> bool {
        let Some(multibody) = self.get_multibody(index) else { return false };
        let count = self.link_counts.get(index.0.slot()).copied();
        let is_filed = |link: &MultibodyLink| {
            let place = MultibodyLinkId { multibody: index, id: link.id };
            let joint = link.handle.map(|handle| self.joints.get(handle.0) == Some(&place));
            self.rigid_body_link(link.body) == Some(&place) && joint != Some(false)
        };
        count != Some(multibody.num_links())
            || !multibody.is_whole()
            || !multibody.links.iter().all(is_filed)
    }

    fn drop_if_broken(&mut self, body: RigidBodyHandle) {
        if let Some(index) = self.rigid_body_link(body).map(|place| place.multibody)
            && self.is_broken(index)
        {
            self.drop_broken(index);
        }
    }

    /// Removes a multibody, its joints and its entries in all lists.
    fn drop_broken(&mut self, index: MultibodyIndex) {
        log::warn!("{index:?} or its links were replaced by others: their joints are removed");
        self.multibodies.remove(index.0);
        let is_of_it = |place: &MultibodyLinkId| place.multibody == index;
        let filed = self.of_body.iter().filter(|(_, place)| is_of_it(place));
        for body in filed.map(|(&body, _)| body).collect::<Vec<_>>() {
            self.of_body.remove(&body);
            self.cut.push((body_of(body), true));
        }
        let joints = self.joints.iter().filter(|(_, place)| is_of_it(place));
        for joint in joints.map(|(joint, _)| joint).collect::<Vec<_>>() {
            self.joints.remove(joint);
        }
    }

    // ---- Finding ----

    /// The multibody of a joint, and the index of the joint's link in it; `None` if the handle is stale.
    pub fn get(&self, handle: MultibodyJointHandle) -> Option<(&Multibody, usize)> {
        let place = self.joints.get(handle.0)?;
        Some((self.multibodies.get(place.multibody.0)?, place.id))
    }

    /// Mutable access to the multibody of a joint, and the index of the joint's link in it; `None` if the
    /// handle is stale. Its bodies wake in the next step if anything changed.
    pub fn get_mut(&mut self, handle: MultibodyJointHandle) -> Option<(&mut Multibody, usize)> {
        let place = *self.joints.get(handle.0)?;
        Some((self.get_multibody_mut(place.multibody)?, place.id))
    }

    /// The link of a joint; `None` if the handle is stale.
    pub fn get_link(&self, handle: MultibodyJointHandle) -> Option<&MultibodyLink> {
        let (multibody, id) = self.get(handle)?;
        multibody.link(id)
    }

    /// The joint in a slot (the first number of a handle): its multibody, the index of its link, and its
    /// handle.
    pub fn get_unknown_gen(&self, slot: u32) -> Option<(&Multibody, usize, MultibodyJointHandle)> {
        let (index, place) = self.joints.at_slot(slot)?;
        Some((self.multibodies.get(place.multibody.0)?, place.id, MultibodyJointHandle(index)))
    }

    /// The link and the multibody of a body; `None` if the body is not a link.
    pub fn rigid_body_link(&self, body: RigidBodyHandle) -> Option<&MultibodyLinkId> {
        self.of_body.get(&key(body))
    }

    /// The multibody at an index.
    pub fn get_multibody(&self, index: MultibodyIndex) -> Option<&Multibody> {
        self.multibodies.get(index.0)
    }

    /// Mutable access to the multibody at an index; `None` if the index is stale. Its bodies wake in the next
    /// step if anything changed.
    pub fn get_multibody_mut(&mut self, index: MultibodyIndex) -> Option<&mut Multibody> {
        let multibody = self.multibodies.get_mut(index.0)?;
        self.seen.entry(index).or_insert_with(|| Some(multibody.clone()));
        if self.modified.last() != Some(&(index, true)) {
            self.modified.push((index, true));
        }
        Some(multibody)
    }

    /// Removes the values that a facade keeps with the multibodies.
    #[cfg(feature = "upstream-signatures")]
    pub fn remove_attachments(&mut self) {
        self.multibodies.iter_mut().for_each(|(_, multibody)| multibody.remove_attachment());
    }

    /// All multibodies, in the order of their slots.
    pub fn multibodies(&self) -> impl DoubleEndedIterator<Item = &Multibody> {
        self.multibodies.iter().map(|(_, multibody)| multibody)
    }

    /// All joints, in the order of their slots: handle, link, multibody.
    pub fn iter(
        &self,
    ) -> impl Iterator<Item = (MultibodyJointHandle, &MultibodyLinkId, &Multibody, &MultibodyLink)>
    {
        self.joints.iter().filter_map(|(index, place)| {
            let multibody = self.multibodies.get(place.multibody.0)?;
            Some((MultibodyJointHandle(index), place, multibody, multibody.link(place.id)?))
        })
    }

    /// The joints of a body, as (parent, child, handle): the one to its parent first.
    pub fn attached_joints(
        &self,
        body: RigidBodyHandle,
    ) -> impl Iterator<Item = (RigidBodyHandle, RigidBodyHandle, MultibodyJointHandle)> {
        let place = self.rigid_body_link(body).copied();
        let multibody = place.and_then(|place| self.get_multibody(place.multibody));
        let links = multibody.map_or(&[] as &[MultibodyLink], |multibody| &multibody.links);
        let own = place.map(|place| place.id);
        let attached = links.iter().filter(move |link| Some(link.id) == own || link.parent == own);
        attached.filter_map(|link| Some((links.get(link.parent?)?.body, link.body, link.handle?)))
    }

    /// The bodies that are connected to a body by joints.
    pub fn attached_bodies(&self, body: RigidBodyHandle) -> impl Iterator<Item = RigidBodyHandle> {
        let joints = self.attached_joints(body);
        joints.map(move |(parent, child, _)| if child == body { parent } else { child })
    }

    /// The subset of [`Self::attached_bodies`] with an enabled joint.
    pub fn bodies_attached_with_enabled_joint(
        &self,
        body: RigidBodyHandle,
    ) -> impl Iterator<Item = RigidBodyHandle> {
        self.attached_joints(body).filter_map(move |(parent, child, handle)| {
            let enabled = self.get_link(handle)?.joint.data.is_enabled();
            enabled.then_some(if child == body { parent } else { child })
        })
    }

    /// The joint between two bodies, given in either order, with its multibody and its link.
    pub fn joint_between(
        &self,
        body1: RigidBodyHandle,
        body2: RigidBodyHandle,
    ) -> Option<(MultibodyJointHandle, &Multibody, &MultibodyLink)> {
        let mut joints = self.attached_joints(body1);
        let (.., handle) = joints.find(|&(parent, child, _)| parent == body2 || child == body2)?;
        let (multibody, id) = self.get(handle)?;
        Some((handle, multibody, multibody.link(id)?))
    }
}

/// The body that is filed under a number.
fn body_of(key: u64) -> RigidBodyHandle {
    RigidBodyHandle::from_raw_parts((key >> 32) as u32, key as u32)
}

/// The number under which a body is filed.
fn key(body: RigidBodyHandle) -> u64 {
    let (slot, generation) = body.into_raw_parts();
    u64::from(slot) << 32 | u64::from(generation)
}
