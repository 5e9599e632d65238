//! # Finalize bodies: colliders, boxes and sleep timers follow the bodies
//!
//! Reads:   poses of awake bodies, bounds on their motion
//! Writes:  poses and boxes of their colliders, sleep timers; notes of bodies that may sleep
//! Runs:    parallel over awake bodies; new boxes are inserted into the trees in the order of the bodies
//! Never:   changes a velocity or the structure

mod sleep_timer;

use crate::base::arena::SharedArena;
use crate::base::disjoint::DisjointMut;
use crate::base::tasks::{Gather, Tasks};
use crate::base::wide::PREFETCH_DISTANCE;
use crate::dim::math::Real;
use crate::model::body::{RigidBody, RigidBodySet};
use crate::model::collider::{Collider, ColliderHandle, ColliderSet};
use crate::model::frozen::Frozen;
use crate::model::island::IslandManager;
use crate::model::params::IntegrationParameters;
use crate::model::tree::{BroadPhaseBvh, MovedProxy, update_moved_proxy};
use sleep_timer::update_sleep_timer;

/// Buffers that are reused from step to step.
#[derive(Default)]
pub(crate) struct FinalizeScratch {
    /// Colliders whose trees must be updated.
    moved: Vec<MovedCollider>,
    gather: Gather<MovedCollider>,
}

/// A collider that is not in its box any more, or has none.
type MovedCollider = (ColliderHandle, MovedProxy);

/// Context of the stage.
pub(crate) struct FinalizeContext<'a> {
    pub tasks: Tasks<'a>,
    pub params: &'a IntegrationParameters,
    pub bodies: Frozen<'a, RigidBodySet>,
    pub colliders: Frozen<'a, ColliderSet>,
    pub islands: &'a IslandManager,
    pub tree: &'a mut BroadPhaseBvh,
}

/// Updates colliders, boxes and sleep timers of the awake bodies, and notes the bodies that may sleep.
pub(crate) fn finalize_bodies(
    context: FinalizeContext<'_>,
    FinalizeScratch { moved, gather }: &mut FinalizeScratch,
    sleepy: &mut Vec<bool>,
) {
    let FinalizeContext { tasks, params, mut bodies, mut colliders, islands, tree } = context;
    let awake = &*islands.awake;
    moved.clear();
    sleepy.clear();
    sleepy.resize(awake.len(), false);
    let (all_colliders, sleepy) = (colliders.share(), DisjointMut::new(sleepy));
    let follow_body =
        |position: usize, body: Option<&mut RigidBody>, left: &mut Vec<MovedCollider>| {
            let Some(body) = body else { return };
            let motion = islands.motion_of(awake[position].into_raw_parts().0).bound();
            let may_sleep = update_sleep_timer(body, motion, params);
            // SAFETY: each position is one body's.
            unsafe { *sleepy.get_mut(position) = may_sleep };
            if motion > 0.0 {
                // SAFETY: each collider has one body, and each body has one position.
                unsafe { update_colliders(body, motion, &all_colliders, params, left) };
            }
        };
    // SAFETY: the list names each body once.
    unsafe { bodies.visit_gathering(awake, tasks, gather, follow_body, moved) };
    for (index, (handle, moved_proxy)) in moved.iter().enumerate() {
        if let Some((later, MovedProxy::LeftBox(kind, _))) = moved.get(index + PREFETCH_DISTANCE) {
            tree.prefetch(*later, *kind);
        }
        follow(*handle, moved_proxy, &bodies, &mut colliders, tree, params);
    }
}

/// Updates the poses of a body's colliders, and lists the colliders that left their fat AABB.
///
/// # Safety
/// The caller has exclusive access to the colliders of the body.
unsafe fn update_colliders(
    body: &RigidBody,
    motion: Real,
    colliders: &SharedArena<'_, Collider>,
    params: &IntegrationParameters,
    left: &mut Vec<MovedCollider>,
) {
    for &handle in &body.colliders {
        // SAFETY: the caller's promise.
        let Some(collider) = (unsafe { colliders.get_mut(handle.0) }) else { continue };
        let Some(parent) = collider.parent else { continue };
        collider.pose = body.pose * parent.pos_wrt_parent;
        collider.proxy.clearance -= motion;
        if collider.proxy.clearance < 0.0 {
            left.extend(
                update_moved_proxy(collider, body, params).map(|moved_proxy| (handle, moved_proxy)),
            );
        }
    }
}

/// Inserts or updates a collider in the trees.
fn follow(
    handle: ColliderHandle,
    moved_proxy: &MovedProxy,
    bodies: &RigidBodySet,
    colliders: &mut Frozen<'_, ColliderSet>,
    tree: &mut BroadPhaseBvh,
    params: &IntegrationParameters,
) {
    let is_elsewhere = match moved_proxy {
        MovedProxy::LeftBox(kind, aabb) => {
            tree.put(handle, *kind, aabb);
            true
        }
        MovedProxy::IsElsewhere => {
            let Some(collider) = colliders.get_unnoted_mut(handle) else { return };
            let body = collider.parent().and_then(|parent| bodies.get(parent));
            tree.follow(handle, collider, body, params)
        }
    };
    if is_elsewhere {
        colliders.note_box(handle);
    }
}
