//! Bodies that welds hold rigidly at each other.
//!
//! Normals and moment arms of contacts are frozen during a step. Impulses at a contact of two bodies that
//! rotate together are therefore a couple, which stops the rotation. Such a contact can change nothing else,
//! and only loads the welds. So the solver leaves the contact out.
//!
//! Welds of fixed and kinematic bodies do not count. A mast on the ground may bend, and then rests on the
//! ground or leans on a neighbour. Nor do large groups: a wall of bricks stands on its contacts, because its
//! welds may be solved iteratively, and yield.

use crate::base::in_place::clone_in_place;

/// Largest number of bodies in a group.
const GROUP_SIZE_MAX: usize = 8;

/// Groups of few dynamic bodies, each held together by welds.
#[derive(Debug, Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct WeldGroups {
    /// By body slot: the lowest slot of its group. A body beyond the end is alone.
    first: Vec<u32>,
}

clone_in_place!(WeldGroups { first });

impl WeldGroups {
    /// The groups of welds between the bodies in these slots.
    pub fn of(welds: impl Iterator<Item = [u32; 2]>) -> Self {
        let mut groups = Self::default();
        for slots in welds {
            let [slot1, slot2] = slots.map(|slot| groups.find(slot));
            groups.first[slot1.max(slot2) as usize] = slot1.min(slot2);
        }
        // A body points to a lower slot, whose group is known by then.
        for slot in 0..groups.first.len() {
            groups.first[slot] = groups.first[groups.first[slot] as usize];
        }
        groups.dissolve_large();
        groups
    }

    /// Makes the bodies of large groups alone.
    fn dissolve_large(&mut self) {
        let mut sizes = vec![0; self.first.len()];
        self.first.iter().for_each(|&first| sizes[first as usize] += 1);
        for (slot, first) in self.first.iter_mut().enumerate() {
            if sizes[*first as usize] > GROUP_SIZE_MAX {
                *first = slot as u32;
            }
        }
    }

    /// The body to which a body and all that were merged with it point. Halves the way there.
    fn find(&mut self, mut slot: u32) -> u32 {
        self.first.extend(self.first.len() as u32..=slot);
        while self.first[slot as usize] != slot {
            let next = self.first[slot as usize];
            self.first[slot as usize] = self.first[next as usize];
            slot = next;
        }
        slot
    }

    /// The group of a body.
    fn get(&self, slot: u32) -> u32 {
        self.first.get(slot as usize).copied().unwrap_or(slot)
    }

    /// Returns whether welds hold the bodies in these slots at each other.
    pub fn hold(&self, [slot1, slot2]: [u32; 2]) -> bool {
        self.get(slot1) == self.get(slot2)
    }

    /// The slots of bodies whose group differs from the one in `others`. Two bodies that only `self` or only
    /// `others` hold at each other include such a body.
    pub fn differing<'a>(&'a self, others: &'a Self) -> impl Iterator<Item = u32> + 'a {
        let end = self.first.len().max(others.first.len()) as u32;
        (0..end).filter(|&slot| self.get(slot) != others.get(slot))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Groups are the same in any order of their welds, and those that fall apart differ.
    #[test]
    fn groups_are_those_of_connected_bodies() {
        let welds = [[7, 3], [1, 9], [3, 9], [4, 5]];
        let groups = WeldGroups::of(welds.into_iter());
        let held = [[1, 3], [1, 7], [1, 9], [3, 7], [7, 9], [4, 5]];
        for (slot1, slot2) in (0..12).flat_map(|slot1| (0..slot1).map(move |slot2| (slot2, slot1)))
        {
            let is_held = held.contains(&[slot1, slot2]) || [slot1, slot2] == [3, 9];
            assert_eq!(groups.hold([slot1, slot2]), is_held, "{slot1}, {slot2}");
        }
        let reversed = WeldGroups::of(welds.into_iter().rev());
        assert_eq!(groups.differing(&reversed).count(), 0);
        let parted = WeldGroups::of([[7, 3], [1, 9], [4, 5]].into_iter());
        assert!(groups.differing(&parted).eq([3, 7]));
    }

    /// A row of welded bodies is a group up to its largest size.
    #[test]
    fn large_groups_do_not_count() {
        for count in [GROUP_SIZE_MAX, GROUP_SIZE_MAX + 1] {
            let groups = WeldGroups::of((1..count as u32).map(|slot| [slot, slot - 1]));
            assert_eq!(groups.hold([0, 1]), count == GROUP_SIZE_MAX);
        }
    }
}
