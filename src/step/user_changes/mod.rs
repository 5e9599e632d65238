//! # User changes: edits since the last step
//!
//! Reads:   change lists of the sets
//! Writes:  bodies, colliders, trees, pairs, islands, the step's data of joints
//! Runs:    serial, in the order of the edits
//! Never:   visits anything that was neither edited nor touches an edited object
//!
//! Replacing a whole set edits everything in it: [`resync`] comes before everything else.
//!
//! Removals come first, because slots of removed bodies and colliders may be occupied again already.

mod bodies;
mod colliders;
mod joints;
mod moved;
mod multibodies;
mod removals;
mod resync;

pub(crate) use resync::{Resynced, resync_before_detection, resync_before_step};

use crate::model::body::{RigidBodyChanges, RigidBodyHandle};
use crate::model::collider::ColliderHandle;
use crate::model::event::{CollisionEvent, CollisionEventFlags};
use crate::model::joint::ImpulseJointSet;
use crate::model::multibody::MultibodyEdits;
use crate::model::params::IntegrationParameters;
use crate::model::structure::Structure;
use crate::model::tree::BroadPhaseBvh;
use colliders::Measured;

/// A body whose masses are summed up again, and whether a change of the sum wakes the body.
type MassNote = (RigidBodyHandle, bool);

/// All that an edit can affect.
pub(crate) struct UserChanges<'a> {
    pub structure: Structure<'a>,
    pub tree: &'a mut BroadPhaseBvh,
    pub joints: &'a ImpulseJointSet,
    pub multibodies: MultibodyEdits,
    pub params: &'a IntegrationParameters,
    pub events: &'a mut Vec<CollisionEvent>,
}

impl UserChanges<'_> {
    /// Applies all edits.
    pub fn run(mut self) {
        self.apply_replacements();
        self.apply_removals();
        let bodies = self.structure.bodies.take_modified();
        self.note_placed(&bodies);
        let colliders = self.structure.colliders.take_modified();
        let mut reweighed = Vec::new();
        for &handle in &bodies {
            self.reclassify(handle);
        }
        for &handle in &bodies {
            self.wake_left_behind(handle);
        }
        let mut measured = Measured::default();
        for &handle in &colliders {
            self.apply_collider(handle, &mut reweighed, &mut measured);
        }
        for &handle in &bodies {
            self.apply_body(handle, &mut reweighed);
        }
        for note in reweighed {
            self.reweigh(note);
        }
        self.apply_joints();
        self.apply_welds();
        self.apply_multibodies();
        self.apply_sleepers(&bodies);
    }

    /// Applies removals only. The next [`Self::run`] applies all other edits.
    pub fn run_removals(mut self) {
        self.note_placed(&[]);
        self.apply_replacements();
        self.apply_removals();
    }

    /// Notes the sleeping bodies that are new or were moved: their new contacts wake no body.
    fn note_placed(&mut self, modified: &[RigidBodyHandle]) {
        let Structure { bodies, islands, .. } = &mut self.structure;
        islands.placed_asleep.clear();
        let placed = RigidBodyChanges::KIND | RigidBodyChanges::POSITION;
        for &handle in modified {
            let body = bodies.get(handle).filter(|body| body.is_sleeping());
            if body.is_some_and(|body| body.changes.intersects(placed)) {
                islands.placed_asleep.insert(handle.into_raw_parts().0);
            }
        }
    }

    /// Replaced colliders become colliders of the bodies that they name, and replaced bodies get the
    /// colliders of the old ones. No collider is then in two lists, as threads that work on different bodies
    /// require.
    fn apply_replacements(&mut self) {
        let Structure { bodies, colliders, .. } = &mut self.structure;
        colliders.register_replaced(bodies);
        for handle in self.structure.bodies.register_replaced() {
            let attached = self.colliders_of(handle);
            if let Some(body) = self.structure.bodies.get_unnoted_mut(handle) {
                body.colliders = attached;
            }
        }
    }

    /// Notes, once, that a body's mass must be summed up again, and whether a change of it wakes the body.
    fn note_mass(&mut self, handle: RigidBodyHandle, wakes: bool, reweighed: &mut Vec<MassNote>) {
        let Some(body) = self.structure.bodies.get_unnoted_mut(handle) else { return };
        let noted = RigidBodyChanges::LOCAL_MASS_PROPERTIES | RigidBodyChanges::IN_MODIFIED_SET;
        if !body.changes.contains(noted) {
            body.changes.insert(noted);
            reweighed.push((handle, wakes));
        }
    }

    fn reweigh(&mut self, (handle, wakes): MassNote) {
        let Structure { bodies, colliders, .. } = &mut self.structure;
        let Some(body) = bodies.get_unnoted_mut(handle) else { return };
        let has_changed = body.sum_up_colliders(colliders);
        let is_new = body.changes.contains(RigidBodyChanges::ASSEMBLY);
        body.changes = RigidBodyChanges::empty();
        // Contact points are kept relative to the centre of mass.
        self.structure.refresh_pairs_of(handle);
        if wakes && has_changed && !is_new {
            self.structure.wake_body(handle);
        }
    }

    /// Puts a collider where its body is, and its box where the collider is.
    fn place(&mut self, handle: ColliderHandle) {
        let Structure { bodies, colliders, .. } = &mut self.structure;
        let Some(collider) = colliders.get_unnoted_mut(handle) else { return };
        let body = collider.parent().and_then(|parent| bodies.get(parent));
        if let (Some(body), Some(parent)) = (body, collider.parent) {
            collider.pose = body.pose * parent.pos_wrt_parent;
        }
        self.tree.follow(handle, collider, body, self.params);
        // Wherever its box was, it may be elsewhere now.
        colliders.note_box(handle);
    }

    /// Takes all pairs of a collider away. Touching bodies wake if `wake_up`.
    fn remove_pairs_of(
        &mut self,
        handle: ColliderHandle,
        wake_up: bool,
        flags: CollisionEventFlags,
    ) {
        let slot = handle.into_raw_parts().0;
        if wake_up {
            self.structure.wake_touching(slot);
        }
        while let Some(&id) = self.structure.narrow_phase.contacts.ids_of(slot).last() {
            let reported = self.structure.remove_contact_pair(id, wake_up);
            self.report_end(reported, flags);
        }
        while let Some(&id) = self.structure.narrow_phase.intersections.ids_of(slot).last() {
            let reported = self.structure.narrow_phase.intersections.remove(id);
            self.report_end(reported, flags | CollisionEventFlags::SENSOR);
        }
    }
}
