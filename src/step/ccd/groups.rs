//! Fast bodies that joints hold together, and that stop together.
//!
//! If one limb stopped a metre before the rest of its body, the joint would be violated. It would pull the
//! limb through the wall in the next step. So all of them go back to where they were when the first was
//! stopped, and hold each other as they did then.
//!
//! Joined bodies that are not fast moved less than half their thickness. They keep their pose, and the joint
//! error is bounded by that distance.

use super::CcdContext;
use crate::dim::math::Real;

/// Sets of bodies that stop together.
#[derive(Default)]
pub(super) struct Groups {
    /// By fast body: another one of its group with a lower position, or itself. When the search is over, the
    /// first one of the group.
    firsts: Vec<u32>,
    /// Fast bodies by slot, with their positions in the list.
    by_slot: Vec<(u32, u32)>,
    /// The positions of all that stop with others, group by group.
    members: Vec<(u32, u32)>,
}

impl Groups {
    /// Finds the groups.
    pub fn find(&mut self, context: CcdContext<'_>) {
        let fast = (0..).zip(context.fast);
        self.by_slot.clear();
        self.by_slot.extend(fast.map(|(at, motion)| (motion.body.into_raw_parts().0, at)));
        self.by_slot.sort_unstable();
        self.firsts.clear();
        self.firsts.extend(0..context.fast.len() as u32);
        let mut last_link = None;
        for (position, motion) in (0..).zip(context.fast) {
            // Links of one multibody are adjacent.
            let tree = motion.link.map(|(tree, _)| tree);
            if tree.is_some() && tree == last_link {
                self.join(position, position - 1);
            }
            last_link = tree;
            let slot = motion.body.into_raw_parts().0;
            let joints = &context.islands.joints;
            for link in joints.of_body(slot).iter().filter_map(|&joint| joints.get(joint)) {
                let other = link.body_slots().into_iter().find(|&other| other != slot);
                if let Some(other) = other.filter(|_| link.attached).and_then(|s| self.position(s))
                {
                    self.join(position, other);
                }
            }
        }
        self.list_members();
    }

    /// The first one of the group of the fast body at a position.
    pub fn first(&self, position: usize) -> usize {
        self.firsts[position] as usize
    }

    /// Returns whether the group of the fast body at a position has no other member.
    pub fn is_alone(&self, position: usize) -> bool {
        self.members(self.first(position)).nth(1).is_none()
    }

    /// The position of a body among the fast ones, if it is one.
    pub fn position(&self, slot: u32) -> Option<u32> {
        let at = self.by_slot.binary_search_by_key(&slot, |at| at.0).ok()?;
        Some(self.by_slot[at].1)
    }

    /// Stops each group where the first of its members is stopped.
    pub fn stop_together(&self, toi_fractions: &mut [Real]) {
        for &(first, member) in &self.members {
            toi_fractions[first as usize] =
                toi_fractions[first as usize].min(toi_fractions[member as usize]);
        }
        for &(first, member) in &self.members {
            toi_fractions[member as usize] = toi_fractions[first as usize];
        }
    }

    /// Stops the group of the body at a position. Returns whether it was not stopped as early before.
    pub fn stop(&self, position: usize, fraction: Real, toi_fractions: &mut [Real]) -> bool {
        if fraction >= toi_fractions[position] {
            return false;
        }
        self.members(self.first(position))
            .for_each(|member| toi_fractions[member as usize] = fraction);
        true
    }

    /// The positions of a group, given its first one.
    pub fn members(&self, first: usize) -> impl Iterator<Item = u32> {
        let first = first as u32;
        let start = self.members.partition_point(|member| member.0 < first);
        let listed = self.members[start..].iter().take_while(move |member| member.0 == first);
        let alone = self.members.get(start).is_none_or(|member| member.0 != first);
        listed.map(|member| member.1).chain(alone.then_some(first))
    }

    fn join(&mut self, position1: u32, position2: u32) {
        let (first1, first2) = (self.find_first(position1), self.find_first(position2));
        self.firsts[first1.max(first2) as usize] = first1.min(first2);
    }

    fn find_first(&mut self, mut position: u32) -> u32 {
        while self.firsts[position as usize] != position {
            // Every other group gets a shorter path.
            let next = self.firsts[position as usize];
            self.firsts[position as usize] = self.firsts[next as usize];
            position = next;
        }
        position
    }

    fn list_members(&mut self) {
        self.members.clear();
        for position in 0..self.firsts.len() as u32 {
            let first = self.find_first(position);
            self.firsts[position as usize] = first;
            if first != position {
                self.members.push((first, position));
            }
        }
        self.members.sort_unstable();
        self.members.dedup();
        // The first ones, too.
        let listed = self.members.len();
        self.members.extend_from_within(..);
        self.members[listed..].iter_mut().for_each(|member| member.1 = member.0);
        self.members.sort_unstable();
        self.members.dedup();
    }
}
