//! Test of whether two colliders can interact.

use super::Collider;
use crate::model::body::RigidBodyType;

/// Returns whether the two colliders can interact at any pose.
///
/// False if they belong to the same body, or if one is disabled. Also false if neither accepts the other's
/// body type, or if their groups do not interact. A collider without a body counts as fixed.
pub(crate) fn may_interact(collider1: &Collider, collider2: &Collider) -> bool {
    let (flags1, flags2) = (&collider1.flags, &collider2.flags);
    if let (Some(body1), Some(body2)) = (collider1.parent(), collider2.parent())
        && body1 == body2
    {
        return false;
    }
    let type1 = collider1.parent_type.unwrap_or(RigidBodyType::Fixed);
    let type2 = collider2.parent_type.unwrap_or(RigidBodyType::Fixed);
    (flags1.active_collision_types | flags2.active_collision_types).test(type1, type2)
        && flags1.collision_groups.test(flags2.collision_groups)
        && collider1.is_enabled()
        && collider2.is_enabled()
}
