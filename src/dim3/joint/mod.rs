//! # Joint frames in 3D
//!
//! Rotations of joints, lane by lane and for one joint at a time. Let `q1, q2` be the world rotations of the
//! joint's frames on its bodies, and `q = q1* q2 = (v, w)` the second one relative to the first.
//!
//! ## Locked rotations
//! The error about a locked axis `k` is twice the component `v_k`, for small angles. With the relative
//! angular velocity `ω` in the first frame, `2 q̇ = ω q`, so
//!
//! ```text
//! 2 v̇ = w ω + ω × v,      rows   r₁ = (w, v₃, -v₂)   r₂ = (-v₃, w, v₁)   r₃ = (v₂, -v₁, w)
//! ```
//!
//! If two rotations are locked, `q` is a rotation about the third axis, `w² + v₃² = 1`. The two rows are
//! perpendicular unit vectors for any angle, without a singularity at half a turn. But all rows shrink with
//! the angle `φ` by which the locked axes are off, and vanish for half a turn. With the sine and the cosine
//! of `φ/2`, `s² = Σ v_k²` over the locked axes and `c² = 1 - s²`, the error is therefore
//!
//! ```text
//! C_k = 4 v_k / (1 + c)          Ċ_k = 2/(1 + c) r_k·ω + 2 v_k/(c (1 + c)²) Σ v_l r_l·ω
//! ```
//!
//! Its size is `4 tan(φ/4)`, and its rate along the axis of the error is `(1 + tan²(φ/4)) φ̇`. (These are the
//! modified Rodrigues parameters, Schaub and Junkins, "Stereographic orientation parameters", 1996, of the
//! part of the rotation that is locked.)
//!
//! ## Free rotations
//! A free axis has an angle, and a direction along which the relative angular velocity changes it. Let
//! `e` be the axis and `f = q e` where the second body has taken it.
//!
//! * *Twist* about `e`: `2 atan2(v·e, w)`. The direction is symmetric in both bodies: `(e + f)/(1 + e·f)`.
//! * *Swing* of `e` in any direction: the angle between `e` and `f`, about `e × f`.
//! * *Swing about another axis*: the direction of the projection of `f` on the plane across that axis. For
//!   `Y`, with `s = -f₃` and `c = f₁`, the angle is `atan2(s, c)`, and the direction is its gradient.
//!
//! Sources: Dobrowolski, "Swing-twist decomposition in Clifford algebra" (2015), for the twist; the rest is
//! the chain rule.

mod frame;
mod angle_tracker;
mod inertia;
mod point;

pub(crate) use crate::dim3::joint_angle::{FreeRotations, angle_about, couple_of, set_couple};
pub(crate) use angle_tracker::AngleTracker;
pub(crate) use frame::{
    angular_to_frame, angular_to_world, axes, components, frame_between, from_components,
    linear_to_world, locked_rotations,
};
#[cfg(test)]
pub(crate) use inertia::unit_inertia;
pub(crate) use inertia::{JointedInertias, inertia_about, is_round};
pub(crate) use point::{from_numbers, numbers, point_response};
