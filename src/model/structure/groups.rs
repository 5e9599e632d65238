//! Multibodies in the structure: all their bodies are in one island.

use super::Structure;
use crate::model::body::RigidBodyHandle;
use crate::model::island::GroupMember;

impl Structure<'_> {
    /// Makes bodies move and sleep as one from now on. Bodies leave other groups.
    pub fn group(&mut self, members: &[GroupMember]) {
        for member in members {
            self.ungroup(member.body);
        }
        self.islands.groups.insert(members);
        if let Some(first) = members.first() {
            self.link_group_of(first.body);
        }
    }

    /// Takes a body out of its group, if it has a group.
    pub fn ungroup(&mut self, body: RigidBodyHandle) {
        let slot = body.into_raw_parts().0;
        if !self.islands.groups.leave(slot) {
            return;
        }
        if let [Some(slot), _] = self.dynamic_slots([slot; 2])
            && let Some(island) = self.body(slot).map(|body| body.link.island)
        {
            self.islands.island_mut(island).is_cut = true;
        }
    }

    /// Merges the islands of all bodies of a body's group.
    pub fn link_group_of(&mut self, body: RigidBodyHandle) {
        let slot = body.into_raw_parts().0;
        let mut first = None;
        for i in 0..self.islands.groups.of(slot).len() {
            let other = self.islands.groups.of(slot)[i].into_raw_parts().0;
            let [Some(other), _] = self.dynamic_slots([other; 2]) else { continue };
            match first {
                None => first = Some(other),
                Some(first) => self.link(first, other),
            }
        }
    }

    /// Wakes all bodies of a body's group.
    pub(super) fn wake_group_of(&mut self, body: RigidBodyHandle) {
        let slot = body.into_raw_parts().0;
        for i in 0..self.islands.groups.of(slot).len() {
            let other = self.islands.groups.of(slot)[i];
            if other != body {
                self.wake_body(other);
            }
        }
    }
}
