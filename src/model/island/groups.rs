//! Bodies that move and sleep as one because they are links of one multibody, and the contacts between them
//! that the multibody disables.
//!
//! The user owns the set of multibodies; this table is the step's view of it.

use super::link::NONE;
use crate::base::fault::{Fault, ensure};
use crate::base::in_place::clone_in_place;
use crate::model::body::RigidBodyHandle;
use std::collections::BTreeSet;

/// A body of a group, and the bodies of the group whose colliders it does not collide with.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(crate) struct GroupMember {
    pub body: RigidBodyHandle,
    pub exclusions: GroupExclusions,
}

/// The bodies of a group that do not collide with one body of the group.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct GroupExclusions {
    /// Bodies with the same number do not collide with each other; 0: no number.
    pub number: u32,
    /// The slot of one other body; [`NONE`] for none.
    pub other: u32,
}

impl GroupExclusions {
    /// No exclusions.
    pub const NONE: Self = Self { number: 0, other: NONE };
}

/// The group of a body, and the bodies that it does not collide with.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Membership {
    group: u32,
    exclusions: GroupExclusions,
}

impl Membership {
    /// Of a body without a group.
    const NONE: Self = Self { group: NONE, exclusions: GroupExclusions::NONE };
}

/// Groups of bodies.
#[derive(Debug, Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct BodyGroups {
    /// All groups, with holes.
    groups: Vec<Vec<RigidBodyHandle>>,
    free: Vec<u32>,
    /// By body slot.
    of_body: Vec<Membership>,
}

clone_in_place!(BodyGroups { groups, free, of_body });

impl BodyGroups {
    /// The bodies of the group of the body in a slot; none if it has no group.
    pub fn of(&self, body_slot: u32) -> &[RigidBodyHandle] {
        match self.membership(body_slot) {
            Membership { group: NONE, .. } => &[],
            Membership { group, .. } => &self.groups[group as usize],
        }
    }

    /// The membership of the body in a slot.
    pub fn membership(&self, body_slot: u32) -> Membership {
        self.of_body.get(body_slot as usize).copied().unwrap_or(Membership::NONE)
    }

    /// Returns whether two bodies are in one group that disables contacts between their colliders.
    pub fn part(&self, body_slot1: u32, body_slot2: u32) -> bool {
        let [one, two] = [body_slot1, body_slot2].map(|slot| self.membership(slot));
        let Membership { group, exclusions: GroupExclusions { number, other } } = one;
        group != NONE
            && group == two.group
            && (number != 0 && number == two.exclusions.number
                || other == body_slot2
                || two.exclusions.other == body_slot1)
    }

    /// Returns whether the group of the first body has these members.
    pub fn has(&self, members: &[GroupMember]) -> bool {
        let Some(first) = members.first() else { return true };
        let bodies = self.of(first.body.into_raw_parts().0);
        bodies.iter().eq(members.iter().map(|member| &member.body))
            && members.iter().all(|GroupMember { body, exclusions }| {
                self.membership(body.into_raw_parts().0).exclusions == *exclusions
            })
    }

    /// All bodies that are in a group.
    pub fn bodies(&self) -> impl Iterator<Item = RigidBodyHandle> {
        self.groups.iter().flatten().copied()
    }

    /// All groups that have bodies.
    pub fn iter(&self) -> impl Iterator<Item = &[RigidBodyHandle]> {
        self.groups.iter().map(Vec::as_slice).filter(|group| !group.is_empty())
    }

    /// Checks that each body of a group is listed once and has that group. No other body may have one, and
    /// empty groups must be free.
    pub fn check(&self) -> Result<(), Fault> {
        let mut is_free = vec![false; self.groups.len()];
        for &id in &self.free {
            let free = is_free.get_mut(id as usize);
            let was_free = free.map(|free| core::mem::replace(free, true));
            ensure!(
                was_free == Some(false),
                "group {id} is in the free list twice, or does not exist"
            );
        }
        let mut listed = BTreeSet::new();
        for (id, group) in self.groups.iter().enumerate() {
            ensure!(group.is_empty() == is_free[id], "group {id} of {group:?} is free, or not");
            for body in group {
                let slot = body.into_raw_parts().0;
                let own = self.membership(slot).group;
                ensure!(own == id as u32, "{body:?} of group {id} has the group {own}");
                ensure!(listed.insert(slot), "{body:?} is listed twice in group {id}");
            }
        }
        let grouped = self.of_body.iter().filter(|&&one| one != Membership::NONE).count();
        let count = listed.len();
        ensure!(grouped == count, "{grouped} bodies have a group, and groups have {count}");
        Ok(())
    }

    /// Makes a group of bodies that have none.
    pub fn insert(&mut self, members: &[GroupMember]) {
        let group = self.free.pop().unwrap_or_else(|| {
            self.groups.push(Vec::new());
            self.groups.len() as u32 - 1
        });
        for &GroupMember { body, exclusions } in members {
            let slot = body.into_raw_parts().0 as usize;
            if slot >= self.of_body.len() {
                self.of_body.resize(slot + 1, Membership::NONE);
            }
            debug_assert_eq!(self.of_body[slot], Membership::NONE);
            self.of_body[slot] = Membership { group, exclusions };
        }
        self.groups[group as usize].extend(members.iter().map(|member| member.body));
    }

    /// Takes a body out of its group. Returns whether it was in one.
    pub fn leave(&mut self, body_slot: u32) -> bool {
        let Some(own) = self.of_body.get_mut(body_slot as usize) else { return false };
        let Membership { group, .. } = core::mem::replace(own, Membership::NONE);
        if group == NONE {
            return false;
        }
        let bodies = &mut self.groups[group as usize];
        bodies.retain(|body| body.into_raw_parts().0 != body_slot);
        if bodies.is_empty() {
            self.free.push(group);
        }
        true
    }
}
