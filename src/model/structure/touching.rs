//! Touching pairs in the structure: they hold islands together, and their manifolds have colours while one of
//! their bodies is awake.

use super::Structure;
use crate::model::constraint_graph::ManifoldRef;
use crate::model::contact::PairId;

impl Structure<'_> {
    /// Registers a touching pair: its bodies are in one island from now on, and its manifolds get colours. A
    /// sleeping island that an awake dynamic body touches wakes.
    pub fn attach(&mut self, id: PairId) {
        let slots = self.narrow_phase.contacts.bodies(id);
        self.narrow_phase.contacts[id].attached = true;
        let dynamic = self.dynamic_slots(slots);
        if let [Some(slot1), Some(slot2)] = dynamic {
            self.link(slot1, slot2);
        }
        self.wake_touched(dynamic);
        self.update_colors(id);
    }

    /// Wakes sleeping bodies at a new contact. An edit caused it, as of a fixed collider that appeared inside
    /// one of them. Bodies that the user put there asleep stay asleep.
    fn wake_touched(&mut self, dynamic: [Option<u32>; 2]) {
        let slots = || dynamic.into_iter().flatten();
        if slots().all(|slot| self.is_awake(slot))
            || slots().any(|slot| self.islands.placed_asleep.contains(slot))
        {
            return;
        }
        for slot in slots() {
            if let Some((handle, _)) = self.bodies.at_slot(slot) {
                self.wake_body(handle);
            }
        }
    }

    /// A pair no longer touches, or will be removed. Returns whether it was attached.
    pub fn detach(&mut self, id: PairId) -> bool {
        let slots = self.narrow_phase.contacts.bodies(id);
        let pair = &mut self.narrow_phase.contacts[id];
        if !core::mem::replace(&mut pair.attached, false) {
            return false;
        }
        for manifold in 0..self.narrow_phase.contacts[id].manifolds.len() {
            self.uncolor(ManifoldRef { pair: id, manifold: manifold as u32 });
        }
        if let [Some(slot1), Some(_)] = self.dynamic_slots(slots)
            && let Some(island) = self.body(slot1).map(|body| body.link.island)
        {
            self.islands.island_mut(island).is_cut = true;
        }
        true
    }

    /// Gives colours to those manifolds of a pair that should have one, and takes the others' away.
    pub fn update_colors(&mut self, id: PairId) {
        let slots = self.narrow_phase.contacts.bodies(id);
        let dynamic = self.dynamic_slots(slots);
        let awake = dynamic.iter().flatten().any(|&slot| self.is_awake(slot));
        let is_active = awake && self.narrow_phase.contacts[id].attached;
        for index in 0..self.narrow_phase.contacts[id].manifolds.len() {
            let manifold = ManifoldRef { pair: id, manifold: index as u32 };
            let state = &self.narrow_phase.contacts[id].manifolds[index];
            if !(is_active && state.is_solved()) {
                self.uncolor(manifold);
            } else if state.slot.is_none() {
                self.narrow_phase.complete(id);
                let slot = self.islands.graph.add(manifold, dynamic);
                self.narrow_phase.contacts[id].manifolds[index].slot = Some(slot);
            }
        }
    }

    /// Removes a manifold from the constraint graph, if the graph contains the manifold.
    pub fn uncolor(&mut self, manifold: ManifoldRef) {
        let bodies = self.narrow_phase.contacts.bodies(manifold.pair);
        let manifolds = &self.narrow_phase.contacts[manifold.pair].manifolds;
        let Some(slot) = manifolds[manifold.manifold as usize].slot else { return };
        self.narrow_phase.complete(manifold.pair);
        let pair = &mut self.narrow_phase.contacts[manifold.pair];
        pair.manifolds[manifold.manifold as usize].slot = None;
        if let Some(moved) = self.islands.graph.remove(slot, bodies) {
            self.narrow_phase.complete(moved.pair);
            let pair = &mut self.narrow_phase.contacts[moved.pair];
            pair.manifolds[moved.manifold as usize].slot = Some(slot);
        }
    }
}
