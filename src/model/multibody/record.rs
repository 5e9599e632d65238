//! The record of one multibody: its links, and a number of each kind per degree of freedom.

use super::attachment::Attachment;
use super::{MultibodyDofCoupling, MultibodyJoint, MultibodyLink};
use crate::base::fault::{Fault, ensure};
use crate::base::in_place::clone_in_place;
use crate::base::loading::{Loaded, check_when_loaded};
use crate::dim::joint_axes::{JointAxesMask, JointAxis};
use crate::dim::math::Real;
use crate::dim::spatial::free_axes;
use crate::model::body::{RigidBody, RigidBodyHandle, RigidBodyVelocity};
use crate::model::island::{GroupExclusions, GroupMember, NONE};
use crate::model::joint::{GenericJoint, mask_of};
use core::ops::Range;

/// One degree of freedom: an axis of a link's joint.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Dof {
    pub link: usize,
    pub axis: JointAxis,
}

/// Data of a degree of freedom.
#[derive(Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct DofLists {
    pub velocities: Vec<Real>,
    /// The velocities that the bodies got in the last step. Others were set by the user since.
    pub body_velocities: Vec<Real>,
    pub accelerations: Vec<Real>,
    pub damping: Vec<Real>,
    pub armature: Vec<Real>,
    pub frictions: Vec<Real>,
    /// Impulses of the frictions in the last substep. The next step starts with these impulses.
    pub friction_impulses: Vec<Real>,
}

clone_in_place!(DofLists {
    velocities,
    body_velocities,
    accelerations,
    damping,
    armature,
    frictions,
    friction_impulses
});

/// A tree of bodies in reduced coordinates. [`MultibodyJointSet::insert`](super::MultibodyJointSet::insert)
/// creates and extends multibodies.
///
/// The state is one coordinate and one velocity per *degree of freedom*. They are numbered link by link,
/// parents first, and within a link in the order of [`JointAxis`]: translations, then rotations. A dynamic
/// root can move along and about all axes of the world, except those that [`RigidBody::locked_axes`] locks. A
/// fixed or kinematic root has no degree of freedom, and its motion moves the other links.
///
/// # Links and bodies
///
/// Each step moves the links and writes their poses and velocities to the bodies. Edits of the bodies between
/// steps are applied. A moved link gives its joint new coordinates, as far as its free axes allow. Impulses
/// and velocities of bodies act on the whole multibody. Forces, gravity scale and damping of the bodies act
/// on the links. Colliders collide as those of all bodies do; dominance groups apply.
///
/// A multibody acts while all its links except the root are dynamic and enabled bodies, and all its joints
/// are valid and enabled. Otherwise the bodies move as if they had no joints.
#[derive(Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde-serialize", serde(remote = "Self"))]
pub struct Multibody {
    pub(crate) links: Vec<MultibodyLink>,
    pub(crate) dofs: Vec<Dof>,
    pub(crate) lists: DofLists,
    pub(crate) couplings: Vec<MultibodyDofCoupling>,
    pub(super) self_contacts_enabled: bool,
    /// The balance of its energy (J): see `multibody/motion/ledger.rs`.
    pub(crate) energy_error: Real,
    #[cfg_attr(feature = "serde-serialize", serde(skip))]
    pub(super) attachment: Attachment,
}

clone_in_place!(Multibody {
    links,
    dofs,
    lists,
    couplings,
    self_contacts_enabled,
    energy_error,
    attachment
});

impl Default for Multibody {
    fn default() -> Self {
        Self::new()
    }
}

impl Multibody {
    /// A multibody without links. [`MultibodyJointSet`](super::MultibodyJointSet) owns those of a world.
    pub fn new() -> Self {
        Self {
            links: Vec::new(),
            dofs: Vec::new(),
            lists: DofLists::default(),
            couplings: Vec::new(),
            self_contacts_enabled: true,
            energy_error: 0.0,
            attachment: Default::default(),
        }
    }

    /// A multibody of one body alone.
    pub(super) fn with_root(body: RigidBodyHandle) -> Self {
        let joint = MultibodyJoint::new(GenericJoint::default(), false);
        let mut multibody = Self::new();
        multibody.push(MultibodyLink::new(body, joint, None));
        multibody
    }

    /// Adds a link behind all others and returns its position.
    pub(super) fn push(&mut self, link: MultibodyLink) -> usize {
        let id = self.links.len();
        self.links.push(MultibodyLink { id, ..link });
        self.renumber();
        id
    }

    /// Adds all links of another multibody. Its root becomes a child of `parent`, connected by `joint`.
    pub(super) fn append(&mut self, mut other: Self, parent: usize, joint: MultibodyJoint) {
        self.merge_self_contacts(&mut other);
        let offset = self.links.len();
        for (id, mut link) in (offset..).zip(other.links) {
            (link.id, link.parent) = match link.parent {
                Some(parent) => (id, Some(parent + offset)),
                None => {
                    link.free = joint.free_axes();
                    link.joint = joint.clone();
                    (link.seen_pose, link.seen_velocity) = (None, None);
                    link.is_preview = false;
                    (id, Some(parent))
                }
            };
            self.links.push(link);
        }
        // The root's own degrees of freedom are removed; the bodies' velocities contain their motion.
        let root_end = other.dofs.iter().take_while(|dof| dof.link == 0).count();
        let kept: Vec<_> = (root_end..other.dofs.len()).collect();
        let known = other.dofs[root_end..].iter();
        self.dofs.extend(known.map(|dof| Dof { link: dof.link + offset, ..*dof }));
        self.lists.extend(other.lists.select(&kept));
        self.couplings.extend(other.couplings.iter().map(|coupling| MultibodyDofCoupling {
            link1: coupling.link1 + offset,
            link2: coupling.link2 + offset,
            ..*coupling
        }));
        self.renumber();
    }

    /// Applies the self-contact settings of both multibodies to the whole, before the links of `other` are
    /// added.
    ///
    /// A single body has no setting, so the other one holds for all links. Otherwise the setting of `self`
    /// holds, and links of `other` that did not touch each other still do not: they become an exclusion
    /// group.
    fn merge_self_contacts(&mut self, other: &mut Self) {
        if self.links.len() == 1 {
            self.self_contacts_enabled = other.self_contacts_enabled;
            return;
        }
        let last = self.links.iter().map(|link| link.exclusion_group).max().unwrap_or(0);
        for link in &mut other.links {
            link.exclusion_group = match link.exclusion_group {
                _ if !other.self_contacts_enabled => last.saturating_add(1),
                0 => 0,
                group => group.saturating_add(last),
            };
        }
    }

    /// Disables self-contacts if all links are in one exclusion group.
    pub(super) fn simplify_exclusions(&mut self) {
        let group = self.links.first().map_or(0, |link| link.exclusion_group);
        if group != 0 && self.links.iter().all(|link| link.exclusion_group == group) {
            self.set_self_contacts_enabled(false);
        }
    }

    // ---- Links ----

    /// The root; `None` if there are no links.
    pub fn root(&self) -> Option<&MultibodyLink> {
        self.links.first()
    }

    /// Mutable access to the root.
    pub fn root_mut(&mut self) -> Option<&mut MultibodyLink> {
        self.links.first_mut()
    }

    /// The link at an index; `None` if there is no such link.
    pub fn link(&self, id: usize) -> Option<&MultibodyLink> {
        self.links.get(id)
    }

    /// Mutable access to the link at an index. If a link was replaced by another, the multibody is invalid:
    /// the next step removes its joints, with a warning.
    pub fn link_mut(&mut self, id: usize) -> Option<&mut MultibodyLink> {
        self.links.get_mut(id)
    }

    /// All links, parents before their children.
    pub fn links(&self) -> impl DoubleEndedIterator<Item = &MultibodyLink> + ExactSizeIterator {
        self.links.iter()
    }

    /// Mutable access to all links, parents before their children.
    pub fn links_mut(
        &mut self,
    ) -> impl DoubleEndedIterator<Item = &mut MultibodyLink> + ExactSizeIterator {
        self.links.iter_mut()
    }

    /// Number of links, including the root.
    pub fn num_links(&self) -> usize {
        self.links.len()
    }

    /// The indices of the links from the root to this one, both included; empty for a missing link.
    pub fn kinematic_branch(&self, link_id: usize) -> Vec<usize> {
        let start = (link_id < self.links.len() && self.is_whole()).then_some(link_id);
        let mut branch: Vec<_> =
            core::iter::successors(start, |&id| self.links[id].parent).collect();
        branch.reverse();
        branch
    }

    /// Returns whether the colliders of its links collide with each other. The links of a merged multibody
    /// without self-contacts never collide with each other.
    pub fn self_contacts_enabled(&self) -> bool {
        self.self_contacts_enabled
    }

    /// Sets whether the colliders of its links collide with each other (default: yes). Contacts of a link and
    /// its parent also need their joint's [`contacts_enabled`](GenericJoint::contacts_enabled). Both settings
    /// apply from the next step on, also while the multibody does not act. Sensors of links detect other
    /// links in any case.
    ///
    /// A joint that merges two multibodies keeps the parent's setting for the whole. If the child's setting
    /// is `false`, the child's links still do not collide with each other. A later call applies to all links.
    pub fn set_self_contacts_enabled(&mut self, enabled: bool) {
        self.self_contacts_enabled = enabled;
        self.links.iter_mut().for_each(|link| link.exclusion_group = 0);
    }

    /// Its bodies, each with those that do not collide with it.
    pub(crate) fn members(&self) -> Vec<GroupMember> {
        let member = |link: &MultibodyLink| {
            let joint = &link.joint.data;
            let is_parted = joint.is_enabled() && !joint.contacts_enabled;
            let parent = link.parent.filter(|_| is_parted).and_then(|id| self.links.get(id));
            let number = if self.self_contacts_enabled { link.exclusion_group } else { u32::MAX };
            let other = parent.map_or(NONE, |parent| parent.body.into_raw_parts().0);
            GroupMember { body: link.body, exclusions: GroupExclusions { number, other } }
        };
        self.links.iter().map(member).collect()
    }

    // ---- Degrees of freedom ----

    /// Number of degrees of freedom.
    ///
    /// Those of the root follow from its body. They are up to date after a step,
    /// [`forward_kinematics`](Self::forward_kinematics), and insertions and removals by `PhysicsWorld`.
    /// `MultibodyJointSet::insert` has no access to bodies, so a root has none until then.
    pub fn ndofs(&self) -> usize {
        self.dofs.len()
    }

    /// The velocity of each degree of freedom (length/s, rad/s), as of the last step. The next step adds
    /// velocities and impulses that the bodies got since.
    pub fn generalized_velocity(&self) -> &[Real] {
        &self.lists.velocities
    }

    /// Mutable access to the velocity of each degree of freedom (length/s, rad/s). Velocities and impulses
    /// that the bodies get before the next step are added.
    pub fn generalized_velocity_mut(&mut self) -> &mut [Real] {
        &mut self.lists.velocities
    }

    /// The acceleration of each degree of freedom (length/s², rad/s²) in the last substep, without contacts,
    /// limits and bounded motors.
    pub fn generalized_acceleration(&self) -> &[Real] {
        &self.lists.accelerations
    }

    /// The velocities of the degrees of freedom of a link (length/s, rad/s); empty for a missing link.
    pub fn joint_velocity(&self, link_id: usize) -> &[Real] {
        let own = self.link(link_id).and_then(|link| self.lists.velocities.get(link.dofs()));
        own.unwrap_or_default()
    }

    /// Damping of each degree of freedom (force per velocity, default 0). Negative and non-finite values
    /// count as 0.
    pub fn damping(&self) -> &[Real] {
        &self.lists.damping
    }

    /// Mutable access to the damping of each degree of freedom.
    pub fn damping_mut(&mut self) -> &mut [Real] {
        &mut self.lists.damping
    }

    /// Inertia of each degree of freedom in addition to that of the links (mass, or mass·length², default 0).
    /// For example, the inertia of a rotor behind a gear times the square of the gear ratio. Negative and
    /// non-finite values count as 0.
    pub fn armature(&self) -> &[Real] {
        &self.lists.armature
    }

    /// Mutable access to the additional inertia of each degree of freedom.
    pub fn armature_mut(&mut self) -> &mut [Real] {
        &mut self.lists.armature
    }

    /// Dry friction of each degree of freedom (force, or torque, default 0): the largest resistance to its
    /// motion. Negative and non-finite values count as 0.
    pub fn frictions(&self) -> &[Real] {
        &self.lists.frictions
    }

    /// Mutable access to the dry friction of each degree of freedom.
    pub fn frictions_mut(&mut self) -> &mut [Real] {
        &mut self.lists.frictions
    }

    // ---- Layout ----

    /// Returns whether each link is at its index, behind its parent, with its degrees of freedom. A `&mut` to
    /// links lets the user swap them. Such a multibody is invalid, and the next step removes it.
    pub(crate) fn is_whole(&self) -> bool {
        let mut first_dof = 0;
        let links = self.links.iter().enumerate().all(|(id, link)| {
            let numbered = link.id == id && link.first_dof == first_dof;
            first_dof += link.ndofs();
            numbered && link.parent.map_or(id == 0, |parent| parent < id)
        });
        links && first_dof == self.dofs.len()
    }

    /// Checks that the degrees of freedom are the free axes of the links, with one number of each kind.
    pub(crate) fn check_layout(&self) -> Result<(), Fault> {
        ensure!(self.is_whole(), "the links of a multibody are not in order");
        let free_axes = self.links.iter().flat_map(|link| {
            let axes = JointAxis::ALL.into_iter().filter(|axis| link.free.contains(mask_of(*axis)));
            axes.map(|axis| Dof { link: link.id, axis })
        });
        ensure!(free_axes.eq(self.dofs.iter().copied()), "{:?} are not the free axes", self.dofs);
        let lengths = self.lists.all().map(Vec::len);
        ensure!(lengths == [self.ndofs(); _], "{} degrees of freedom: {lengths:?}", self.ndofs());
        Ok(())
    }

    /// Returns whether the multibody acts with these bodies.
    pub(crate) fn acts(&self, body: impl Fn(RigidBodyHandle) -> Option<bool>) -> bool {
        self.links.iter().all(|link| {
            let is_root = link.parent.is_none();
            let joint_acts =
                is_root || (link.joint.data.is_enabled() && link.joint.data.validate().is_ok());
            joint_acts && body(link.body).is_some_and(|is_dynamic| is_dynamic || is_root)
        })
    }

    /// Makes the free axes of the joints, and of the root's body, the degrees of freedom. Numbers of those
    /// that stay are kept. If there are others, the next step derives all velocities from the bodies, so that
    /// their momentum is kept: a kinematic root that becomes dynamic moves on, and a joint that is locked in
    /// motion stops no free tree.
    pub(crate) fn follow_axes(&mut self, root: &RigidBody) {
        let mut changed = false;
        for link in &mut self.links {
            let free = match link.parent {
                Some(_) => link.joint.free_axes(),
                None if root.is_dynamic() => free_axes(root.locked_axes()),
                None => JointAxesMask::empty(),
            };
            changed |= free != link.free;
            link.free = free;
        }
        if changed {
            self.renumber();
            let known = self.links.iter_mut().filter_map(|link| link.seen_velocity.as_mut());
            known.for_each(|velocity| *velocity = RigidBodyVelocity::zero());
        }
    }

    /// Renumbers the degrees of freedom. The remaining degrees of freedom keep their data.
    pub(super) fn renumber(&mut self) {
        let old = core::mem::take(&mut self.dofs);
        for link in &mut self.links {
            link.first_dof = self.dofs.len();
            let free = JointAxis::ALL.into_iter().filter(|axis| link.free.contains(mask_of(*axis)));
            self.dofs.extend(free.map(|axis| Dof { link: link.id, axis }));
        }
        self.lists.rearrange(&old, &self.dofs);
    }
}

check_when_loaded!(Multibody);

/// Links and degrees of freedom are numbered, each degree of freedom has one number of each kind, and all
/// numbers are usable.
impl Loaded for Multibody {
    fn check_loaded(&self) -> Result<(), Fault> {
        self.check_layout()?;
        for link in &self.links {
            let unknown = link.free.bits() & !JointAxesMask::all().bits();
            ensure!(unknown == 0, "link {} is free along {:?}", link.id, link.free);
            ensure!(link.is_sound(), "link {} has invalid numbers: {link:?}", link.id);
        }
        let wrong = self.lists.all().into_iter().flatten().find(|number| !number.is_finite());
        ensure!(wrong.is_none(), "a number of a degree of freedom is {wrong:?}");
        let unsound = self.couplings.iter().find(|coupling| !coupling.is_sound(self.links.len()));
        ensure!(unsound.is_none(), "{unsound:?} of {} links", self.links.len());
        Ok(())
    }
}

impl MultibodyLink {
    /// Its degrees of freedom among the multibody's.
    pub(crate) fn dofs(&self) -> Range<usize> {
        self.first_dof..self.first_dof + self.ndofs()
    }
}

impl DofLists {
    fn all(&self) -> [&Vec<Real>; 7] {
        let Self { velocities, body_velocities, accelerations, damping, .. } = self;
        let Self { armature, frictions, friction_impulses, .. } = self;
        [
            velocities,
            body_velocities,
            accelerations,
            damping,
            armature,
            frictions,
            friction_impulses,
        ]
    }

    fn all_mut(&mut self) -> [&mut Vec<Real>; 7] {
        let Self { velocities, body_velocities, accelerations, damping, .. } = self;
        let Self { armature, frictions, friction_impulses, .. } = self;
        [
            velocities,
            body_velocities,
            accelerations,
            damping,
            armature,
            frictions,
            friction_impulses,
        ]
    }

    /// Stores the velocities that the bodies get.
    pub fn store_velocities(&mut self, rates: &[Real]) {
        for list in [&mut self.velocities, &mut self.body_velocities] {
            list.clear();
            list.extend_from_slice(rates);
        }
    }

    fn extend(&mut self, mut other: Self) {
        for (list, more) in self.all_mut().into_iter().zip(other.all_mut()) {
            list.append(more);
        }
    }

    fn rearrange(&mut self, old: &[Dof], new: &[Dof]) {
        let key = |dof: &Dof| (dof.link, dof.axis as u8);
        debug_assert!(old.is_sorted_by_key(key) && new.is_sorted_by_key(key));
        for list in self.all_mut() {
            let mut known = old.iter().zip(list.iter()).peekable();
            let moved = new.iter().map(|dof| {
                while known.next_if(|(other, _)| key(other) < key(dof)).is_some() {}
                known.next_if(|(other, _)| *other == dof).map_or(0.0, |(_, value)| *value)
            });
            *list = moved.collect();
        }
    }

    /// The numbers of some degrees of freedom.
    pub(super) fn select(&self, kept: &[usize]) -> Self {
        let mut selected = Self::default();
        for (list, target) in self.all().into_iter().zip(selected.all_mut()) {
            target.extend(kept.iter().map(|&at| list[at]));
        }
        selected
    }
}
