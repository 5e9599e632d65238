//! The operations that keep bodies, pairs, islands and colours in agreement.
//!
//! Four lists reference each other. A body stores its island and its awake position, a pair its awake
//! position, a touching pair ("attached") its islands, and its manifolds their colours. All changes use
//! methods of this type; [`Structure::validate`] states the invariants between stages.
//!
//! * A contact or intersection pair is awake if one of its bodies is. (Between an edit and the next
//!   narrow phase, a pair that must be computed once is listed awake too.)
//! * A contact pair is of two bodies that no joint and no multibody keeps from colliding.
//! * A contact pair that touches and is to be solved is attached: its two dynamic bodies are in one island.
//!   When that ends, sleeping bodies of the pair wake.
//! * The manifolds of an attached pair have colours if one of its dynamic bodies is awake.
//! * A joint that acts is attached like a touching pair, and has a colour under the same condition.
//! * A kinematic body with an awake pair, or joined to an awake dynamic body, is awake: the solver needs its
//!   pose.

mod check;
mod groups;
mod islands;
mod joints;
mod touching;

use crate::base::wide::PREFETCH_DISTANCE;
use crate::model::body::{RestPose, RigidBody, RigidBodyHandle, RigidBodySet};
use crate::model::collider::ColliderHandle;
use crate::model::collider::ColliderSet;
use crate::model::constraint_graph::ManifoldRef;
use crate::model::contact::{ContactManifold, ContactPair, IntersectionPair, NarrowPhase, PairId};
use crate::model::island::{BodyLink, BodyMotion, IslandManager, NONE};

/// Mutable access to everything that the structure spans.
pub(crate) struct Structure<'a> {
    pub bodies: &'a mut RigidBodySet,
    pub colliders: &'a mut ColliderSet,
    pub narrow_phase: &'a mut NarrowPhase,
    pub islands: &'a mut IslandManager,
}

impl Structure<'_> {
    /// The same access for a shorter time.
    pub fn reborrow(&mut self) -> Structure<'_> {
        Structure {
            bodies: self.bodies,
            colliders: self.colliders,
            narrow_phase: self.narrow_phase,
            islands: self.islands,
        }
    }

    fn body(&self, slot: u32) -> Option<&RigidBody> {
        self.bodies.at_slot(slot).map(|(_, body)| body)
    }

    /// The slots of those of the pair's bodies that contacts can move.
    fn dynamic_slots(&self, slots: [u32; 2]) -> [Option<u32>; 2] {
        slots.map(|slot| {
            (slot != NONE && self.body(slot).is_some_and(|body| body.link.island != NONE))
                .then_some(slot)
        })
    }

    fn is_awake(&self, slot: u32) -> bool {
        self.body(slot).is_some_and(|body| body.link.awake != NONE)
    }

    // --- bodies ---------------------------------------------------------------------------------

    /// Takes a new body into the lists it belongs to. Its pairs, if it has any, are not touched.
    pub fn add_body(&mut self, handle: RigidBodyHandle) {
        let Some(body) = self.bodies.get_unnoted_mut(handle) else { return };
        debug_assert!(body.link.island == NONE && body.link.awake == NONE);
        if !body.is_enabled() || body.is_fixed() {
            return;
        }
        let sleeping = body.activation.sleeping;
        if body.is_dynamic() {
            let island = self.islands.create_island();
            body.link.island = island;
            body.link.island_position = 0;
            let island = self.islands.island_mut(island);
            island.bodies.push(handle);
            island.sleeping = sleeping;
        }
        if !sleeping {
            self.list_awake(handle);
        }
    }

    /// Takes a body out of all lists, but leaves it in its set. Its pairs must have been detached.
    pub fn unlist_body(&mut self, handle: RigidBodyHandle) {
        let Some(body) = self.bodies.get_unnoted_mut(handle) else { return };
        let unlisted = BodyLink::of_slot(handle.into_raw_parts().0);
        let link = core::mem::replace(&mut body.link, unlisted);
        self.unregister_bodies(&mut [(handle, link)]);
    }

    /// Takes bodies that are gone from their set out of all lists. Each is paired with its last positions in
    /// the lists.
    pub fn unregister_bodies(&mut self, removed: &mut [(RigidBodyHandle, BodyLink)]) {
        for (handle, link) in removed.iter_mut() {
            self.islands.set_motion(handle.into_raw_parts().0, BodyMotion::NONE);
            self.verify_link(*handle, link);
        }
        // Highest position first: the element that swap-removal moves into a gap is never removed itself.
        removed.sort_unstable_by_key(|(_, link)| core::cmp::Reverse(link.awake));
        for (_, link) in removed.iter() {
            if link.awake != NONE {
                self.unlist_awake(link.awake);
            }
        }
        removed.sort_unstable_by_key(|(_, link)| core::cmp::Reverse(link.island_position));
        for (_, link) in removed.iter() {
            if link.island != NONE {
                self.leave_island(*link);
            }
        }
    }

    /// Removes outdated positions of a removed body: it may have replaced another one just before its
    /// removal.
    fn verify_link(&self, handle: RigidBodyHandle, link: &mut BodyLink) {
        if self.islands.awake.get(link.awake as usize) != Some(&handle) {
            link.awake = NONE;
        }
        let is_member = link.island < self.islands.island_bound()
            && self.islands.island(link.island).bodies.get(link.island_position as usize)
                == Some(&handle);
        if !is_member {
            (link.island, link.island_position) = (NONE, NONE);
        }
    }

    fn leave_island(&mut self, link: BodyLink) {
        let island = self.islands.island_mut(link.island);
        island.bodies.swap_remove(link.island_position as usize);
        island.is_cut = true;
        match island.bodies.get(link.island_position as usize).copied() {
            Some(moved) => {
                if let Some(body) = self.bodies.get_unnoted_mut(moved) {
                    body.link.island_position = link.island_position;
                }
            }
            None if island.bodies.is_empty() => self.islands.destroy_island(link.island),
            None => {}
        }
    }

    fn list_awake(&mut self, handle: RigidBodyHandle) {
        let Some(body) = self.bodies.get_unnoted_mut(handle) else { return };
        if body.link.awake == NONE {
            body.activation.sleeping = false;
            body.rest = RestPose::of(body);
            let is_kinematic = body.link.island == NONE;
            let changed = self.islands.awake.insert(handle, is_kinematic);
            self.store_places(changed);
        }
    }

    fn unlist_awake(&mut self, position: u32) {
        let changed = self.islands.awake.remove(position as usize);
        self.store_places(changed);
    }

    /// Stores in bodies their positions in the list of awake bodies.
    fn store_places(&mut self, positions: [usize; 2]) {
        for position in positions {
            if let Some(&moved) = self.islands.awake.get(position)
                && let Some(body) = self.bodies.get_unnoted_mut(moved)
            {
                body.link.awake = position as u32;
            }
        }
    }

    // --- waking and sleeping --------------------------------------------------------------------

    /// Wakes a body, with its island if it has one; one that is awake stays so for a while longer.
    pub fn wake_body(&mut self, handle: RigidBodyHandle) {
        let Some(body) = self.bodies.get_unnoted_mut(handle) else { return };
        body.activation.wake_up(true);
        match body.link.island {
            // Everything that touches a moving kinematic body reads its pairs' states, and the pairs of an
            // awake body are awake.
            NONE if body.is_kinematic() && body.is_enabled() && body.link.awake == NONE => {
                self.list_awake(handle);
                self.wake_pairs_of(handle);
            }
            NONE => {}
            island => self.wake_island(island),
        }
    }

    /// Puts an island back into the per-step lists.
    pub fn wake_island(&mut self, island: u32) {
        if !self.islands.island(island).sleeping {
            return;
        }
        self.islands.island_mut(island).sleeping = false;
        let count = self.islands.island(island).bodies.len();
        // All bodies first: a pair's colour depends on whether its two bodies are awake.
        for i in 0..count {
            let handle = self.islands.island(island).bodies[i];
            self.list_awake(handle);
            if let Some(body) = self.bodies.get_unnoted_mut(handle) {
                body.activation.wake_up(true);
            }
        }
        for i in 0..count {
            let handle = self.islands.island(island).bodies[i];
            self.wake_pairs_of(handle);
            self.update_joints_of(handle);
        }
    }

    fn wake_pairs_of(&mut self, handle: RigidBodyHandle) {
        for c in 0..self.collider_count(handle) {
            let Some(slot) = self.collider_slot(handle, c) else { continue };
            for i in 0..self.narrow_phase.contacts.ids_of(slot).len() {
                let id = self.narrow_phase.contacts.ids_of(slot)[i];
                self.narrow_phase.contacts.wake(id);
                self.update_colors(id);
                self.wake_kinematic_of(self.narrow_phase.contacts.bodies(id));
            }
            for i in 0..self.narrow_phase.intersections.ids_of(slot).len() {
                let id = self.narrow_phase.intersections.ids_of(slot)[i];
                self.narrow_phase.intersections.wake(id);
            }
        }
    }

    fn wake_kinematic_of(&mut self, slots: [u32; 2]) {
        for slot in slots {
            if let Some((handle, body)) = self.bodies.at_slot(slot)
                && body.is_kinematic()
                && body.link.awake == NONE
            {
                self.wake_body(handle);
            }
        }
    }

    /// Returns whether a contact pair or a joint connects this body to an awake dynamic one.
    pub fn has_awake_partner(&self, handle: RigidBodyHandle) -> bool {
        let colliders = 0..self.collider_count(handle);
        let mut slots = colliders.filter_map(|c| self.collider_slot(handle, c));
        self.holds_awake_body(handle)
            || slots.any(|slot| {
                self.narrow_phase.contacts.ids_of(slot).iter().any(|&id| {
                    let dynamic = self.dynamic_slots(self.narrow_phase.contacts.bodies(id));
                    dynamic.into_iter().flatten().any(|slot| self.is_awake(slot))
                })
            })
    }

    /// Takes an island out of the per-step lists. Its bodies stand still until they are woken.
    pub fn sleep_island(&mut self, island: u32) {
        if core::mem::replace(&mut self.islands.island_mut(island).sleeping, true) {
            return;
        }
        let count = self.islands.island(island).bodies.len();
        for i in 0..count {
            self.unlist_sleeper(self.islands.island(island).bodies[i]);
        }
        for i in 0..count {
            let handle = self.islands.island(island).bodies[i];
            self.sleep_pairs_of(handle);
            self.update_joints_of(handle);
        }
    }

    /// Puts a kinematic body to sleep; it is at rest, so no partner is affected.
    pub fn sleep_kinematic(&mut self, handle: RigidBodyHandle) {
        self.unlist_sleeper(handle);
        self.sleep_pairs_of(handle);
    }

    fn unlist_sleeper(&mut self, handle: RigidBodyHandle) {
        let Some(body) = self.bodies.get_unnoted_mut(handle) else { return };
        body.activation.sleep();
        body.vels.linvel = Default::default();
        body.vels.angvel = Default::default();
        let position = core::mem::replace(&mut body.link.awake, NONE);
        self.islands.set_motion(handle.into_raw_parts().0, BodyMotion::NONE);
        if position != NONE {
            self.unlist_awake(position);
        }
    }

    fn sleep_pairs_of(&mut self, handle: RigidBodyHandle) {
        for c in 0..self.collider_count(handle) {
            let Some(slot) = self.collider_slot(handle, c) else { continue };
            for i in 0..self.narrow_phase.contacts.ids_of(slot).len() {
                let id = self.narrow_phase.contacts.ids_of(slot)[i];
                self.update_colors(id);
                // A pair that stays awake would miss this body's last motion.
                self.narrow_phase.contacts.invalidate(id);
                // The triangle cache of a sleeping body is freed.
                self.narrow_phase.contacts[id].triangle_cache = None;
                self.rest_contact(id);
            }
            for i in 0..self.narrow_phase.intersections.ids_of(slot).len() {
                self.rest_intersection(self.narrow_phase.intersections.ids_of(slot)[i]);
            }
        }
    }

    fn collider_count(&self, handle: RigidBodyHandle) -> usize {
        self.bodies.get(handle).map_or(0, |body| body.colliders.len())
    }

    fn collider_slot(&self, handle: RigidBodyHandle, index: usize) -> Option<u32> {
        let collider = *self.bodies.get(handle)?.colliders.get(index)?;
        Some(collider.into_raw_parts().0)
    }

    // --- pairs ------------------------------------------------------------------------------------

    /// The slots of the bodies of two colliders.
    pub fn parent_slots(&self, pair: [ColliderHandle; 2]) -> [u32; 2] {
        pair.map(|handle| {
            let parent = self.colliders.get(handle).and_then(|collider| collider.parent());
            parent.map_or(NONE, |parent| parent.into_raw_parts().0)
        })
    }

    /// Adds the pairs of colliders whose boxes began to overlap.
    pub fn add_pairs(&mut self, pairs: &[(ColliderHandle, ColliderHandle)]) {
        for (turn, &(collider1, collider2)) in pairs.iter().enumerate() {
            self.prefetch_addition(&pairs[turn..]);
            self.add_pair(collider1, collider2);
        }
    }

    /// Prefetches the input of the later ones of some pairs while the first ones are added. A collider stores
    /// its body's index, so the collider is prefetched first.
    fn prefetch_addition(&self, pairs: &[(ColliderHandle, ColliderHandle)]) {
        let contacts = &self.narrow_phase.contacts;
        contacts.prefetch_vacancy(PREFETCH_DISTANCE);
        if let Some(&(collider1, collider2)) = pairs.get(PREFETCH_DISTANCE) {
            let slots = [collider1, collider2].map(|collider| collider.into_raw_parts().0);
            slots.into_iter().for_each(|slot| self.colliders.prefetch(slot));
            contacts.prefetch_lists(slots);
        }
        if let Some(&(collider1, collider2)) = pairs.get(PREFETCH_DISTANCE / 2) {
            let slots = self.parent_slots([collider1, collider2]);
            slots.into_iter().for_each(|slot| self.bodies.prefetch(slot));
        }
    }

    /// Prefetches the data that the begin or end of a contact pair reads.
    pub fn prefetch_contact(&self, id: PairId) {
        let contacts = &self.narrow_phase.contacts;
        contacts.prefetch(id);
        contacts.prefetch_lists(contacts.collider_slots(id));
        contacts.bodies(id).into_iter().for_each(|slot| self.bodies.prefetch(slot));
    }

    /// Two colliders came close: one contact pair more, or an intersection pair if one is a sensor.
    fn add_pair(&mut self, collider1: ColliderHandle, collider2: ColliderHandle) {
        let slots = self.parent_slots([collider1, collider2]);
        let awake = slots.iter().any(|&slot| self.is_awake(slot));
        let is_sensor = |handle| self.colliders.get(handle).is_some_and(|c| c.is_sensor());
        if is_sensor(collider1) || is_sensor(collider2) {
            let pair = IntersectionPair::new(collider1, collider2);
            self.narrow_phase.intersections.insert(pair, slots);
        } else {
            debug_assert!(!self.islands.part(slots[0], slots[1]), "the two bodies collide");
            self.narrow_phase.contacts.insert(ContactPair::new(collider1, collider2), slots);
            if awake {
                self.wake_kinematic_of(slots);
            }
        }
    }

    /// Puts a contact pair to sleep, once it was computed, if none of its bodies is awake.
    pub fn rest_contact(&mut self, id: PairId) {
        let bodies = self.narrow_phase.contacts.bodies(id);
        if !bodies.iter().any(|&body| self.is_awake(body)) {
            self.narrow_phase.contacts.sleep(id);
        }
    }

    /// The same for a pair with a sensor.
    pub fn rest_intersection(&mut self, id: PairId) {
        let bodies = self.narrow_phase.intersections.bodies(id);
        if !bodies.iter().any(|&body| self.is_awake(body)) {
            self.narrow_phase.intersections.sleep(id);
        }
    }

    /// Marks all pairs of a body as due, because the body itself has changed.
    pub fn refresh_pairs_of(&mut self, handle: RigidBodyHandle) {
        for c in 0..self.collider_count(handle) {
            if let Some(slot) = self.collider_slot(handle, c) {
                self.refresh_pairs(slot);
            }
        }
    }

    /// The same for the pairs of one collider.
    pub fn refresh_pairs(&mut self, collider_slot: u32) {
        for i in 0..self.narrow_phase.contacts.ids_of(collider_slot).len() {
            let id = self.narrow_phase.contacts.ids_of(collider_slot)[i];
            let bodies = self.narrow_phase.contacts.bodies(id);
            self.update_colors(id);
            self.narrow_phase.contacts.wake(id);
            self.narrow_phase.contacts.invalidate(id);
            // The shape may have changed.
            self.narrow_phase.contacts[id].triangle_cache = None;
            if bodies.iter().any(|&body| self.is_awake(body)) {
                self.wake_kinematic_of(bodies);
            }
        }
        for i in 0..self.narrow_phase.intersections.ids_of(collider_slot).len() {
            let id = self.narrow_phase.intersections.ids_of(collider_slot)[i];
            self.narrow_phase.intersections.wake(id);
            self.narrow_phase.intersections.invalidate(id);
        }
    }

    /// Cuts all links of a body before its type changes.
    pub fn detach_pairs_of(&mut self, handle: RigidBodyHandle) {
        for c in 0..self.collider_count(handle) {
            let Some(slot) = self.collider_slot(handle, c) else { continue };
            for i in 0..self.narrow_phase.contacts.ids_of(slot).len() {
                self.detach(self.narrow_phase.contacts.ids_of(slot)[i]);
            }
        }
    }

    /// Wakes all bodies that touch a collider.
    pub fn wake_touching(&mut self, collider_slot: u32) {
        for i in 0..self.narrow_phase.contacts.ids_of(collider_slot).len() {
            let id = self.narrow_phase.contacts.ids_of(collider_slot)[i];
            if self.narrow_phase.contacts[id].is_touching() {
                self.wake_bodies_of(id);
            }
        }
    }

    /// Wakes the bodies of a pair; awake ones stay so for a while longer.
    pub fn wake_bodies_of(&mut self, id: PairId) {
        for slot in self.narrow_phase.contacts.bodies(id) {
            if let Some((handle, _)) = self.bodies.at_slot(slot) {
                self.wake_body(handle);
            }
        }
    }

    /// A pair no longer holds its bodies. Those that sleep wake: they may have lost their support.
    fn release(&mut self, id: PairId) {
        if !self.detach(id) {
            return;
        }
        for slot in self.narrow_phase.contacts.bodies(id) {
            let sleeper = self.bodies.at_slot(slot).filter(|(_, body)| body.link.awake == NONE);
            if let Some((handle, _)) = sleeper {
                self.wake_body(handle);
            }
        }
    }

    /// Removes the pair of two colliders that are too far apart, may no longer collide, or of which one is
    /// removed. Bodies that it held wake, unless the user removed a collider without waking anything.
    ///
    /// Returns the colliders if their begin event was emitted.
    pub fn remove_contact_pair(
        &mut self,
        id: PairId,
        wake_up: bool,
    ) -> Option<[ColliderHandle; 2]> {
        if wake_up {
            self.release(id);
        } else {
            self.detach(id);
        }
        self.narrow_phase.contacts.remove(id)
    }

    /// A pair was computed: its manifolds may be more or fewer, its bodies may have begun or stopped
    /// to touch. Manifolds that lost all their points go.
    pub fn follow_contact(&mut self, id: PairId) {
        let manifolds = &self.narrow_phase.contacts[id].manifolds;
        let left = manifolds.iter().take_while(|manifold| !manifold.contacts().is_empty()).count();
        for index in left..manifolds.len() {
            self.uncolor(ManifoldRef { pair: id, manifold: index as u32 });
        }
        let pair = &mut self.narrow_phase.contacts[id];
        pair.manifolds.truncate(left);
        pair.has_any_active_contact = left > 0;
        let is_solved = pair.manifolds.iter().any(ContactManifold::is_solved);
        match (is_solved, pair.attached) {
            (true, false) => self.attach(id),
            (false, true) => self.release(id),
            (true, true) => self.update_colors(id),
            (false, false) => {}
        }
    }
}
