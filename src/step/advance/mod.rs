//! # Advance — everything follows the bodies
//!
//! Reads:   poses of awake bodies, bounds of how far they moved
//! Writes:  poses and boxes of their colliders, sleep timers
//! Runs:    serial, in the order of the awake list
//! Never:   changes a velocity or the structure

use crate::dim::math::{Real, ang_length_squared};
use crate::model::body::{RigidBody, RigidBodySet};
use crate::model::collider::ColliderSet;
use crate::model::island::IslandManager;
use crate::model::params::IntegrationParameters;
use crate::model::tree::BroadPhaseBvh;

/// Lets colliders, boxes and sleep timers follow the awake bodies.
pub(crate) fn advance(
    bodies: &mut RigidBodySet,
    colliders: &mut ColliderSet,
    islands: &IslandManager,
    tree: &mut BroadPhaseBvh,
    params: &IntegrationParameters,
) {
    for &handle in &islands.awake {
        let motion = islands.motion_of(handle.into_raw_parts().0);
        let Some(body) = bodies.get_unnoted_mut(handle) else { continue };
        update_sleep_timer(body, params);
        if motion > 0.0 {
            carry_colliders(body, motion, colliders, tree, params);
        }
    }
}

fn carry_colliders(
    body: &RigidBody,
    motion: Real,
    colliders: &mut ColliderSet,
    tree: &mut BroadPhaseBvh,
    params: &IntegrationParameters,
) {
    for &handle in &body.colliders {
        let Some(collider) = colliders.get_unnoted_mut(handle) else { continue };
        let Some(parent) = collider.parent else { continue };
        collider.pose = body.pose * parent.pos_wrt_parent;
        collider.proxy.clearance -= motion;
        if collider.proxy.clearance < 0.0 && tree.follow(handle, collider, Some(body), params) {
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
