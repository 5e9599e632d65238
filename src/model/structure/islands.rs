//! Islands in the structure: merged when a link is made, divided when a cut is processed.

use super::Structure;
use crate::model::body::RigidBodyHandle;
use crate::model::island::NONE;

impl Structure<'_> {
    /// Merges the islands of two dynamic bodies; if one of them sleeps, it wakes.
    pub(super) fn link(&mut self, slot1: u32, slot2: u32) {
        let island_of = |slot| self.body(slot).map_or(NONE, |body| body.link.island);
        let (island1, island2) = (island_of(slot1), island_of(slot2));
        if island1 == island2 {
            return;
        }
        if self.islands.island(island1).sleeping != self.islands.island(island2).sleeping {
            self.wake_island(island1);
            self.wake_island(island2);
        }
        let size = |island| self.islands.island(island).bodies.len();
        let (large, small) =
            if size(island1) >= size(island2) { (island1, island2) } else { (island2, island1) };
        self.merge(large, small);
    }

    fn merge(&mut self, large: u32, small: u32) {
        let mut moving = core::mem::take(&mut self.islands.island_mut(small).bodies);
        let is_cut = self.islands.island(small).is_cut;
        let island = self.islands.island_mut(large);
        island.is_cut |= is_cut;
        for &handle in &moving {
            if let Some(body) = self.bodies.get_unnoted_mut(handle) {
                body.link.island = large;
                body.link.island_position = island.bodies.len() as u32;
                island.bodies.push(handle);
            }
        }
        moving.clear();
        self.islands.island_mut(small).bodies = moving;
        self.islands.destroy_island(small);
    }

    /// Splits an island whose links were cut into its connected parts.
    pub fn split(&mut self, island: u32) {
        debug_assert!(!self.islands.island(island).sleeping);
        let members = core::mem::take(&mut self.islands.island_mut(island).bodies);
        self.islands.island_mut(island).is_cut = false;
        for &handle in &members {
            if let Some(body) = self.bodies.get_unnoted_mut(handle) {
                body.link.island_position = NONE; // not visited yet
            }
        }
        let mut target = island;
        let mut stack = Vec::new();
        for &seed in &members {
            if self.bodies.get(seed).is_none_or(|body| body.link.island_position != NONE) {
                continue;
            }
            if target == NONE {
                target = self.islands.create_island();
            }
            self.islands.island_mut(target).split_at = self.islands.step;
            self.join(seed, target);
            stack.push(seed);
            while let Some(handle) = stack.pop() {
                self.join_neighbours(handle, target, &mut stack);
            }
            target = NONE;
        }
    }

    fn join(&mut self, handle: RigidBodyHandle, island: u32) {
        let Some(body) = self.bodies.get_unnoted_mut(handle) else { return };
        let list = &mut self.islands.island_mut(island).bodies;
        body.link.island = island;
        body.link.island_position = list.len() as u32;
        list.push(handle);
    }

    fn join_neighbours(
        &mut self,
        handle: RigidBodyHandle,
        island: u32,
        stack: &mut Vec<RigidBodyHandle>,
    ) {
        let own = handle.into_raw_parts().0;
        for c in 0..self.collider_count(handle) {
            let Some(slot) = self.collider_slot(handle, c) else { continue };
            for i in 0..self.narrow_phase.contacts.ids_of(slot).len() {
                let id = self.narrow_phase.contacts.ids_of(slot)[i];
                if !self.narrow_phase.contacts[id].attached {
                    continue;
                }
                let [slot1, slot2] = self.narrow_phase.contacts.bodies(id);
                let other = if slot1 == own { slot2 } else { slot1 };
                self.join_if_new(other, island, stack);
            }
        }
        let mut joined = Vec::new();
        self.for_each_joined(own, |other| joined.push(other));
        for other in joined {
            self.join_if_new(other, island, stack);
        }
    }

    fn join_if_new(&mut self, slot: u32, island: u32, stack: &mut Vec<RigidBodyHandle>) {
        let Some((handle, body)) = self.bodies.at_slot(slot) else { return };
        if body.link.island != NONE && body.link.island_position == NONE {
            self.join(handle, island);
            stack.push(handle);
        }
    }
}
