//! Motors and limits of a free axis.
//!
//! ## Motors
//! `force = k (target - C) + c (target velocity - Ċ)`. The damper acts on the velocity `v'` *after* the
//! substep (implicit Euler), so it never overshoots. A spring on the position after the substep would lose
//! energy: it dies down as if its damping ratio were `h ω / 2` more than it is. On the position before the
//! substep (symplectic Euler) it keeps its energy, but only soft springs do, `h ω < 2`. Softened to
//!
//! ```text
//! k' = k / (1 + h² k K / 4)          K = J M⁻¹ Jᵀ
//! ```
//!
//! it keeps it at any stiffness: the solution then turns by `2 atan(h ω / 2)` per substep, as that of the
//! trapezoidal rule does. With `g = h c` and `p = h k' (C - target) - h c · target velocity` the impulse
//! obeys `λ = -(g v' + p)`, or as a step towards it
//!
//! ```text
//! Δλ = -(g Ċ + λ + p) / (1 + g K)
//! ```
//!
//! Both passes use the stretch `C - target` of the beginning of the substep.
//!
//! ## Limits
//! A limit is a contact along the axis: it pushes only, and from afar it lets the axis come as near as it gets
//! in one substep. That is asked of the axis by the end of the substep: with what bending adds (`substep_end.rs`), and with what the
//! locked axes, which are solved after it, will do about their own bending. So a rope leads round in a circle of its length, and
//! a pendulum on it keeps its energy, as one on a locked joint does.
//!
//! Limits that press on each other, as those of a telescope do, are solved in sweeps. One between bodies of the mass `m` that
//! holds a load `M` answers to the load's velocity as if it were as light: by `m (v + β C)` in each of the two visits of a
//! substep, for which the load moves by
//!
//! ```text
//! v‴ + a v″ + a/h (v′ + β v) = 0          a = 2 m / (M h)
//! ```
//!
//! That is stable only for `β < a` (Routh and Hurwitz), `β h < 2 m / M`. With the bias of locked axes, a telescope that holds
//! ten times its sections' mass shakes them by a fifth of a metre; with [`LIMIT_SHARE`] it comes to rest. A limit can be
//! patient: it has little to undo, because it stops what comes before that is too far.
//!
//! ## What an acceleration is
//! A motor that is given accelerations multiplies them by the mass that it moves in its own joint: of the two bodies, held by
//! the joint's locked axes. What else hangs on these it does not know. At the root of an arm whose inertia is `n` times
//! that of the first link it is `n` times too weak, and swings `√n` times too slowly. (The matrix of the exact solution knows
//! that inertia, but only without motors and limits, whose neighbours in turn may hold or let go.)

use super::block::{AxisRow, MotorRow};
use crate::base::wide::Wide;
use crate::dim::math::Real;
use crate::model::params::JointPass;

/// The share of a limit's error that a substep removes: see the module's head. Five sections under ten times their mass come
/// to rest with 0.02, with 0.05 they nearly do not.
const LIMIT_SHARE: Real = 0.02;

/// A free axis at the moment when it is solved.
pub(super) struct FreeAxis<W> {
    pub position: W,
    /// `1 / mass`: how fast a unit of impulse makes it.
    pub effective: W,
    pub inverse: W,
}

/// The change of a motor's impulse.
#[inline(always)]
pub(super) fn solve_motor<W: Wide, const AHEAD: bool>(
    motor: &mut MotorRow,
    axis: &FreeAxis<W>,
    rate: W,
    pass: &JointPass,
) -> W {
    let (h, one) = (W::splat(pass.substep), W::splat(1.0));
    if AHEAD {
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
pub(super) fn solve_limits<W: Wide, const AHEAD: bool>(
    row: &mut AxisRow,
    axis: &FreeAxis<W>,
    rate: W,
    pass: &JointPass,
) -> W {
    let lower = W::load(&row.lower);
    let above = axis.position - W::load(&row.min);
    let new_lower = limited::<W, AHEAD>(lower, above, rate, axis, pass);
    new_lower.store(&mut row.lower);
    let added = new_lower - lower;

    let upper = W::load(&row.upper);
    let below = W::load(&row.max) - axis.position;
    let rate = -(rate + axis.effective * added);
    let new_upper = limited::<W, AHEAD>(upper, below, rate, axis, pass);
    new_upper.store(&mut row.upper);
    added - (new_upper - upper)
}

/// The impulse of a limit that is `distance` away, and nears by `-rate`.
#[inline(always)]
fn limited<W: Wide, const AHEAD: bool>(
    old: W,
    distance: W,
    rate: W,
    axis: &FreeAxis<W>,
    pass: &JointPass,
) -> W {
    let zero = W::zero();
    let apart = zero.lt(distance);
    let closing = distance * W::splat(pass.inv_substep);
    let opening = if AHEAD { distance * W::splat(LIMIT_SHARE * pass.inv_substep) } else { zero };
    let wanted = axis.inverse * (rate + W::select(apart, closing, opening));
    (old - wanted).max(zero)
}
