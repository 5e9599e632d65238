//! Colliders that are new or were edited.

use super::{MassNote, UserChanges};
use crate::collide::form_of;
use crate::model::body::RigidBodyHandle;
use crate::model::collider::{ColliderChanges, ColliderHandle, Widths, may_interact};
use crate::model::event::{CollisionEvent, CollisionEventFlags};
use parry::shape::SharedShape;
use std::sync::Arc;

/// The shape that was measured last. Colliders with one shape are mostly inserted in sequence, so a hull is
/// measured once for all.
#[derive(Default)]
pub(super) struct Measured {
    /// A reference keeps the shape alive, so no other shape gets its address.
    shape: Option<SharedShape>,
    widths: Option<Arc<[Widths]>>,
}

impl Measured {
    fn widths_of(&mut self, shape: &SharedShape) -> Option<Arc<[Widths]>> {
        if !self.shape.as_ref().is_some_and(|last| Arc::ptr_eq(&last.0, &shape.0)) {
            self.widths = Widths::of_costly(&**shape);
            self.shape = Some(shape.clone());
        }
        self.widths.clone()
    }
}

impl UserChanges<'_> {
    /// Follows a collider's changes.
    pub(super) fn apply_collider(
        &mut self,
        handle: ColliderHandle,
        reweighed: &mut Vec<MassNote>,
        measured: &mut Measured,
    ) {
        let Some(collider) = self.structure.colliders.get_unnoted_mut(handle) else { return };
        collider.replace_broken_shape();
        let changes = std::mem::take(&mut collider.changes);
        if changes.contains(ColliderChanges::SHAPE) {
            collider.form = form_of(&*collider.shape);
            collider.widths = measured.widths_of(&collider.shape);
        }
        let (parent, slot) = (collider.parent(), handle.into_raw_parts().0);
        let body = parent.and_then(|parent| self.structure.bodies.get(parent));
        self.tree.note_filters(collider, body);

        if changes.intersects(ColliderChanges::CONTACT_CHANGES) {
            self.structure.wake_touching(slot);
        }
        if changes.needs_broad_phase_update() {
            self.place(handle);
        }
        if changes.intersects(ColliderChanges::PARTNER_CHANGES) {
            self.drop_unfit_pairs(handle);
            self.tree.mark_moved(slot);
        }
        if changes.needs_narrow_phase_update() {
            self.structure.refresh_pairs(slot);
        }
        if let Some(parent) = parent {
            self.follow_mass(parent, changes, reweighed);
        }
    }

    /// Notes that the mass, the size or the warnings of a collider's body may have changed. The mass of a new
    /// collider is already part of the body's.
    fn follow_mass(
        &mut self,
        parent: RigidBodyHandle,
        changes: ColliderChanges,
        reweighed: &mut Vec<MassNote>,
    ) {
        let has_other_mass = changes.contains(ColliderChanges::LOCAL_MASS_PROPERTIES);
        if has_other_mass && let Some(body) = self.structure.bodies.get_unnoted_mut(parent) {
            body.end_assembly();
        }
        let others = ColliderChanges::PARENT
            | ColliderChanges::TYPE
            | ColliderChanges::ENABLED_OR_DISABLED
            | ColliderChanges::SHAPE
            | ColliderChanges::POSITION;
        if has_other_mass || changes.intersects(others) {
            self.note_mass(parent, has_other_mass, reweighed);
        }
    }

    /// Removes the pairs that may no longer interact, or that are of another kind or of other bodies now.
    ///
    /// Pairs are compared with the current state instead of the list of edits. An edit that was taken back
    /// before the step thus keeps the pairs, and sends no events.
    pub(super) fn drop_unfit_pairs(&mut self, handle: ColliderHandle) {
        let slot = handle.into_raw_parts().0;
        for id in self.structure.narrow_phase.contacts.ids_of(slot).to_vec() {
            let pair = &self.structure.narrow_phase.contacts[id];
            let bodies = self.structure.narrow_phase.contacts.bodies(id);
            if !self.fits([pair.collider1, pair.collider2], bodies, false) {
                if pair.is_touching() {
                    self.structure.wake_bodies_of(id);
                }
                let reported = self.structure.remove_contact_pair(id, true);
                self.report_end(reported, CollisionEventFlags::empty());
            }
        }
        for id in self.structure.narrow_phase.intersections.ids_of(slot).to_vec() {
            let pair = &self.structure.narrow_phase.intersections[id];
            let bodies = self.structure.narrow_phase.intersections.bodies(id);
            if !self.fits([pair.collider1, pair.collider2], bodies, true) {
                let reported = self.structure.narrow_phase.intersections.remove(id);
                self.report_end(reported, CollisionEventFlags::SENSOR);
            }
        }
    }

    /// Emits the end event of two colliders whose begin event was emitted.
    pub(super) fn report_end(
        &mut self,
        reported: Option<[ColliderHandle; 2]>,
        flags: CollisionEventFlags,
    ) {
        self.events.extend(reported.map(|[one, two]| CollisionEvent::Stopped(one, two, flags)));
    }

    /// Returns whether two colliders still have a pair of this kind, between these bodies.
    fn fits(&self, pair: [ColliderHandle; 2], bodies: [u32; 2], is_sensed: bool) -> bool {
        let colliders = &self.structure.colliders;
        match pair.map(|handle| colliders.get(handle)) {
            [Some(collider1), Some(collider2)] => {
                may_interact(collider1, collider2)
                    && (collider1.is_sensor() || collider2.is_sensor()) == is_sensed
                    && self.structure.parent_slots(pair) == bodies
            }
            _ => false,
        }
    }
}
