//! Bodies that the user moved. Bodies that touched them or were joined to them wake, because the support may
//! be gone. Bodies that moved along by the same motion stay asleep. A world can thus be moved back to the
//! origin without waking.

use super::UserChanges;
use crate::dim::math::{Pose, Real, ang_length_squared, rotation_to_angle};
use crate::model::body::{RigidBody, RigidBodyChanges, RigidBodyHandle};
use crate::model::island::NONE;

/// The poses of a body before and after the user's edit.
struct MovedBody {
    before: Pose,
    now: Pose,
}

impl UserChanges<'_> {
    /// Wakes the bodies that a moved body touched or was joined to, unless all of them moved along. Colliders
    /// must still be at their old poses.
    pub(super) fn wake_left_behind(&mut self, handle: RigidBodyHandle) {
        let slot = handle.into_raw_parts().0;
        let Some(body) = self.structure.bodies.get(handle) else { return };
        if body.changes.contains(RigidBodyChanges::POSITION) {
            let moved = self.moved_body(body);
            if !moved.is_some_and(|moved| self.partners_moved_along(slot, body, &moved)) {
                self.wake_touching(handle);
            }
        }
    }

    /// Returns whether all bodies that touch or are joined to a body moved along.
    fn partners_moved_along(&self, slot: u32, body: &RigidBody, moved: &MovedBody) -> bool {
        let contacts = &self.structure.narrow_phase.contacts;
        let pairs = body
            .colliders()
            .iter()
            .flat_map(|collider| contacts.ids_of(collider.into_raw_parts().0));
        let touching = pairs.filter(|&&id| contacts[id].is_touching());
        let partners =
            touching.flat_map(|&id| contacts.bodies(id)).filter(|&partner| partner != slot);
        let mut all_moved = partners.into_iter().all(|partner| self.moved_along(moved, partner));
        self.structure
            .for_each_joined(slot, |partner| all_moved &= self.moved_along(moved, partner));
        all_moved
    }

    /// Returns whether a body, or the world, has the same relative pose as before.
    fn moved_along(&self, moved: &MovedBody, partner: u32) -> bool {
        let other = match self.structure.bodies.at_slot(partner) {
            _ if partner == NONE => Some(MovedBody { before: Pose::IDENTITY, now: Pose::IDENTITY }),
            Some((_, body)) => self.moved_body(body),
            None => None,
        };
        other.is_some_and(|other| moved.has_same_relative_pose(&other))
    }

    /// The old and the new pose of a body. The old one follows from its colliders.
    fn moved_body(&self, body: &RigidBody) -> Option<MovedBody> {
        let now = body.pose;
        if !body.changes.contains(RigidBodyChanges::POSITION) {
            return Some(MovedBody { before: now, now });
        }
        let mut colliders =
            body.colliders().iter().filter_map(|&handle| self.structure.colliders.get(handle));
        let collider = colliders.find(|collider| collider.changes.is_empty())?;
        Some(MovedBody { before: collider.pose * collider.parent?.pos_wrt_parent.inverse(), now })
    }
}

impl MovedBody {
    /// Returns whether the relative pose is unchanged, within the rounding of distant positions.
    fn has_same_relative_pose(&self, other: &Self) -> bool {
        let before = self.before.inv_mul(&other.before);
        let now = self.now.inv_mul(&other.now);
        let places = [&self.before, &self.now, &other.before, &other.now];
        let far = places.map(|pose| pose.translation.length()).into_iter().fold(1.0, Real::max);
        let (shift_max, turn_max) = (4.0 * Real::EPSILON * far, 16.0 * Real::EPSILON);
        let rotvec = rotation_to_angle(&(before.rotation.inverse() * now.rotation));
        (now.translation - before.translation).length() <= shift_max
            && ang_length_squared(rotvec) <= turn_max * turn_max
    }
}
