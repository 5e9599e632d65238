//! The step's view of joints: their bodies and colours.
//!
//! The user owns the set of joints; this table is the step's view of it. It changes where islands change, and
//! only there.

use super::welds::WeldGroups;
use super::{
    GenericJoint, ImpulseJoint, ImpulseJointHandle, ImpulseJointSet, JointEnabled, JointMotor,
};
use crate::base::fault::{Fault, ensure};
use crate::base::in_place::clone_in_place;
use crate::dim::joint_axes::JointAxesMask;
use crate::model::body::{RigidBody, RigidBodyHandle, RigidBodySet};
use crate::model::constraint_graph::ColorSlot;
use crate::model::state_hash::hash_of_poses;
use core::mem;
use std::collections::BTreeSet;

/// The kind of a joint's constraint.
#[derive(Copy, Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct JointForm {
    /// The locked axes, one bit each.
    pub locked: u8,
    /// Number of its free axes with limits or motors.
    pub driven: u8,
    /// Whether it locks exactly the translations, without limits, motors and springs.
    pub is_point_to_point: bool,
    /// Whether it locks all axes, without springs.
    pub is_weld: bool,
    /// Whether it is a [`Transmission`](super::Transmission).
    pub is_transmission: bool,
    /// Whether its locked axes are springs.
    pub is_soft: bool,
    /// Whether springs or motors may do work on its bodies. Dampers that stop an axis do none.
    pub does_work: bool,
}

impl JointForm {
    /// The form of a joint.
    pub fn of(joint: &GenericJoint) -> Self {
        let drives = joint.limit_axes | joint.motor_axes;
        let is_soft = joint.spring().is_some();
        let mut motors = joint.driven_axes().filter_map(|axis| joint.motor(axis));
        Self {
            locked: joint.locked_axes.bits(),
            driven: if drives.is_empty() { 0 } else { joint.driven_axes().count() as u8 },
            is_point_to_point: joint.locked_axes == JointAxesMask::LIN_AXES
                && drives.is_empty()
                && !is_soft,
            is_weld: joint.locked_axes.is_all() && !is_soft,
            is_transmission: joint.transmission.is_some(),
            is_soft,
            does_work: is_soft || motors.any(JointMotor::does_work),
        }
    }

    /// Returns whether it locks a rotation.
    pub fn locks_rotations(self) -> bool {
        self.locked & JointAxesMask::ANG_AXES.bits() != 0
    }

    /// Number of rows of locked axes.
    pub fn row_count(self) -> usize {
        self.locked.count_ones() as usize
    }
}

/// The step's data of one joint.
#[derive(Copy, Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct JointLink {
    /// The joint.
    pub handle: ImpulseJointHandle,
    /// The two bodies.
    pub bodies: [RigidBodyHandle; 2],
    /// Kind of its constraint. It is stored here so that sorting constraints does not read the joints, which
    /// are large.
    pub form: JointForm,
    /// Hash of its frames: another one is an edit that can make an error.
    pub frames: u64,
    /// Whether the joint acts and can move one of the bodies.
    pub attached: bool,
    /// Position in the constraint graph.
    pub slot: Option<ColorSlot>,
    /// Whether it disables contacts between the colliders of its bodies.
    pub parts_bodies: bool,
}

impl JointLink {
    /// The link of a joint between the bodies of a set, not in the constraint graph.
    pub fn of(handle: ImpulseJointHandle, joint: &ImpulseJoint, bodies: &RigidBodySet) -> Self {
        let is_on = joint.data.enabled != JointEnabled::Disabled;
        Self {
            handle,
            bodies: [joint.body1, joint.body2],
            form: JointForm::of(&joint.data),
            frames: hash_of_poses(&[joint.data.local_frame1, joint.data.local_frame2]),
            attached: is_on && joint.data.validate().is_ok() && can_be_joined(joint, bodies),
            slot: None,
            parts_bodies: is_on && !joint.data.contacts_enabled,
        }
    }

    /// Returns whether the link is that of a joint which was not edited since. Whether it acts depends on its
    /// bodies, too: it is compared unless one of them was edited or removed.
    fn is_of(&self, joint: &ImpulseJoint, bodies: &RigidBodySet) -> bool {
        let is_unedited = |&body: &_| bodies.get(body).is_some_and(|body| body.changes.is_empty());
        let expected = Self::of(self.handle, joint, bodies);
        let attached = match self.bodies.iter().all(is_unedited) {
            true => expected.attached,
            false => self.attached,
        };
        *self == Self { slot: self.slot, attached, ..expected }
    }

    /// The slots of the two bodies.
    pub fn body_slots(&self) -> [u32; 2] {
        self.bodies.map(|body| body.into_raw_parts().0)
    }
}

/// Returns whether a joint could move one of its bodies.
fn can_be_joined(joint: &ImpulseJoint, bodies: &RigidBodySet) -> bool {
    let (first, second) = (bodies.get(joint.body1), bodies.get(joint.body2));
    let (Some(first), Some(second)) = (first, second) else { return false };
    joint.body1 != joint.body2
        && first.is_enabled()
        && second.is_enabled()
        && (first.is_dynamic() || second.is_dynamic())
}

/// All joints that the step has applied.
#[derive(Debug, Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct JointLinks {
    /// By joint slot.
    links: Vec<Option<JointLink>>,
    /// By body slot: the slots of its joints, in the order of insertion.
    of_body: Vec<Vec<u32>>,
    /// Joints without one of their bodies, to be removed from their set.
    pub orphans: Vec<ImpulseJointHandle>,
    /// Joints that were checked, and whether one of their bodies takes no part; to be written back.
    pub blocked: Vec<(ImpulseJointHandle, bool)>,
    /// Joints that a program made, moved an anchor of, or moved a body of; to be written back.
    pub displaced: Vec<ImpulseJointHandle>,
    weld_groups: WeldGroups,
    /// Whether welds began or ceased to act since their groups were found.
    pub welds_changed: bool,
}

clone_in_place!(JointLinks {
    links,
    of_body,
    orphans,
    blocked,
    displaced,
    weld_groups,
    welds_changed
});

impl JointLinks {
    /// The joint in a slot.
    pub fn get(&self, slot: u32) -> Option<&JointLink> {
        self.links.get(slot as usize)?.as_ref()
    }

    /// The joint in a slot.
    pub fn get_mut(&mut self, slot: u32) -> Option<&mut JointLink> {
        self.links.get_mut(slot as usize)?.as_mut()
    }

    /// The slots of the joints of a body.
    pub fn of_body(&self, body_slot: u32) -> &[u32] {
        self.of_body.get(body_slot as usize).map_or(&[], Vec::as_slice)
    }

    /// Notes that a program moved a body: its joints may have errors.
    pub fn note_moved(&mut self, body_slot: u32) {
        let slots = self.of_body.get(body_slot as usize).into_iter().flatten();
        let links = slots.filter_map(|&slot| self.links.get(slot as usize)?.as_ref());
        self.displaced.extend(links.map(|link| link.handle));
    }

    /// All joints in the order of their slots.
    pub fn iter(&self) -> impl Iterator<Item = (u32, &JointLink)> {
        let links = self.links.iter().enumerate();
        links.filter_map(|(slot, link)| Some((slot as u32, link.as_ref()?)))
    }

    /// Inserts a joint whose slot is empty.
    pub fn insert(&mut self, link: JointLink) {
        let slot = link.handle.into_raw_parts().0;
        if slot as usize >= self.links.len() {
            self.links.resize(slot as usize + 1, None);
        }
        debug_assert!(self.links[slot as usize].is_none());
        for body in link.body_slots() {
            if body as usize >= self.of_body.len() {
                self.of_body.resize(body as usize + 1, Vec::new());
            }
            self.of_body[body as usize].push(slot);
        }
        self.links[slot as usize] = Some(link);
    }

    /// Removes a joint, which must have no colour.
    pub fn remove(&mut self, slot: u32) {
        let Some(link) = self.links[slot as usize].take() else { return };
        debug_assert!(link.slot.is_none());
        for body in link.body_slots() {
            self.of_body[body as usize].retain(|&other| other != slot);
        }
    }

    /// Checks that each joint is in its slot and, once per end, in the lists of its bodies. Then the sum
    /// of the lengths proves that the lists hold nothing else.
    pub fn check(&self) -> Result<(), Fault> {
        let mut count = 0;
        for (slot, link) in self.iter() {
            let own = link.handle.into_raw_parts().0;
            ensure!(own == slot, "joint {own} stands in slot {slot}");
            for body in link.body_slots() {
                // A joint of a body with itself is listed twice.
                let ends = link.body_slots().iter().filter(|&&other| other == body).count();
                let listed = self.of_body(body).iter().filter(|&&other| other == slot).count();
                ensure!(listed == ends, "body {body} lists its joint {slot} {listed} times");
                count += 1;
            }
        }
        let listed: usize = self.of_body.iter().map(Vec::len).sum();
        ensure!(listed == count, "bodies list {listed} of {count} ends of joints");
        Ok(())
    }

    /// Returns whether the applied joints are those of a set, except joints that were edited or removed
    /// since. Their bodies may have been edited since, too.
    pub fn are_of(&self, joints: &ImpulseJointSet, bodies: &RigidBodySet) -> bool {
        let removed: BTreeSet<_> = joints.removed().map(|(handle, _)| handle).collect();
        let orphans: BTreeSet<_> = self.orphans.iter().copied().collect();
        let mut known = self.iter().map(|(_, link)| link);
        let are_there =
            known.all(|link| joints.contains(link.handle) || removed.contains(&link.handle));
        let mut unedited = joints.iter().filter(|(handle, _)| !joints.is_noted(*handle));
        are_there
            && unedited.all(|(handle, joint)| {
                let link = self.get(handle.into_raw_parts().0).filter(|it| it.handle == handle);
                match link {
                    Some(link) => link.is_of(joint, bodies),
                    None => orphans.contains(&handle),
                }
            })
    }

    /// Returns whether a joint disables contacts between the colliders of these two bodies.
    pub fn part(&self, body_slot1: u32, body_slot2: u32) -> bool {
        self.of_body(body_slot1).iter().any(|&slot| {
            self.get(slot)
                .is_some_and(|link| link.parts_bodies && link.body_slots().contains(&body_slot2))
        })
    }

    /// Returns whether welds hold the bodies in these slots rigidly at each other.
    pub fn weld(&self, body_slots: [u32; 2]) -> bool {
        self.weld_groups.hold(body_slots)
    }

    /// Finds the bodies that welds hold at each other. Returns the last groups if welds have changed.
    pub fn regroup_welded(&mut self, bodies: &RigidBodySet) -> Option<WeldGroups> {
        if !mem::take(&mut self.welds_changed) {
            return None;
        }
        let is_dynamic =
            |body: RigidBodyHandle| bodies.get(body).is_some_and(RigidBody::is_dynamic);
        let groups = self.groups_of_welds(|link| link.bodies.into_iter().all(is_dynamic));
        Some(mem::replace(&mut self.weld_groups, groups))
    }

    /// The groups of welds that act and of which both bodies are dynamic.
    pub fn groups_of_welds(&self, are_dynamic: impl Fn(&JointLink) -> bool) -> WeldGroups {
        let links = self.iter().map(|(_, link)| link);
        let welds = links.filter(|link| link.attached && link.form.is_weld && are_dynamic(link));
        WeldGroups::of(welds.map(JointLink::body_slots))
    }

    /// The bodies that welds hold at each other.
    pub fn weld_groups(&self) -> &WeldGroups {
        &self.weld_groups
    }
}
