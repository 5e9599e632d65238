//! # Joint frames in 2D
//!
//! Rotations of joints, lane by lane and for one joint at a time. There is one axis of rotation. The error of
//! the locked axis is `4 tan(φ/4)` of the angle `φ` between the frames. For small angles it is the angle.
//! Half a revolution off it is 4, and its rate is `(1 + tan²(φ/4)) φ̇`, which does not vanish.

mod frame;
mod angle_tracker;
mod inertia;
mod point;

pub(crate) use crate::dim2::joint_angle::{FreeRotations, angle_about, couple_of, set_couple};
pub(crate) use angle_tracker::AngleTracker;
pub(crate) use frame::{
    angular_to_frame, angular_to_world, axes, components, frame_between, from_components,
    linear_to_world, locked_rotations,
};
#[cfg(test)]
pub(crate) use inertia::unit_inertia;
pub(crate) use inertia::{JointedInertias, inertia_about, is_round};
pub(crate) use point::{from_numbers, numbers, point_response};
