//! Bodies in the list of awake bodies, in islands and in groups, and their colliders.

use super::last_step::LastStep;
use super::{Depth, Structure, Verdict};
use crate::base::fault::ensure;
use crate::model::body::{RigidBody, RigidBodyChanges};
use crate::model::collider::ColliderEnabled;
use crate::model::island::NONE;
use crate::model::multibody::MultibodyJointSet;
use std::collections::BTreeSet;

impl Structure<'_> {
    /// Each awake body is listed once, at the position in its link; kinematic ones first.
    pub(super) fn check_awake(&self, then: &LastStep<'_>, depth: Depth) -> Verdict {
        let awake = &self.islands.awake;
        ensure!(awake.is_divided(), "more kinematic bodies are awake than bodies");
        let kinematic = awake.kinematic().len();
        let mut count = 0;
        for (handle, link) in then.listed().filter(|(_, link)| link.awake != NONE) {
            let listed = awake.get(link.awake as usize);
            ensure!(listed == Some(&handle), "{listed:?} is awake in place of {handle:?}");
            let is_kinematic = (link.awake as usize) < kinematic;
            ensure!((link.island == NONE) == is_kinematic, "{handle:?} is kinematic: {link:?}");
            count += 1;
        }
        ensure!(count == awake.len(), "{count} of {} awake bodies are there", awake.len());
        for slot in 0..self.bodies.slot_count() as u32 {
            // Pairs compare the motions of their two bodies.
            let moved = self.islands.motion_of(slot).bound();
            let is_still = moved == 0.0 || then.is_awake(slot);
            ensure!(is_still, "the body in slot {slot} has moved by {moved}");
            let is_known = depth == Depth::Quick || moved.is_finite() && moved >= 0.0;
            ensure!(is_known, "the body in slot {slot} has moved by {moved}");
        }
        Ok(())
    }

    /// Each dynamic body is in one island, at the position in its link, and sleeps if its island does.
    pub(super) fn check_islands(&self, then: &LastStep<'_>) -> Verdict {
        let bound = self.islands.island_bound();
        let mut members = 0;
        for (handle, link) in then.listed().filter(|(_, link)| link.island != NONE) {
            ensure!(link.island < bound, "{handle:?} is in island {} of {bound}", link.island);
            let island = self.islands.island(link.island);
            let listed = island.bodies.get(link.island_position as usize);
            ensure!(listed == Some(&handle), "{listed:?} is in an island in place of {handle:?}");
            ensure!(island.sleeping == (link.awake == NONE), "{handle:?} sleeps as its island");
            members += 1;
        }
        let listed: usize = (0..bound).map(|id| self.islands.island(id).bodies.len()).sum();
        ensure!(listed == members, "islands list {listed} bodies of {members}");
        Ok(())
    }

    /// Bodies are in the lists for their type, unless the user changed the type.
    pub(super) fn check_body_types(&self) -> Verdict {
        for (handle, body) in self.bodies.iter().filter(|(_, body)| is_as_before(body)) {
            let link = body.link;
            let is_member = body.is_enabled() && body.is_dynamic();
            ensure!(is_member == (link.island != NONE), "{handle:?} is in island {}", link.island);
            let may_move = body.is_enabled() && !body.is_fixed();
            ensure!(may_move || link.awake == NONE, "{handle:?} cannot move and is awake");
            let is_edited = body.changes.contains(RigidBodyChanges::IN_MODIFIED_SET);
            let agrees = !may_move || body.activation.sleeping == (link.awake == NONE);
            ensure!(is_edited || agrees, "{handle:?} sleeps: {}", body.activation.sleeping);
        }
        self.bodies.check_notes()
    }

    /// Each collider is in the list of its parent body, and in no other.
    pub(super) fn check_attachments(&self, then: &LastStep<'_>) -> Verdict {
        let mut listed = BTreeSet::new();
        for (handle, body) in self.bodies.iter() {
            for collider in &body.colliders {
                let parent = self.colliders.get(*collider).and_then(|collider| collider.parent());
                ensure!(parent == Some(handle), "{collider:?} of {handle:?} is part of {parent:?}");
                ensure!(listed.insert(*collider), "{handle:?} lists {collider:?} twice");
            }
        }
        let mut attached = 0;
        for (handle, collider) in self.colliders.iter() {
            let Some(parent) = collider.parent() else {
                let known = collider.parent_type;
                ensure!(known.is_none(), "{handle:?} without a body is part of a {known:?} one");
                continue;
            };
            let body = self.bodies.get(parent);
            ensure!(
                body.is_some() || then.goes_with(parent, handle),
                "{handle:?} is part of no body"
            );
            attached += usize::from(body.is_some());
            let agrees = body.filter(|body| is_as_before(body)).is_none_or(|body| {
                collider.parent_type == Some(body.body_type())
                    && (collider.flags.enabled != ColliderEnabled::DisabledByParent
                        || !body.is_enabled())
            });
            ensure!(agrees, "{handle:?} stores another type or state of {parent:?}");
        }
        let listed = listed.len();
        ensure!(listed == attached, "bodies list {listed} of {attached} colliders");
        self.colliders.check_notes()
    }

    /// The bodies of a group are links of one multibody, in one island.
    pub(super) fn check_groups(
        &self,
        then: &LastStep<'_>,
        multibodies: Option<&MultibodyJointSet>,
    ) -> Verdict {
        self.islands.groups.check()?;
        for group in self.islands.groups.iter() {
            let slots = group.iter().map(|body| body.into_raw_parts().0);
            let islands = slots.map(|slot| then.link(slot).island).filter(|&island| island != NONE);
            let mut islands: Vec<_> = islands.collect();
            islands.dedup();
            ensure!(islands.len() < 2, "the links {group:?} are in islands {islands:?}");
        }
        multibodies.map_or(Ok(()), |set| set.check_groups(&self.islands.groups))
    }
}

/// Returns whether the lists of the last step still apply to a body: neither its type nor its enabled state
/// was edited.
fn is_as_before(body: &RigidBody) -> bool {
    !body.changes.intersects(RigidBodyChanges::KIND)
}
