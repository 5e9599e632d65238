//! Joints in Box3D.
//!
//! Joints of Box3D rotate about the Z axis of their frames; joints of this engine and of Rapier rotate about
//! X. The cone of a ball joint is about the same axis.

use super::super::ours::prelude::*;
use super::{Unsupported, quaternion, vector};
use box3d_sys::*;
use std::f32::consts::FRAC_PI_2;

/// Creates hinges and ball joints with their limits: no scene here has other joints, motors or springs.
pub(super) fn create(
    world: b3WorldId,
    bodies: [b3BodyId; 2],
    joint: &GenericJoint,
) -> Result<(), Unsupported> {
    let unknown = Err(Unsupported::because("a joint is not transcribed"));
    if !joint.motor_axes.is_empty() || joint.softness.is_some() {
        return unknown;
    }
    match joint.locked_axes {
        JointAxesMask::LOCKED_REVOLUTE_AXES => create_hinge(world, bodies, joint),
        JointAxesMask::LOCKED_SPHERICAL_AXES if has_cone_or_nothing(joint) => {
            create_socket(world, bodies, joint);
        }
        _ => return unknown,
    }
    Ok(())
}

/// Returns whether the swing of a ball joint has one cone as its limit, or no limit.
fn has_cone_or_nothing(joint: &GenericJoint) -> bool {
    let swings = JointAxesMask::ANG_Y | JointAxesMask::ANG_Z;
    joint.coupled_axes == swings || !joint.limit_axes.intersects(swings)
}

fn create_hinge(world: b3WorldId, bodies: [b3BodyId; 2], joint: &GenericJoint) {
    // SAFETY: the calls take and return plain values. The definition outlives them. The world and the bodies
    // are live.
    unsafe {
        let mut definition = b3DefaultRevoluteJointDef();
        fill_base(&mut definition.base, bodies, joint);
        if let Some(limits) = joint.limits(JointAxis::AngX) {
            definition.enableLimit = true;
            (definition.lowerAngle, definition.upperAngle) = (limits.min, limits.max);
        }
        b3CreateRevoluteJoint(world, &definition);
    }
}

fn create_socket(world: b3WorldId, bodies: [b3BodyId; 2], joint: &GenericJoint) {
    // SAFETY: as above.
    unsafe {
        let mut definition = b3DefaultSphericalJointDef();
        fill_base(&mut definition.base, bodies, joint);
        if let Some(limits) = joint.limits(JointAxis::AngY) {
            definition.enableConeLimit = true;
            definition.coneAngle = limits.max;
        }
        if let Some(limits) = joint.limits(JointAxis::AngX) {
            definition.enableTwistLimit = true;
            (definition.lowerTwistAngle, definition.upperTwistAngle) = (limits.min, limits.max);
        }
        b3CreateSphericalJoint(world, &definition);
    }
}

fn fill_base(base: &mut b3JointDef, bodies: [b3BodyId; 2], joint: &GenericJoint) {
    [base.bodyIdA, base.bodyIdB] = bodies;
    base.localFrameA = frame(&joint.local_frame1);
    base.localFrameB = frame(&joint.local_frame2);
    base.collideConnected = joint.contacts_enabled;
}

/// Returns the frame with its Z axis along this one's X axis.
fn frame(pose: &Pose) -> b3Transform {
    let turned = pose.rotation * Rotation::from_rotation_y(FRAC_PI_2);
    b3Transform { p: vector(pose.translation), q: quaternion(&turned) }
}
