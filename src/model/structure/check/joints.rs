//! Joints that the step has applied.

use super::colors::Colors;
use super::last_step::LastStep;
use super::{Depth, Structure, Verdict};
use crate::base::fault::ensure;
use crate::model::joint::{ImpulseJointSet, JointLink};

impl Structure<'_> {
    /// The bodies of an active joint are in one island, and it has a colour while one of them is awake.
    pub(super) fn check_joints(&self, then: &LastStep<'_>, depth: Depth) -> Verdict {
        self.islands.joints.check()?;
        let mut colors = Colors::of(&self.islands.joint_graph, depth)?;
        for (slot, link) in self.islands.joints.iter() {
            let slots = link.body_slots();
            let are_there = slots.iter().all(|&body| then.has_slot(body));
            ensure!(are_there, "joint {slot} is of bodies {slots:?}");
            let dynamic = then.dynamic(slots);
            if let ([Some(slot1), Some(slot2)], true) = (dynamic, link.attached) {
                let islands = [slot1, slot2].map(|slot| then.link(slot).island);
                ensure!(islands[0] == islands[1], "joint {slot} is of islands {islands:?}");
            }
            let is_solved =
                link.attached && dynamic.iter().flatten().any(|&body| then.is_awake(body));
            colors.check(slot, link.slot, is_solved, slots, then)?;
        }
        let are_dynamic =
            |link: &JointLink| then.dynamic(link.body_slots()).iter().all(Option::is_some);
        let joints = &self.islands.joints;
        let groups = joints.groups_of_welds(are_dynamic);
        let slot = joints.weld_groups().differing(&groups).next();
        ensure!(
            joints.welds_changed || slot.is_none(),
            "body {slot:?} is in a wrong group of welds"
        );
        colors.finish()
    }

    /// The applied joints are those of a set, unless they were edited or removed since.
    pub(super) fn check_known_joints(&self, joints: &ImpulseJointSet) -> Verdict {
        joints.check_notes()?;
        let are_of = self.islands.joints.are_of(joints, self.bodies);
        ensure!(are_of, "the registered joints differ from the joints of the set");
        for (slot, link) in self.islands.joints.iter() {
            let Some(joint) = joints.get(link.handle) else { continue };
            ensure!(joint.is_sound(), "joint {slot} has invalid impulses: {joint:?}");
        }
        Ok(())
    }
}
