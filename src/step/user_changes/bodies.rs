//! Bodies that are new or were edited.

use super::{MassNote, UserChanges};
use crate::model::body::{RestPose, RigidBody, RigidBodyChanges, RigidBodyHandle};
use crate::model::collider::{ColliderEnabled, ColliderHandle};
use crate::model::island::NONE;

impl UserChanges<'_> {
    /// Gives a body that is new, or changed its type, or was enabled or disabled, its place in the
    /// lists. A dynamic body that is one again after edits to and fro keeps its place.
    pub(super) fn reclassify(&mut self, handle: RigidBodyHandle) {
        let Some(body) = self.structure.bodies.get(handle) else { return };
        let is_new = body.changes.contains(RigidBodyChanges::ASSEMBLY);
        let is_listed = body.link.island != NONE;
        let is_as_before = is_listed && body.is_dynamic() && body.is_enabled() && !is_new;
        if !body.changes.intersects(RigidBodyChanges::KIND) {
            return;
        }
        if is_as_before {
            // A collider that was attached between the edits has the old state.
            return self.inform_colliders(handle);
        }
        self.wake_touching(handle);
        self.structure.detach_pairs_of(handle);
        self.structure.detach_joints_of(handle);
        self.structure.unlist_body(handle);
        if let Some(body) = self.structure.bodies.get_unnoted_mut(handle) {
            body.update_world_mass_properties();
            let is_switched = body.changes.contains(RigidBodyChanges::ENABLED_OR_DISABLED);
            if is_switched && body.is_enabled() && !is_new {
                body.activation.wake_up(true);
            }
        }
        self.structure.add_body(handle);
        self.inform_colliders(handle);
        self.structure.refresh_pairs_of(handle);
        self.apply_joints_of(handle);
        self.structure.link_group_of(handle);
    }

    /// Colliders store the type of their body, and are inactive without a body.
    fn inform_colliders(&mut self, handle: RigidBodyHandle) {
        let Some(body) = self.structure.bodies.get(handle) else { return };
        let (body_type, enabled) = (body.body_type, body.enabled);
        for index in 0..body.colliders.len() {
            let Some(body) = self.structure.bodies.get(handle) else { return };
            let collider_handle = body.colliders[index];
            let colliders = &mut *self.structure.colliders;
            let Some(collider) = colliders.get_unnoted_mut(collider_handle) else { continue };
            collider.parent_type = Some(body_type);
            collider.flags.enabled = match (collider.flags.enabled, enabled) {
                (ColliderEnabled::DisabledByParent, true) => ColliderEnabled::Enabled,
                (ColliderEnabled::Enabled, false) => ColliderEnabled::DisabledByParent,
                (unchanged, _) => unchanged,
            };
            self.drop_unfit_pairs(collider_handle);
            self.place(collider_handle);
            self.tree.mark_moved(collider_handle.into_raw_parts().0);
        }
    }

    /// Wakes bodies that touch a body or are joined to it, because its support may be gone.
    pub(super) fn wake_touching(&mut self, handle: RigidBodyHandle) {
        let mut index = 0;
        while let Some(collider) = self.collider_of(handle, index) {
            self.structure.wake_touching(collider.into_raw_parts().0);
            index += 1;
        }
        self.structure.wake_joined(handle);
    }

    fn place_colliders(&mut self, handle: RigidBodyHandle) {
        let mut index = 0;
        while let Some(collider) = self.collider_of(handle, index) {
            self.place(collider);
            index += 1;
        }
    }

    pub(super) fn collider_of(
        &self,
        handle: RigidBodyHandle,
        index: usize,
    ) -> Option<ColliderHandle> {
        self.structure.bodies.get(handle)?.colliders.get(index).copied()
    }

    /// Follows a body's other changes.
    pub(super) fn apply_body(&mut self, handle: RigidBodyHandle, reweighed: &mut Vec<MassNote>) {
        let Some(body) = self.structure.bodies.get_unnoted_mut(handle) else { return };
        let changes = body.changes;
        // The sum of the masses ends the assembly.
        body.changes &= RigidBodyChanges::ASSEMBLY;
        if changes.contains(RigidBodyChanges::POSITION) {
            body.update_world_mass_properties();
            self.place_colliders(handle);
            self.structure.islands.joints.note_moved(handle.into_raw_parts().0);
        }
        if changes.intersects(RigidBodyChanges::POSITION | RigidBodyChanges::DOMINANCE) {
            self.structure.refresh_pairs_of(handle);
        }
        let mass = RigidBodyChanges::LOCAL_MASS_PROPERTIES | RigidBodyChanges::COLLIDERS;
        if changes.intersects(mass) {
            self.note_mass(handle, false, reweighed);
        }
        // Access to the thresholds of an awake body must not restart its time until it sleeps.
        let is_woken = |body: &RigidBody| !body.is_sleeping() && body.link.awake == NONE;
        if changes.contains(RigidBodyChanges::SLEEP)
            && self.structure.bodies.get(handle).is_some_and(is_woken)
        {
            self.structure.wake_body(handle);
        }
    }

    /// Puts bodies to sleep that the user sent to sleep: all bodies of an island or none, since the
    /// others would hold them awake.
    pub(super) fn apply_sleepers(&mut self, modified: &[RigidBodyHandle]) {
        for &handle in modified {
            let Some(body) = self.structure.bodies.get(handle) else { continue };
            if !body.activation.sleeping || body.link.awake == NONE {
                continue;
            }
            match body.link.island {
                // The solver needs the pose of a body that touches an awake body.
                NONE if self.structure.has_awake_partner(handle) => self.stay_awake(handle),
                NONE => self.structure.sleep_kinematic(handle),
                island if self.are_all_put_to_sleep(island) => self.structure.sleep_island(island),
                _ => self.stay_awake(handle),
            }
        }
    }

    /// Keeps a body awake that was sent to sleep; it is the first to be ready when the others are.
    fn stay_awake(&mut self, handle: RigidBodyHandle) {
        if let Some(body) = self.structure.bodies.get_unnoted_mut(handle) {
            body.activation.sleeping = false;
            body.activation.time_since_can_sleep = body.activation.time_until_sleep;
            body.rest = RestPose::of(body);
        }
    }

    fn are_all_put_to_sleep(&self, island: u32) -> bool {
        let bodies = &self.structure.islands.island(island).bodies;
        bodies.iter().all(|&handle| {
            self.structure.bodies.get(handle).is_some_and(|body| body.activation.sleeping)
        })
    }
}
