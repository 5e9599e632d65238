//! Joints in the structure: they hold islands together, and have colours while one of their bodies is
//! awake.

use super::Structure;
use crate::model::body::RigidBodyHandle;
use crate::model::joint::JointLink;

impl Structure<'_> {
    /// Registers a joint. Its bodies must exist, and its slot must be empty.
    pub fn add_joint(&mut self, link: JointLink) {
        let slot = link.handle.into_raw_parts().0;
        let attached = link.attached;
        self.islands.joints.insert(JointLink { attached: false, slot: None, ..link });
        if attached {
            self.attach_joint(slot);
        }
    }

    /// Removes a joint. Its bodies wake if `wake_up` is `true`.
    pub fn remove_joint(&mut self, slot: u32, wake_up: bool) {
        let Some(link) = self.islands.joints.get(slot).copied() else { return };
        self.detach_joint(slot);
        self.islands.joints.remove(slot);
        if wake_up {
            link.bodies.into_iter().for_each(|body| self.wake_body(body));
        }
    }

    /// Cuts the joints of bodies that are gone, or about to be removed from all lists. The joints of removed
    /// bodies are removed, and their other bodies wake.
    pub fn remove_joints_of(&mut self, body: RigidBodyHandle) {
        while let Some(&slot) = self.islands.joints.of_body(body.into_raw_parts().0).last() {
            let Some(link) = self.islands.joints.get(slot) else { return };
            let handle = link.handle;
            self.remove_joint(slot, true);
            self.islands.joints.orphans.push(handle);
        }
    }

    /// Cuts all joints of a body before its type changes.
    pub fn detach_joints_of(&mut self, body: RigidBodyHandle) {
        self.for_each_joint_of(body, Self::detach_joint);
    }

    /// Wakes all bodies that are joined to a body.
    pub fn wake_joined(&mut self, body: RigidBodyHandle) {
        self.for_each_joint_of(body, |structure, slot| {
            let Some(link) = structure.islands.joints.get(slot).copied() else { return };
            if link.attached {
                link.bodies.into_iter().for_each(|body| structure.wake_body(body));
            }
        });
        self.wake_group_of(body);
    }

    /// Gives the joints of a body that woke or fell asleep a colour, or takes it away.
    pub(super) fn update_joints_of(&mut self, body: RigidBodyHandle) {
        self.for_each_joint_of(body, Self::update_joint_color);
    }

    /// Returns whether a joint connects this body to an awake dynamic one.
    pub(super) fn holds_awake_body(&self, body: RigidBodyHandle) -> bool {
        self.islands
            .joints
            .of_body(body.into_raw_parts().0)
            .iter()
            .any(|&slot| self.islands.joints.get(slot).is_some_and(|link| link.slot.is_some()))
    }

    /// The slots of the bodies that joints of either kind hold to the one in this slot.
    pub fn for_each_joined(&self, own: u32, mut visit: impl FnMut(u32)) {
        for &slot in self.islands.joints.of_body(own) {
            let Some(link) = self.islands.joints.get(slot).filter(|link| link.attached) else {
                continue;
            };
            link.body_slots().into_iter().filter(|&other| other != own).for_each(&mut visit);
        }
        let group = self.islands.groups.of(own).iter().map(|other| other.into_raw_parts().0);
        group.filter(|&other| other != own).for_each(visit);
    }

    fn for_each_joint_of(&mut self, body: RigidBodyHandle, visit: impl Fn(&mut Self, u32)) {
        let body = body.into_raw_parts().0;
        for i in 0..self.islands.joints.of_body(body).len() {
            visit(self, self.islands.joints.of_body(body)[i]);
        }
    }

    /// Activates the joint: its dynamic bodies are in one island from now on.
    fn attach_joint(&mut self, slot: u32) {
        let Some(link) = self.islands.joints.get_mut(slot) else { return };
        link.attached = true;
        let (slots, is_weld) = (link.body_slots(), link.form.is_weld);
        self.islands.joints.welds_changed |= is_weld;
        if let [Some(slot1), Some(slot2)] = self.dynamic_slots(slots) {
            self.link(slot1, slot2);
        }
        self.update_joint_color(slot);
    }

    /// The joint no longer acts.
    fn detach_joint(&mut self, slot: u32) {
        let Some(link) = self.islands.joints.get_mut(slot) else { return };
        if !core::mem::replace(&mut link.attached, false) {
            return;
        }
        let (slots, is_weld) = (link.body_slots(), link.form.is_weld);
        self.islands.joints.welds_changed |= is_weld;
        self.update_joint_color(slot);
        if let [Some(slot1), Some(_)] = self.dynamic_slots(slots)
            && let Some(island) = self.body(slot1).map(|body| body.link.island)
        {
            self.islands.island_mut(island).is_cut = true;
        }
    }

    /// A joint that acts has a colour if one of its dynamic bodies is awake.
    fn update_joint_color(&mut self, slot: u32) {
        let Some(link) = self.islands.joints.get(slot).copied() else { return };
        let bodies = link.body_slots();
        let dynamic = self.dynamic_slots(bodies);
        let is_solved = link.attached && dynamic.iter().flatten().any(|&body| self.is_awake(body));
        let color = match (is_solved, link.slot) {
            (true, None) => {
                self.wake_kinematic_of(bodies);
                Some(self.islands.joint_graph.add(slot, dynamic))
            }
            (false, Some(color)) => {
                let moved = self.islands.joint_graph.remove(color, bodies);
                if let Some(moved) = moved.and_then(|moved| self.islands.joints.get_mut(moved)) {
                    moved.slot = Some(color);
                }
                None
            }
            (_, unchanged) => unchanged,
        };
        if let Some(link) = self.islands.joints.get_mut(slot) {
            link.slot = color;
        }
    }
}
