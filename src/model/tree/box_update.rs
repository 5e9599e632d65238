//! Updates of a collider's box.

use super::{BoxMargin, BroadPhaseBvh, TreeKind, shape_box};
use crate::dim::math::{Real, Vector};
use crate::model::body::RigidBody;
use crate::model::collider::{ActiveCollisionTypes, Collider, ColliderHandle};
use crate::model::params::IntegrationParameters;
use parry::bounding_volume::Aabb;

impl BroadPhaseBvh {
    /// Updates a collider's box after a motion of the collider. `body` is the one that it is attached to.
    /// Returns whether the fat AABB changed.
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
        self.note_filters(collider, body);
        let margin = margin_of(collider, body, params);
        let tight = shape_box(collider.shape(), &collider.pose);
        self.place(handle, &mut collider.proxy, kind_of(body), &tight, &margin)
    }

    /// Records the collider's groups, its sensor flag and its fixed-fixed type, so that no necessary search
    /// is skipped.
    pub(crate) fn note_filters(&mut self, collider: &Collider, body: Option<&RigidBody>) {
        self.note_sensor(collider.proxy.slot, collider.is_sensor());
        let groups = collider.collision_groups();
        self.groups = Some(self.groups.map_or(groups, |all| all.union(groups)));
        if kind_of(body) == TreeKind::Fixed {
            let types = collider.active_collision_types();
            self.fixed_meet |= types.intersects(ActiveCollisionTypes::FIXED_FIXED);
        }
    }
}

/// Update of the trees for a collider that its body has moved out of its box.
#[derive(Copy, Clone, Debug)]
pub(crate) enum MovedProxy {
    /// It left its box in this tree, and has a new one, with which the tree must be
    /// [updated](BroadPhaseBvh::put).
    LeftBox(TreeKind, Aabb),
    /// Possibly in the wrong tree, or in none: it must [follow](BroadPhaseBvh::follow).
    IsElsewhere,
}

/// Computes a new box for a collider that its body has moved out of its box. Returns `None` if the collider
/// is in its box, or must have none. The function reads no tree, so it can run in parallel.
pub(crate) fn update_moved_proxy(
    collider: &mut Collider,
    body: &RigidBody,
    params: &IntegrationParameters,
) -> Option<MovedProxy> {
    if !collider.is_enabled() {
        return collider.proxy.tree.map(|_| MovedProxy::IsElsewhere);
    }
    let kind = kind_of(Some(body));
    let tight = shape_box(collider.shape(), &collider.pose);
    let margin = margin_of(collider, Some(body), params);
    let needed = margin.needed(&tight).filter(|_| collider.proxy.tree == Some(kind));
    let Some(needed) = needed else { return Some(MovedProxy::IsElsewhere) };
    let is_new = collider.proxy.fit(kind, &needed, &margin);
    is_new.then_some(MovedProxy::LeftBox(kind, collider.proxy.fat_aabb))
}

fn kind_of(body: Option<&RigidBody>) -> TreeKind {
    TreeKind::of(body.map(RigidBody::body_type))
}

fn margin_of(
    collider: &Collider,
    body: Option<&RigidBody>,
    params: &IntegrationParameters,
) -> BoxMargin {
    let soft_ccd = body.map_or(0.0, |body| body.soft_ccd_prediction);
    BoxMargin {
        reach: reach(params, collider.contact_skin, soft_ccd),
        travel: body.map_or(Vector::ZERO, |body| body.vels.linvel * params.dt),
    }
}

/// One collider's contribution to the prediction distance.
fn reach(params: &IntegrationParameters, contact_skin: Real, soft_ccd: Real) -> Real {
    0.5 * params.prediction_distance() + contact_skin + soft_ccd
}
