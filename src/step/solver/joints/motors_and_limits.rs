//! Motors and limits of a free axis.
//!
//! ## Motors
//! `force = k (target - C) + c (target velocity - Ċ)`. The damper acts on the velocity `v'` *after* the
//! substep (implicit Euler), so it never overshoots. A spring on the position after the substep would lose
//! energy: its damping ratio increases by `h ω / 2`. A spring on the position before the substep (symplectic
//! Euler) keeps its energy, but only if it is soft, `h ω < 2`. Softened to
//!
//! ```text
//! k' = k / (1 + h² k K / 4)          K = J M⁻¹ Jᵀ
//! ```
//!
//! it keeps it at any stiffness: the solution then turns by `2 atan(h ω / 2)` per substep, as that of the
//! trapezoidal rule does. With `g = h c` and `p = h k' (C - target) - h c · target velocity` the impulse
//! satisfies `λ = -(g v' + p)`, or as a step towards it
//!
//! ```text
//! Δλ = -(g Ċ + λ + p) / (1 + g K)
//! ```
//!
//! Both passes use the stretch `C - target` of the beginning of the substep.
//!
//! ## Limits
//! A limit is a contact along the axis. It pushes only, and at a distance it lets the axis approach by that
//! distance in one substep. The condition applies at the end of the substep. It includes the curvature
//! (`substep_end.rs`), and the corrections of the locked axes, which are solved afterwards. A rope thus
//! guides a body on a circle of its length, and a pendulum on it keeps its energy, as on a locked joint.
//!
//! Limits in series, as in a telescope, are solved iteratively. A limit between bodies of the mass `m` under
//! a load `M` responds to the load's velocity as if the load were as light. In each of the two passes of a
//! substep its impulse is `m (v + β C)`, and the load moves by
//!
//! ```text
//! v‴ + a v″ + a/h (v′ + β v) = 0          a = 2 m / (M h)
//! ```
//!
//! That is stable only for `β < a` (Routh and Hurwitz), `β h < 2 m / M`. With the bias of locked axes, a
//! telescope under ten times the mass of its sections vibrates by a fifth of a metre. With
//! [`LIMIT_ERROR_FRACTION`] it comes to rest. A small fraction suffices: a limit acts before the axis exceeds
//! it, so little error remains.
//!
//! ## Acceleration-based motors
//! An acceleration-based motor multiplies by the mass that it moves in its own joint: that of the two bodies,
//! with the joint's locked axes. Bodies behind other joints are excluded. Consider the root of an arm whose
//! inertia is `n` times that of the first link. There the motor is `n` times too weak, and oscillates `√n`
//! times too slowly. (The matrix of the direct solver contains that inertia, but without motors and limits,
//! whose neighbours may be active or not.)

use super::block::{AxisRow, MotorRow};
use crate::base::wide::Wide;
use crate::dim::math::Real;
use crate::model::params::JointPass;

/// The fraction of a limit's error that a substep removes: see the module's head. Five sections under ten
/// times their mass come to rest with 0.02, with 0.05 they nearly do not.
const LIMIT_ERROR_FRACTION: Real = 0.02;

/// A free axis at the moment when it is solved.
pub(super) struct FreeAxis<W> {
    pub position: W,
    /// `1 / mass`: the velocity change by a unit impulse.
    pub effective: W,
    pub inverse: W,
}

/// The change of a motor's impulse.
#[inline(always)]
pub(super) fn solve_motor<W: Wide, const BIASED: bool>(
    motor: &mut MotorRow,
    axis: &FreeAxis<W>,
    rate: W,
    pass: &JointPass,
) -> W {
    let (h, one) = (W::splat(pass.substep), W::splat(1.0));
    if BIASED {
        (axis.position - W::load(&motor.target_pos)).store(&mut motor.stretch);
    }
    let per_mass = W::load(&motor.per_mass);
    let unit = per_mass * axis.inverse + (one - per_mass);
    let stiffness = W::load(&motor.stiffness) * unit;
    let g = h * (W::load(&motor.damping) * unit);
    let softened = h * stiffness / (one + W::splat(0.25) * h * h * stiffness * axis.effective);
    let p = softened * W::load(&motor.stretch) - g * W::load(&motor.target_vel);
    let old = W::load(&motor.impulse);
    let bound = W::load(&motor.max_impulse);
    let wanted = old - (g * rate + old + p) / (one + g * axis.effective);
    let new = wanted.min(bound).max(-bound);
    new.store(&mut motor.impulse);
    new - old
}

/// The change of the impulse of both limits.
#[inline(always)]
pub(super) fn solve_limits<W: Wide, const BIASED: bool>(
    row: &mut AxisRow,
    axis: &FreeAxis<W>,
    rate: W,
    pass: &JointPass,
) -> W {
    let lower = W::load(&row.lower);
    let above = axis.position - W::load(&row.min);
    let new_lower = limited::<W, BIASED>(lower, above, rate, axis, pass);
    new_lower.store(&mut row.lower);
    let added = new_lower - lower;

    let upper = W::load(&row.upper);
    let below = W::load(&row.max) - axis.position;
    let rate = -(rate + axis.effective * added);
    let new_upper = limited::<W, BIASED>(upper, below, rate, axis, pass);
    new_upper.store(&mut row.upper);
    added - (new_upper - upper)
}

/// The impulse of a limit that is `distance` away, and nears by `-rate`.
#[inline(always)]
fn limited<W: Wide, const BIASED: bool>(
    old: W,
    distance: W,
    rate: W,
    axis: &FreeAxis<W>,
    pass: &JointPass,
) -> W {
    let zero = W::zero();
    let apart = zero.lt(distance);
    let closing = distance * W::splat(pass.inv_substep);
    let opening =
        if BIASED { distance * W::splat(LIMIT_ERROR_FRACTION * pass.inv_substep) } else { zero };
    let wanted = axis.inverse * (rate + W::select(apart, closing, opening));
    (old - wanted).max(zero)
}
