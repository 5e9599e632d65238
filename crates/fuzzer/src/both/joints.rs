//! Operations on joints.

use super::dim::{AXES, joint};
use super::play::{JOINTS_MAX, Play};
use super::rapier::prelude::*;
use super::values::{some_pose, some_real, some_vector};
use crate::choices::Choices;

/// Returns a joint of any kind, with limits and motors.
pub fn some_joint(choices: &mut Choices<'_>) -> GenericJoint {
    let mut joint = joint(choices);
    joint.set_local_anchor1(some_vector(choices, 1.0));
    joint.set_local_anchor2(some_vector(choices, 1.0));
    for _ in 0..choices.below(3) {
        change(&mut joint, choices);
    }
    joint
}

/// Inserts or removes a joint.
pub fn insert_or_remove(play: &mut Play<'_>) {
    let (body1, body2, handle) = (play.body(), play.body(), play.joint());
    let joints = &mut play.world.impulse_joints;
    let choices = &mut play.choices;
    if choices.once_in(3) || joints.len() >= JOINTS_MAX {
        let existed = joints.contains(handle);
        assert_eq!(joints.remove(handle, choices.coin()).is_some(), existed);
        assert!(joints.remove(handle, true).is_none(), "{handle:?} was removed twice");
        return;
    }
    match choices.below(8) {
        0 => drop(joints.remove_joints_attached_to_rigid_body(body1)),
        1 => joints.set_bodies(handle, body1, body2),
        2 => {
            let inserted = joints.try_insert(body1, body2, some_joint(choices), choices.coin());
            play.joints.extend(inserted);
        }
        _ => play.joints.push(joints.insert(body1, body2, some_joint(choices), choices.coin())),
    }
}

/// Edits one joint, or all joints.
pub fn edit(play: &mut Play<'_>) {
    let handle = play.joint();
    let joints = &mut play.world.impulse_joints;
    let choices = &mut play.choices;
    if choices.once_in(20) {
        joints.iter_mut().for_each(|(_, joint)| change(&mut joint.data, choices));
    } else if let Some(joint) = joints.get_mut(handle) {
        change(&mut joint.data, choices);
    }
}

/// Edits a joint.
pub fn change(joint: &mut GenericJoint, choices: &mut Choices<'_>) {
    let axis = choices.pick(&AXES);
    let (value, other) = (some_real(choices), some_real(choices));
    match choices.below(16) {
        0 => drop(joint.set_limits(axis, [value, other])),
        1 => drop(joint.set_limits(axis, [-value.abs(), other.abs()])),
        2 => drop(joint.set_motor_velocity(axis, value, other)),
        3 => drop(joint.set_motor_position(axis, value, 10.0 * other.abs(), 1.0)),
        4 => drop(joint.set_motor(axis, value, other, some_real(choices), some_real(choices))),
        5 => drop(joint.set_motor_max_force(axis, value)),
        6 => {
            let models = [MotorModel::AccelerationBased, MotorModel::ForceBased];
            joint.set_motor_model(axis, choices.pick(&models));
        }
        7 => drop(joint.set_break_thresholds(value.abs(), other.abs())),
        8 => drop(joint.set_softness(Some(SpringCoefficients::new(value, other)))),
        9 => drop(joint.set_local_frame1(some_pose(choices, 1.0))),
        10 => drop(joint.set_local_frame2(some_pose(choices, 1.0))),
        11 => joint.set_enabled(!choices.once_in(3)),
        12 => drop(joint.set_contacts_enabled(choices.coin())),
        13 if other > 0.0 => set_transmission(joint, axis, value, other),
        13 => joint.flip(),
        14 => {
            let axes = JointAxesMask::from_bits_truncate(choices.below(64) as u8);
            joint.lock_axes(axes);
        }
        _ => write_past_the_setters(joint, axis, value),
    }
}

/// Makes a joint a transmission, mostly one without the axes that would prevent it from acting.
fn set_transmission(joint: &mut GenericJoint, axis: JointAxis, value: Real, other: Real) {
    let ends = [
        TransmissionEnd::Angle,
        TransmissionEnd::Shift,
        TransmissionEnd::Distance { from: Vector::splat(value) },
    ];
    let ends = [ends[axis as usize % 3], ends[(value.abs() * 8.0) as usize % 3]];
    joint.set_transmission(Transmission::new(ends, [value, other]));
    if axis != JointAxis::LinX {
        let keeps = (joint.local_frame1, joint.local_frame2, joint.transmission);
        *joint = GenericJoint::new(JointAxesMask::empty());
        (joint.local_frame1, joint.local_frame2, joint.transmission) = keeps;
        joint.set_limits(JointAxis::LinX, [-value.abs(), other]);
    }
}

/// Writes a public field directly. A step must survive any value.
fn write_past_the_setters(joint: &mut GenericJoint, axis: JointAxis, value: Real) {
    joint.limits[axis as usize].max = value;
    joint.motors[axis as usize].target_vel = value;
    joint.motors[axis as usize].damping = value;
    joint.local_frame1.translation.x = value;
    joint.motor_axes = JointAxesMask::all();
}
