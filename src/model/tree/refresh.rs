//! Keeping the trees in agreement with the colliders.

use super::{BoxMargin, BroadPhaseBvh, TreeKind, shape_box};
use crate::dim::math::{Real, Vector};
use crate::model::body::RigidBodyType;
use crate::model::collider::{ActiveCollisionTypes, Collider, ColliderHandle};

impl TreeKind {
    /// The tree in which a collider belongs.
    pub(crate) fn of(collider: &Collider) -> Self {
        match collider.parent_type {
            None | Some(RigidBodyType::Fixed) => Self::Fixed,
            Some(_) => Self::Movable,
        }
    }
}

impl BroadPhaseBvh {
    /// Gives a collider its place, after anything about it changed: pose, shape, body type, whether
    /// it is enabled. Returns whether its enlarged box changed.
    ///
    /// `reach` is half the distance at which contacts must be found (length units), `travel` the
    /// motion expected during the next step in world space.
    pub(crate) fn refresh(
        &mut self,
        handle: ColliderHandle,
        collider: &mut Collider,
        reach: Real,
        travel: Vector,
    ) -> bool {
        if !collider.is_enabled() {
            return self.remove(handle.into_raw_parts().0, &mut collider.proxy);
        }
        let kind = TreeKind::of(collider);
        if kind == TreeKind::Fixed {
            let types = collider.flags.active_collision_types;
            self.fixed_meet |= types.intersects(ActiveCollisionTypes::FIXED_FIXED);
        }
        let tight = shape_box(&*collider.shape, &collider.pose);
        let margin = BoxMargin { reach: reach + collider.contact_skin, travel };
        self.place(handle, &mut collider.proxy, kind, &tight, &margin)
    }

    /// The same after a motion of the collider alone, which took none of its points farther than
    /// `moved` (length units): most often the box need not even be looked at.
    #[inline]
    pub(crate) fn advance(
        &mut self,
        handle: ColliderHandle,
        collider: &mut Collider,
        moved: Real,
        reach: Real,
        travel: Vector,
    ) -> bool {
        collider.proxy.clearance -= moved;
        // A motion that is not a number goes on, and the box is found out not to be finite.
        if collider.proxy.clearance > 0.0 {
            return false;
        }
        self.refresh(handle, collider, reach, travel)
    }
}
