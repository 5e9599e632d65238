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
//! * The *size* of a rotation vector: that of the whole rotation, or that of the swing of `e`, the shortest
//!   rotation from `e` to `f`. The direction is its axis `n`.
//! * The *component* of such a rotation vector about an axis `k`.
//!
//! A single free rotation is a twist. Two have the components of the whole rotation vector. All three are the
//! twist about `X` and the components of the swing of `X` about `Y` and `Z`.
//!
//! The swing of `e` is the rotation without the twist, `q t*` with `t = (p e, w)/√(p² + w²)` and `p = v·e`.
//! Both rotations have the half angle `β` from `sin β` and `cos β`, the parts of their quaternion. The
//! components have the same derivative, with `ρ = β n` for the whole rotation and `ρ = 2β n` for the swing:
//!
//! ```text
//! d(2β n·k)/dt = ω·(a k + (1 - a) (n·k) n + ρ × k)          a = ρ cot ρ
//! ```
//!
//! (The inverse of the derivative of the exponential map: Bullo and Murray, "Proportional derivative control
//! on the Euclidean group", 1995.) With `c = n·k` the square of its length is `c² + (1 - c²)(ρ/sin ρ)²`: from
//! 1 to `(π/2)²` for the whole rotation. That of a swing grows without bound where `f` arrives at `-e`, and
//! is cut there. But a pose is a smooth function of the angles everywhere, so the angles never require a
//! large velocity for their rates.
//!
//! Angles in planes, `atan2(-f₃, f₁)` for the swing about `Y`, do: an arm that has swung by 90° about `Z` has
//! no such angle. Limits and motors threw arms that fell past the horizontal, with up to 10¹⁴ times their
//! energy.
//!
//! Sources: Dobrowolski, "Swing-twist decomposition in Clifford algebra" (2015), for the twist; Bullo and
//! Murray for the derivative.

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
