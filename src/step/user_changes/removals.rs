//! Bodies and colliders that are gone.

use super::UserChanges;
use crate::model::body::{AttachedColliders, RigidBodyHandle};
use crate::model::event::CollisionEventFlags;

impl UserChanges<'_> {
    /// All colliders whose own records name the body as their parent.
    pub(super) fn colliders_of(&self, body: RigidBodyHandle) -> AttachedColliders {
        let colliders = self.structure.colliders.iter();
        let attached = colliders.filter(|(_, collider)| collider.parent() == Some(body));
        attached.map(|(handle, _)| handle).collect()
    }

    /// Removes bodies and colliders from all lists; the colliders and joints of removed bodies are removed,
    /// too.
    pub(super) fn apply_removals(&mut self) {
        let removed = self.structure.bodies.take_removed();
        let mut links = Vec::with_capacity(removed.len());
        for (handle, colliders, link) in removed {
            links.push((handle, link));
            for collider in colliders.unwrap_or_else(|| self.colliders_of(handle)) {
                // The user may have attached it to another body since.
                let set = &mut *self.structure.colliders;
                if set.get(collider).is_some_and(|collider| collider.parent() == Some(handle)) {
                    set.take(collider, true);
                }
            }
        }
        self.apply_removed_joints();
        self.structure.unregister_bodies(&mut links);
        for (handle, _) in links {
            self.structure.remove_joints_of(handle);
            self.structure.islands.groups.leave(handle.into_raw_parts().0);
        }
        for removed in self.structure.colliders.take_removed() {
            self.remove_pairs_of(removed.handle, removed.wake_up, CollisionEventFlags::REMOVED);
            self.tree.remove_slot(removed.handle.into_raw_parts().0);
        }
    }
}
