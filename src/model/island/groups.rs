//! Bodies that move and sleep as one because they are links of one multibody.
//!
//! The user owns the set of multibodies; this table is the step's view of it.

use super::link::NONE;
use crate::base::fault::{Fault, ensure};
use crate::base::in_place::clone_in_place;
use crate::model::body::RigidBodyHandle;
use std::collections::BTreeSet;

/// Groups of bodies.
#[derive(Debug, Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct BodyGroups {
    /// All groups, with holes.
    groups: Vec<Vec<RigidBodyHandle>>,
    free: Vec<u32>,
    /// By body slot: its group.
    of_body: Vec<u32>,
}

clone_in_place!(BodyGroups { groups, free, of_body });

impl BodyGroups {
    /// The bodies of the group of the body in a slot; none if it has no group.
    pub fn of(&self, body_slot: u32) -> &[RigidBodyHandle] {
        let group = self.of_body.get(body_slot as usize).filter(|&&group| group != NONE);
        group.map_or(&[], |&group| &self.groups[group as usize])
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
                let own = self.of_body.get(slot as usize).copied();
                ensure!(own == Some(id as u32), "{body:?} of group {id} has the group {own:?}");
                ensure!(listed.insert(slot), "{body:?} is listed twice in group {id}");
            }
        }
        let grouped = self.of_body.iter().filter(|&&group| group != NONE).count();
        let count = listed.len();
        ensure!(grouped == count, "{grouped} bodies have a group, and groups have {count}");
        Ok(())
    }

    /// Makes a group of bodies that have none.
    pub fn insert(&mut self, bodies: Vec<RigidBodyHandle>) {
        let group = self.free.pop().unwrap_or_else(|| {
            self.groups.push(Vec::new());
            self.groups.len() as u32 - 1
        });
        for body in &bodies {
            let slot = body.into_raw_parts().0 as usize;
            if slot >= self.of_body.len() {
                self.of_body.resize(slot + 1, NONE);
            }
            debug_assert_eq!(self.of_body[slot], NONE);
            self.of_body[slot] = group;
        }
        self.groups[group as usize] = bodies;
    }

    /// Takes a body out of its group. Returns whether it was in one.
    pub fn leave(&mut self, body_slot: u32) -> bool {
        let Some(group) = self.of_body.get_mut(body_slot as usize) else { return false };
        let group = core::mem::replace(group, NONE);
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
