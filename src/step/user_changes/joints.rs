//! Joints that are new or were edited, or whose bodies were.

use super::UserChanges;
use crate::model::body::RigidBodyHandle;
use crate::model::event::CollisionEventFlags;
use crate::model::joint::{ImpulseJointHandle, JointLink};
use crate::model::structure::Structure;

impl UserChanges<'_> {
    /// Removes the joints that the user removed.
    pub(super) fn apply_removed_joints(&mut self) {
        for (handle, wake_up) in self.joints.removed() {
            self.unregister_joint(handle, wake_up);
        }
    }

    /// Follows the changes of all joints that were edited.
    pub(super) fn apply_joints(&mut self) {
        for (handle, wake_up) in self.joints.modified() {
            self.apply_joint(handle, wake_up);
        }
    }

    /// Applies a change of a body's type or state to its joints, which may begin or cease to act.
    pub(super) fn apply_joints_of(&mut self, body: RigidBodyHandle) {
        let known = self.structure.islands.joints.of_body(body.into_raw_parts().0).to_vec();
        for slot in known {
            let Some(link) = self.structure.islands.joints.get(slot) else { continue };
            self.apply_joint(link.handle, false);
        }
    }

    fn apply_joint(&mut self, handle: ImpulseJointHandle, wake_up: bool) {
        let Some(joint) = self.joints.get(handle) else { return };
        let bodies = [joint.body1(), joint.body2()];
        let link = JointLink::of(handle, joint, self.structure.bodies);
        let takes_part =
            |body| self.structure.bodies.get(body).is_some_and(|body| body.is_enabled());
        let blocked = !bodies.into_iter().all(takes_part);
        self.structure.islands.joints.blocked.push((handle, blocked));
        let slot = handle.into_raw_parts().0;
        let mut is_weld_edited = false;
        let known = self.structure.islands.joints.get_mut(slot).map(|known| {
            is_weld_edited = known.form.is_weld != link.form.is_weld;
            let is_placed = known.form.locked == link.form.locked && known.frames == link.frames;
            (known.form, known.frames) = (link.form, link.frames);
            (*known, is_placed)
        });
        self.structure.islands.joints.welds_changed |= is_weld_edited;
        if !known.is_some_and(|(_, is_placed)| is_placed) {
            self.structure.islands.joints.displaced.push(handle);
        }
        let known = known.map(|(known, _)| known);
        let same = |known: JointLink| JointLink { slot: None, ..known } == link;
        if !known.is_some_and(same) {
            if let Some(known) = known {
                self.unregister_joint(known.handle, wake_up);
            }
            if bodies.iter().any(|&body| !self.structure.bodies.contains(body)) {
                return self.structure.islands.joints.orphans.push(handle);
            }
            self.structure.add_joint(link);
            if link.parts_bodies {
                bodies.into_iter().for_each(|body| self.update_partners(body));
            }
        }
        if wake_up {
            bodies.into_iter().for_each(|body| self.structure.wake_body(body));
        }
    }

    fn unregister_joint(&mut self, handle: ImpulseJointHandle, wake_up: bool) {
        let slot = handle.into_raw_parts().0;
        let known = self.structure.islands.joints.get(slot);
        let Some(link) = known.filter(|link| link.handle == handle).copied() else { return };
        self.structure.remove_joint(slot, wake_up);
        if link.parts_bodies {
            link.bodies.into_iter().for_each(|body| self.update_partners(body));
        }
    }

    /// Contacts of bodies that welds began or ceased to hold at each other are computed again.
    pub(super) fn apply_welds(&mut self) {
        let Structure { bodies, islands, narrow_phase, .. } = &mut self.structure;
        let Some(before) = islands.joints.regroup_welded(bodies) else { return };
        let (now, contacts) = (islands.joints.weld_groups(), &mut narrow_phase.contacts);
        let differing = now.differing(&before).filter_map(|slot| bodies.get_unknown_gen(slot));
        for collider in differing.flat_map(|(body, _)| body.colliders.iter()) {
            for k in 0..contacts.ids_of(collider.into_raw_parts().0).len() {
                let id = contacts.ids_of(collider.into_raw_parts().0)[k];
                let slots = contacts.bodies(id);
                if now.hold(slots) != before.hold(slots) {
                    contacts.wake(id);
                    contacts.invalidate(id);
                }
            }
        }
    }

    /// Joints or multibodies changed the bodies that a body collides with. Pairs with others end, and its
    /// colliders search for partners.
    pub(super) fn update_partners(&mut self, body: RigidBodyHandle) {
        let mut index = 0;
        while let Some(collider) = self.collider_of(body, index) {
            let slot = collider.into_raw_parts().0;
            self.drop_parted_pairs(slot);
            self.tree.mark_moved(slot);
            index += 1;
        }
    }

    fn drop_parted_pairs(&mut self, collider_slot: u32) {
        let Structure { narrow_phase, islands, .. } = &self.structure;
        let contacts = &narrow_phase.contacts;
        let is_parted = |&&id: &&_| {
            let [body1, body2] = contacts.bodies(id);
            islands.part(body1, body2)
        };
        let ids: Vec<_> =
            contacts.ids_of(collider_slot).iter().filter(is_parted).copied().collect();
        for id in ids {
            let reported = self.structure.remove_contact_pair(id, true);
            self.report_end(reported, CollisionEventFlags::empty());
        }
    }
}
