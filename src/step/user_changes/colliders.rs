//! Colliders that are new or were edited.

use super::UserChanges;
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
        reweighed: &mut Vec<RigidBodyHandle>,
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

        // A pair of another kind, or of other bodies, cannot be kept.
        let (identity, partner_changes) =
            (ColliderChanges::IDENTITY, ColliderChanges::PARTNER_CHANGES);
        if changes.intersects(identity) {
            self.remove_pairs_of(handle, true, CollisionEventFlags::empty());
        }
        if changes.needs_broad_phase_update() {
            self.structure.wake_touching(slot);
            self.place(handle);
        }
        if changes.intersects(partner_changes) {
            self.drop_forbidden_pairs(handle);
        }
        if changes.intersects(partner_changes | identity) {
            self.tree.mark_moved(slot);
        }
        if changes.needs_narrow_phase_update() {
            self.structure.refresh_pairs(slot);
        }
        let weight = identity
            | ColliderChanges::LOCAL_MASS_PROPERTIES
            | ColliderChanges::SHAPE
            | ColliderChanges::POSITION;
        if let (Some(parent), true) = (parent, changes.intersects(weight)) {
            self.note_mass(parent, reweighed);
        }
    }

    /// Removes the pairs that may no longer interact.
    pub(super) fn drop_forbidden_pairs(&mut self, handle: ColliderHandle) {
        let slot = handle.into_raw_parts().0;
        let contacts = self.structure.narrow_phase.contacts.ids_of(slot).to_vec();
        for id in contacts {
            let pair = &self.structure.narrow_phase.contacts[id];
            if !self.may_interact(pair.collider1, pair.collider2) {
                let reported = self.structure.remove_contact_pair(id, true);
                self.report_end(reported, CollisionEventFlags::empty());
            }
        }
        let intersections = self.structure.narrow_phase.intersections.ids_of(slot).to_vec();
        for id in intersections {
            let pair = &self.structure.narrow_phase.intersections[id];
            if !self.may_interact(pair.collider1, pair.collider2) {
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

    fn may_interact(&self, collider1: ColliderHandle, collider2: ColliderHandle) -> bool {
        let colliders = &self.structure.colliders;
        match (colliders.get(collider1), colliders.get(collider2)) {
            (Some(collider1), Some(collider2)) => may_interact(collider1, collider2),
            _ => false,
        }
    }
}
