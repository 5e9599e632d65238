//! Loads point-to-point joints: once per step.

use super::super::load::is_gyroscopic;
use super::block::PointToPointBlock;
use crate::dim::math::{Pose, Real, Vector};
use crate::dim::state::READ_ONLY;
use crate::model::body::{RigidBody, RigidBodySet};
use crate::model::joint::ImpulseJoint;
use crate::model::params::JointPass;
use crate::step::solver::bodies::SolverBodies;

/// Fills one lane of a block.
pub(super) fn load_lane(
    block: &mut PointToPointBlock,
    lane: usize,
    joint: &ImpulseJoint,
    set: &RigidBodySet,
    bodies: &SolverBodies,
    pass: &JointPass,
) {
    let substep = pass.substep;
    let (handle1, handle2) = (joint.body1(), joint.body2());
    let (Some(body1), Some(body2)) = (set.get(handle1), set.get(handle2)) else { return };
    let (frame1, frame2) = (&joint.data.local_frame1, &joint.data.local_frame2);
    for (side, handle) in [handle1, handle2].into_iter().enumerate() {
        block.bodies[side][lane] = bodies.index_of(handle.into_raw_parts().0);
    }
    let arm1 = load_end(block, 0, lane, body1, frame1, substep);
    let arm2 = load_end(block, 1, lane, body2, frame2, substep);
    // Differences of positions first: far from the origin these have few digits.
    let separation = (body2.mprops.world_com - body1.mprops.world_com) + (arm2 - arm1);
    block.separation.set_lane(lane, separation);
    block.bias_scale.0[lane] = pass.bias_scale(separation);
    let frame = body1.position().rotation * frame1.rotation;
    block.frame.set_lane(lane, &frame);
    let fraction =
        bodies.impulse_fractions([block.bodies[0][lane], block.bodies[1][lane]]).of_joints;
    block.impulse.set_lane(lane, frame * Vector::from_slice(&joint.impulses) * fraction);
}

/// Fills a lane's data of one of its bodies; returns the moment arm.
fn load_end(
    block: &mut PointToPointBlock,
    side: usize,
    lane: usize,
    body: &RigidBody,
    frame: &Pose,
    substep: Real,
) -> Vector {
    let mprops = &body.mprops;
    if block.bodies[side][lane] & READ_ONLY == 0 {
        block.inv_mass[side].set_lane(lane, mprops.inv_mass);
        block.inertias.set_lane(side, lane, &mprops.inv_inertia, is_gyroscopic(body, substep));
    }
    let arm = body.position().rotation * (frame.translation - mprops.local_mprops.local_com);
    block.arms[side].set_lane(lane, arm);
    arm
}
