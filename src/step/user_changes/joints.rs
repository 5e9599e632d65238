//! Joints that are new or were edited, or whose bodies were.

use super::UserChanges;
use crate::model::body::RigidBodyHandle;
use crate::model::event::CollisionEventFlags;
use crate::model::joint::{ImpulseJointHandle, JointLink};

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
        let known = self.structure.islands.joints.get_mut(slot).map(|known| {
            known.form = link.form;
            *known
        });
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
                self.drop_pairs_between(bodies);
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
            // The pair may interact again, so both search for partners.
            for body in link.bodies {
                self.each_collider_of(body, |apply, slot| apply.tree.mark_moved(slot));
            }
        }
    }

    fn each_collider_of(&mut self, body: RigidBodyHandle, visit: impl Fn(&mut Self, u32)) {
        let mut index = 0;
        while let Some(collider) = self.collider_of(body, index) {
            visit(self, collider.into_raw_parts().0);
            index += 1;
        }
    }

    /// Removes the pairs between two bodies' colliders.
    fn drop_pairs_between(&mut self, [body1, body2]: [RigidBodyHandle; 2]) {
        let slots = [body1, body2].map(|body| body.into_raw_parts().0);
        self.each_collider_of(body1, |apply, collider| {
            let store = &apply.structure.narrow_phase.contacts;
            let between = |&&id: &&_| {
                let bodies = store.bodies(id);
                bodies == slots || bodies == [slots[1], slots[0]]
            };
            let ids: Vec<_> = store.ids_of(collider).iter().filter(between).copied().collect();
            for id in ids {
                let reported = apply.structure.remove_contact_pair(id);
                apply.report_end(reported, CollisionEventFlags::empty());
            }
        });
    }
}
