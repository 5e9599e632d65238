//! The step's access to multibodies, its notes of edits, and the check of a loaded set.

use super::{MultibodyEdits, MultibodyJointSet};
use crate::base::fault::{Fault, ensure};
use crate::base::loading::{Loaded, check_when_loaded};
use crate::model::body::{RigidBodyHandle, RigidBodySet};
use crate::model::island::BodyGroups;
use crate::model::multibody::{Multibody, MultibodyIndex, MultibodyLink};
use std::collections::BTreeSet;

impl MultibodyJointSet {
    /// A multibody for the step's own use: does not mark it as changed.
    pub(crate) fn get_unnoted_mut(&mut self, index: MultibodyIndex) -> Option<&mut Multibody> {
        self.multibodies.get_mut(index.0)
    }

    /// Upper bound of the positions of multibodies.
    pub(crate) fn index_bound(&self) -> u32 {
        self.multibodies.slot_count() as u32
    }

    /// The index of the multibody at a position; `None` at a vacant position.
    pub(crate) fn index_at(&self, position: u32) -> Option<MultibodyIndex> {
        self.multibodies.at_slot(position).map(|(index, _)| MultibodyIndex(index))
    }

    /// Removes joints whose bodies were removed, and returns the changes of the others since the last call.
    pub(crate) fn apply_changes(&mut self, bodies: &RigidBodySet) -> MultibodyEdits {
        for removed in bodies.removed() {
            self.remove_joints_attached_to_rigid_body(removed);
        }
        let mut next = 0;
        while let Some(&(index, _)) = self.modified.get(next) {
            if self.is_broken(index) {
                self.drop_broken(index);
            }
            let links = self.get_multibody(index).map_or(&[] as &[_], |multibody| &multibody.links);
            let missing: Vec<_> =
                links.iter().map(|link| link.body).filter(|&body| !bodies.contains(body)).collect();
            missing.into_iter().for_each(|body| self.remove_joints_attached_to_rigid_body(body));
            next += 1;
        }
        let edits = self.pending_changes(bodies);
        self.modified.clear();
        self.cut.clear();
        self.seen.clear();
        edits
    }

    /// The changes since the last step. They stay pending.
    ///
    /// Multibodies with replaced links or without one of their bodies are omitted: the next step removes
    /// them.
    pub(crate) fn pending_changes(&self, bodies: &RigidBodySet) -> MultibodyEdits {
        let is_there = |link: &MultibodyLink| bodies.contains(link.body);
        let groups = self.modified.iter().filter_map(|&(index, wake_up)| {
            let multibody = self.get_multibody(index).filter(|_| !self.is_broken(index))?;
            let has_changed = self.seen.get(&index).and_then(Option::as_ref) != Some(multibody);
            let wakes = wake_up && has_changed;
            multibody.links.iter().all(is_there).then(|| (multibody.members(), wakes))
        });
        let cut = self.cut.iter().copied().filter(|&(body, _)| bodies.contains(body));
        MultibodyEdits { cut: cut.collect(), groups: groups.collect() }
    }

    /// Marks all multibodies as new to the next step.
    pub(crate) fn begin_anew(&mut self) {
        self.cut.clear();
        self.seen.clear();
        let all = self.multibodies.iter().map(|(index, _)| (MultibodyIndex(index), true));
        self.modified = all.collect();
    }

    /// Checks that groups are the bodies of multibodies with their exclusions, unless these were edited
    /// since.
    pub(crate) fn check_groups(&self, groups: &BodyGroups) -> Result<(), Fault> {
        let edited: BTreeSet<_> = self.modified.iter().map(|(index, _)| *index).collect();
        for (index, multibody) in self.multibodies.iter() {
            let index = MultibodyIndex(index);
            if edited.contains(&index) {
                continue;
            }
            let members = multibody.members();
            ensure!(groups.has(&members), "the links of {index:?} are {members:?}");
        }
        self.check_grouped(groups)
    }

    /// Checks that the bodies of groups are links, unless they were cut since.
    pub(crate) fn check_grouped(&self, groups: &BodyGroups) -> Result<(), Fault> {
        let cut: BTreeSet<_> = self.cut.iter().map(|(body, _)| *body).collect();
        let is_link =
            |body: &RigidBodyHandle| self.rigid_body_link(*body).is_some() || cut.contains(body);
        let other = groups.bodies().find(|body| !is_link(body));
        ensure!(other.is_none(), "{other:?} is in a group, and no link");
        Ok(())
    }

    /// Checks that each multibody is a tree of at least two links, all of which the set finds by their bodies
    /// and joints. Allocates no memory.
    pub(crate) fn check_trees(&self) -> Result<(), Fault> {
        for (index, multibody) in self.multibodies.iter() {
            let index = MultibodyIndex(index);
            ensure!(
                !self.is_broken(index),
                "links of {index:?} differ from those in the lists of the set"
            );
            ensure!(multibody.num_links() > 1, "{index:?} is a single body");
            let is_joined = |link: &MultibodyLink| link.handle.is_some() == link.parent.is_some();
            ensure!(multibody.links.iter().all(is_joined), "{index:?} has a link without a joint");
            multibody.check_layout()?;
        }
        Ok(())
    }

    /// Marks a multibody as changed for the next step.
    pub(crate) fn note(&mut self, index: MultibodyIndex) {
        self.modified.push((index, false));
    }
}

check_when_loaded!(MultibodyJointSet);

/// Each link is found by its body and its joint, and nothing else is.
impl Loaded for MultibodyJointSet {
    fn check_loaded(&self) -> Result<(), Fault> {
        self.check_trees()?;
        let (mut links, mut joints) = (0, 0);
        for (_, multibody) in self.multibodies.iter() {
            links += multibody.num_links();
            joints += multibody.links.iter().filter(|link| link.handle.is_some()).count();
        }
        let filed = [self.of_body.len(), self.joints.len()];
        ensure!(
            filed == [links, joints],
            "{filed:?} of {links} links and {joints} joints are filed"
        );
        Ok(())
    }
}
