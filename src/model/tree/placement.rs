//! Where a collider's box goes.

use super::{BoxMargin, BroadPhaseBvh, TreeKind, shape_box};
use crate::dim::math::{Real, Vector};
use crate::model::body::RigidBody;
use crate::model::collider::{ActiveCollisionTypes, Collider, ColliderHandle};
use crate::model::params::IntegrationParameters;

impl BroadPhaseBvh {
    /// Lets a collider's box follow the collider. `body` is the one that it is attached to. Returns whether
    /// the enlarged box changed.
    pub(crate) fn follow(
        &mut self,
        handle: ColliderHandle,
        collider: &mut Collider,
        body: Option<&RigidBody>,
        params: &IntegrationParameters,
    ) -> bool {
        if !collider.is_enabled() {
            return self.remove(handle.into_raw_parts().0, &mut collider.proxy);
        }
        self.note_wishes(collider, body);
        let margin = margin_of(collider, body, params);
        let tight = shape_box(collider.shape(), &collider.pose);
        self.place(handle, &mut collider.proxy, kind_of(body), &tight, &margin)
    }

    /// Takes in whom a collider may meet, so that no search is spared that might find somebody.
    pub(crate) fn note_wishes(&mut self, collider: &Collider, body: Option<&RigidBody>) {
        self.has_kinematics |= body.is_some_and(RigidBody::is_kinematic);
        self.has_sensors |= collider.is_sensor();
        let groups = collider.collision_groups();
        self.groups = Some(self.groups.map_or(groups, |all| all.union(groups)));
        if kind_of(body) == TreeKind::Fixed {
            let types = collider.active_collision_types();
            self.fixed_meet |= types.intersects(ActiveCollisionTypes::FIXED_FIXED);
        }
    }
}

/// Is a collider where the trees have it, wherever it was carried? If not, it must follow.
pub(crate) fn stays(
    collider: &mut Collider,
    body: Option<&RigidBody>,
    params: &IntegrationParameters,
) -> bool {
    if !collider.is_enabled() {
        return collider.proxy.tree.is_none();
    }
    let tight = shape_box(collider.shape(), &collider.pose);
    let needed = margin_of(collider, body, params).needed(&tight);
    needed.is_some_and(|needed| collider.proxy.keeps(kind_of(body), &needed))
}

fn kind_of(body: Option<&RigidBody>) -> TreeKind {
    let is_movable = body.is_some_and(|body| body.is_dynamic_or_kinematic());
    if is_movable { TreeKind::Movable } else { TreeKind::Fixed }
}

fn margin_of(
    collider: &Collider,
    body: Option<&RigidBody>,
    params: &IntegrationParameters,
) -> BoxMargin {
    let soft_ccd = body.map_or(0.0, |body| body.soft_ccd_prediction);
    BoxMargin {
        reach: reach(params, collider.contact_skin, soft_ccd),
        travel: body.map_or(Vector::ZERO, |body| body.linvel * params.dt),
    }
}

/// One collider's share of the distance at which contacts must be found.
fn reach(params: &IntegrationParameters, contact_skin: Real, soft_ccd: Real) -> Real {
    0.5 * params.prediction_distance() + contact_skin + soft_ccd
}
