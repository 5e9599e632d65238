//! # Advance — everything follows the bodies
//!
//! Reads:   poses of awake bodies, bounds of how far they moved
//! Writes:  poses and boxes of their colliders, sleep timers
//! Runs:    parallel over awake bodies; what leaves its box is put into the trees in their order
//! Never:   changes a velocity or the structure

use crate::base::arena::SharedArena;
use crate::base::disjoint::DisjointMut;
use crate::base::tasks::Tasks;
use crate::dim::math::{Real, ang_length_squared};
use crate::model::body::{RigidBody, RigidBodySet};
use crate::model::collider::{Collider, ColliderSet};
use crate::model::island::IslandManager;
use crate::model::params::IntegrationParameters;
use crate::model::tree::{self, BroadPhaseBvh};

/// Buffers that are reused from step to step.
#[derive(Default)]
pub(crate) struct AdvanceScratch {
    /// By awake body: has one of its colliders left its box?
    leavers: Vec<bool>,
}

/// Lets colliders, boxes and sleep timers follow the awake bodies.
pub(crate) fn advance(
    tasks: Tasks<'_>,
    bodies: &mut RigidBodySet,
    colliders: &mut ColliderSet,
    islands: &IslandManager,
    tree: &mut BroadPhaseBvh,
    params: &IntegrationParameters,
    AdvanceScratch { leavers }: &mut AdvanceScratch,
) {
    let awake = islands.awake.as_slice();
    leavers.clear();
    leavers.resize(awake.len(), false);
    let (all_colliders, leaves) = (colliders.share(), DisjointMut::new(leavers));
    let carry = |position: usize, body: Option<&mut RigidBody>| {
        let Some(body) = body else { return };
        update_sleep_timer(body, params);
        let motion = islands.motion_of(awake[position].into_raw_parts().0).bound();
        // SAFETY: each collider has one body, and each body a place.
        unsafe {
            *leaves.get_mut(position) =
                motion > 0.0 && carry_colliders(body, motion, &all_colliders, params);
        }
    };
    // SAFETY: the list names each body once.
    unsafe { bodies.visit(awake, tasks, carry) };
    let left = awake.iter().zip(&*leavers).filter(|(_, leaves)| **leaves);
    for body in left.filter_map(|(&handle, _)| bodies.get(handle)) {
        follow(body, colliders, tree, params);
    }
}

/// Puts a body's colliders where they are now. Returns whether one of them has left its box.
///
/// # Safety
/// Nobody else may use the colliders of the body meanwhile.
unsafe fn carry_colliders(
    body: &RigidBody,
    motion: Real,
    colliders: &SharedArena<'_, Collider>,
    params: &IntegrationParameters,
) -> bool {
    let mut leaves = false;
    for handle in &body.colliders {
        // SAFETY: the caller's promise.
        let Some(collider) = (unsafe { colliders.get_mut(handle.0) }) else { continue };
        let Some(parent) = collider.parent else { continue };
        collider.pose = body.pose * parent.pos_wrt_parent;
        collider.proxy.clearance -= motion;
        leaves |= collider.proxy.clearance < 0.0 && !tree::stays(collider, Some(body), params);
    }
    leaves
}

/// Gives new boxes to those of a body's colliders that have left theirs.
fn follow(
    body: &RigidBody,
    colliders: &mut ColliderSet,
    tree: &mut BroadPhaseBvh,
    params: &IntegrationParameters,
) {
    for &handle in &body.colliders {
        let Some(collider) = colliders.get_unnoted_mut(handle) else { continue };
        let leaves = collider.parent.is_some() && collider.proxy.clearance < 0.0;
        if leaves && tree.follow(handle, collider, Some(body), params) {
            colliders.note_box(handle);
        }
    }
}

/// A body that is slower than its thresholds gets sleepier by `dt`; any other is wide awake.
fn update_sleep_timer(body: &mut RigidBody, params: &IntegrationParameters) {
    let activation = &mut body.activation;
    let linear = activation.normalized_linear_threshold * params.length_unit;
    let angular = activation.angular_threshold;
    // A negative threshold says that the body never sleeps.
    let still = if body.body_type.is_kinematic() {
        linear >= 0.0
            && body.linvel.length_squared() == 0.0
            && ang_length_squared(body.angvel) == 0.0
    } else {
        linear >= 0.0
            && angular >= 0.0
            && body.linvel.length_squared() < linear * linear
            && ang_length_squared(body.angvel) < angular * angular
    };
    if still {
        activation.time_since_can_sleep += params.dt;
    } else {
        activation.time_since_can_sleep = 0.0;
    }
}
