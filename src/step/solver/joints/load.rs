//! From joints to constraints: once per step.

use super::block::{AxisRow, JointBlock, UNLIMITED};
use crate::base::wide::Lane;
use crate::dim::joint::{FreeRotations, angle_about, couple_of};
use crate::dim::joint_axes::{JointAxesMask, JointAxis};
use crate::dim::math::{ANG_DIM, AngularInertia, DIM, Pose, Real, Rotation, Vector, zero_inertia};
use crate::dim::state::READ_ONLY;
use crate::dim::wide::{set_ang_lane, set_symmetric_lane};
use crate::model::body::{RigidBody, RigidBodySet};
use crate::model::joint::{
    GenericJoint, ImpulseJoint, JointLimits, MotorModel, mask_of, relative_rotation,
};
use crate::model::params::{JointPass, Softness};
use crate::step::solver::bodies::SolverBodies;

/// The least yield of joints that are solved in sweeps. A sweep leaves errors, and a chain that does not yield
/// to them is pumped by its own corrections: see
/// [`CONTACT_YIELD`](crate::model::params::CONTACT_YIELD).
const SWEPT_YIELD: Real = 1.0 / 8.0;

/// One end of a joint: the body as the solver knows it, and the joint's frame there.
struct End {
    index: u32,
    center: Vector,
    lever: Vector,
    frame: Rotation,
    inv_mass: Vector,
    inv_inertia: AngularInertia,
}

impl End {
    fn new(body: &RigidBody, slot: u32, frame: Pose, bodies: &SolverBodies) -> Self {
        let (pose, mprops) = (body.position(), &body.mprops);
        let index = bodies.index_of(slot);
        let movable = index & READ_ONLY == 0;
        Self {
            index,
            center: mprops.world_com,
            lever: pose.rotation * (frame.translation - mprops.local.local_com),
            frame: pose.rotation * frame.rotation,
            inv_mass: if movable { mprops.inv_mass } else { Vector::ZERO },
            inv_inertia: if movable { mprops.inv_inertia } else { zero_inertia() },
        }
    }
}

/// Fills one lane of a block, and of its rows.
pub(super) fn load_lane(
    block: &mut JointBlock,
    rows: &mut Vec<AxisRow>,
    lane: usize,
    joint: &mut ImpulseJoint,
    set: &RigidBodySet,
    bodies: &SolverBodies,
    pass: &JointPass,
) {
    let (body1, body2) = (joint.body1(), joint.body2());
    let (Some(first), Some(second)) = (set.get(body1), set.get(body2)) else { return };
    let frames = [joint.data.local_frame1, joint.data.local_frame2];
    let ends = [
        End::new(first, body1.into_raw_parts().0, frames[0], bodies),
        End::new(second, body2.into_raw_parts().0, frames[1], bodies),
    ];
    for (side, end) in ends.iter().enumerate() {
        block.bodies[side][lane] = end.index;
        block.inv_mass[side].set_lane(lane, end.inv_mass);
        set_symmetric_lane(&mut block.inv_inertia[side], lane, &end.inv_inertia);
        block.levers[side].set_lane(lane, end.lever);
        block.frames[side].set_lane(lane, &end.frame);
    }
    // Differences of positions first: far from the origin these have few digits.
    let separation = (ends[1].center - ends[0].center) + (ends[1].lever - ends[0].lever);
    block.separation.set_lane(lane, separation);
    let share = bodies.share([ends[0].index, ends[1].index]);
    joint.scale_impulses(share);
    load_locked(block, lane, joint, pass);
    let between = relative_rotation(&ends[0].frame, &ends[1].frame);
    load_rows(rows, block.first_row, lane, joint, &between, pass);
}

fn load_locked(block: &mut JointBlock, lane: usize, joint: &ImpulseJoint, pass: &JointPass) {
    let softness = match joint.data.softness {
        None => pass.softness,
        Some(spring) => {
            Softness::spring(spring.angular_frequency(), spring.damping_ratio, pass.substep)
        }
    };
    let is_spring = joint.data.softness.is_some();
    let yields = softness.yields().min(UNLIMITED);
    block.bias_rate.0[lane] = softness.bias_rate;
    block.is_spring.0[lane] = if is_spring { 1.0 } else { 0.0 };
    block.yields.0[lane] = if is_spring { yields } else { yields.max(SWEPT_YIELD) };
    block.swept.0[lane] = 1.0;
    for axis in JointAxis::ALL {
        let locked = joint.data.locked_axes.contains(mask_of(axis));
        block.locked[axis as usize].0[lane] = if locked { 1.0 } else { 0.0 };
        let starts = locked && (axis as usize) < DIM;
        let impulse = if starts { joint.impulses[axis as usize] } else { 0.0 };
        block.impulses[axis as usize].0[lane] = impulse;
    }
    set_ang_lane(&mut block.couple, lane, couple_of(&joint.impulses));
}

/// Fills one lane of the rows that begin at `first`; adds rows if there are too few.
fn load_rows(
    rows: &mut Vec<AxisRow>,
    first: usize,
    lane: usize,
    joint: &mut ImpulseJoint,
    between: &Rotation,
    pass: &JointPass,
) {
    let mut angles = [0.0; ANG_DIM];
    for (at, axis) in (first..).zip(joint.data.driven_axes()) {
        if at == rows.len() {
            rows.push(AxisRow::EMPTY);
        }
        let row = &mut rows[at];
        match (axis as usize).checked_sub(DIM) {
            None => load_translation(row, lane, &joint.data, axis),
            Some(k) => {
                let last = joint.angles.map(|angles| angles[k]);
                angles[k] = load_rotation(row, lane, &joint.data, axis, between, last);
            }
        }
        load_drive(row, lane, &joint.data, axis, pass);
    }
    joint.angles = Some(angles);
}

fn load_translation(row: &mut AxisRow, lane: usize, joint: &GenericJoint, axis: JointAxis) {
    let mut direction = Vector::ZERO;
    direction[axis as usize] = 1.0;
    row.linear.set_lane(lane, direction);
    let coupled = joint.coupled_axes & !joint.locked_axes & JointAxesMask::LIN_AXES;
    for other in &JointAxis::ALL[..DIM] {
        let together = coupled.contains(mask_of(axis)) && coupled.contains(mask_of(*other));
        row.coupled[*other as usize].0[lane] = if together { 1.0 } else { 0.0 };
    }
}

/// Returns the angle, with all turns since the joint was first seen.
fn load_rotation(
    row: &mut AxisRow,
    lane: usize,
    joint: &GenericJoint,
    axis: JointAxis,
    between: &Rotation,
    last: Option<Real>,
) -> Real {
    let rotations = FreeRotations::new(!joint.locked_axes, joint.coupled_axes);
    let (angle, direction) = angle_about(axis, rotations, between);
    let angle = match last {
        Some(last) if rotations.is_single() => nearest_turn(angle, last),
        _ => angle,
    };
    set_ang_lane(&mut row.angular, lane, direction);
    row.angle.0[lane] = angle;
    angle
}

/// The angle plus that number of turns that brings it nearest to the last one.
fn nearest_turn(angle: Real, last: Real) -> Real {
    const TURN: Real = 2.0 * core::f64::consts::PI as Real;
    let turns = ((last - angle) / TURN).round();
    if turns.is_finite() { angle + turns * TURN } else { angle }
}

fn load_drive(
    row: &mut AxisRow,
    lane: usize,
    joint: &GenericJoint,
    axis: JointAxis,
    pass: &JointPass,
) {
    let set = |target: &mut Lane, value: Real| target.0[lane] = value.clamp(-UNLIMITED, UNLIMITED);
    if let Some(motor) = joint.motor(axis) {
        let per_mass = motor.model == MotorModel::AccelerationBased;
        set(&mut row.motor.stiffness, motor.stiffness);
        set(&mut row.motor.damping, motor.damping);
        set(&mut row.motor.per_mass, if per_mass { 1.0 } else { 0.0 });
        set(&mut row.motor.target_pos, motor.target_pos);
        set(&mut row.motor.target_vel, motor.target_vel);
        set(&mut row.motor.max_impulse, (motor.max_force * pass.substep).min(UNLIMITED));
        set(&mut row.motor.impulse, motor.impulse);
    }
    if let Some(JointLimits { min, max, impulse }) = joint.limits(axis).copied() {
        // A distance is never less than zero, nor is the angle of a swing: a limit there would only stop what
        // passes through.
        let has_sign = !joint.is_measured_together(axis);
        let min = if has_sign || min > 0.0 { min } else { -UNLIMITED };
        set(&mut row.min, min);
        set(&mut row.max, max);
        set(&mut row.lower, impulse.max(0.0));
        set(&mut row.upper, (-impulse).max(0.0));
    }
}
