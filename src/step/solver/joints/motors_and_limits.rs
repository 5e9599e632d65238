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

use super::block::{AxisRow, LIMIT_NONE, MotorRow};
use super::rows::Row;
use super::substep_end::SubstepEnd;
use crate::base::wide::Wide;
use crate::dim::math::Real;
use crate::model::params::JointPass;

/// The fraction of a limit's error that a substep removes: see the module's head. Five sections under ten
/// times their mass come to rest with 0.02, with 0.05 they nearly do not.
const LIMIT_ERROR_FRACTION: Real = 0.02;

/// The `h² k K` from which on a spring beside others is implicit.
const SYMPLECTIC_SQUARE_MAX: Real = 1.0;
/// The same for a spring that moves its bodies alone.
const MIDPOINT_SQUARE_MAX: Real = 4.0;

/// A free axis at the moment when it is solved.
pub(super) struct FreeAxis<W> {
    pub position: W,
    /// `1 / mass`: the velocity change by a unit impulse.
    pub effective: W,
    pub inverse: W,
}

/// The law of a motor in a pass: its impulse is `-(damping · rate + pull)`, within the bound.
pub(super) struct MotorLaw<W> {
    pub damping: W,
    pub pull: W,
    pub bound: W,
}

impl<W: Wide> MotorLaw<W> {
    /// Of a motor on an axis with this curvature (the rate that its velocities do not have yet).
    #[inline(always)]
    pub fn new<const BIASED: bool>(
        motor: &mut MotorRow,
        axis: &FreeAxis<W>,
        curvature: W,
        pass: &JointPass,
    ) -> Self {
        let (h, one) = (W::splat(pass.substep), W::splat(1.0));
        if BIASED {
            (axis.position - W::load(&motor.target_pos)).store(&mut motor.stretch);
        }
        let per_mass = W::load(&motor.per_mass);
        let unit = per_mass * axis.inverse + (one - per_mass);
        let spring = h * (W::load(&motor.stiffness) * unit);
        let damper = h * (W::load(&motor.damping) * unit);
        let square = h * spring * axis.effective;
        let (stretch, last) = (W::load(&motor.stretch), W::load(&motor.rate));
        let target_vel = damper * W::load(&motor.target_vel);

        let implicit = fade_in(square, SYMPLECTIC_SQUARE_MAX);
        let ahead = h * (W::splat(0.25) + W::splat(0.75) * implicit);
        let behind = h * W::splat(0.25) * (one - implicit);
        let among_others = (
            damper + spring * ahead,
            spring * (stretch + ahead * curvature - behind * last) - target_vel,
        );

        let has_spring = W::zero().lt(spring);
        let implicit = W::select(has_spring, fade_in(square, MIDPOINT_SQUARE_MAX), one);
        let (mean, half) = (one - implicit, W::splat(0.5));
        let ahead = half + half * implicit;
        let alone = if BIASED {
            let retimed = damper + axis.inverse;
            (
                damper + spring * ahead * h + mean * retimed,
                spring * (stretch + ahead * h * curvature) - mean * retimed * last - target_vel,
            )
        } else {
            let moved = (axis.position - W::load(&motor.target_pos)) - stretch;
            (
                damper + spring * h * implicit,
                spring * (stretch + half * mean * moved) - target_vel,
            )
        };
        let is_alone = W::zero().lt(W::load(&motor.is_alone));
        Self {
            damping: W::select(is_alone, alone.0, among_others.0),
            pull: W::select(is_alone, alone.1, among_others.1),
            bound: W::load(&motor.max_impulse),
        }
    }
}

/// 0 for small values, 1 for values much above the given one.
#[inline(always)]
fn fade_in<W: Wide>(value: W, at: Real) -> W {
    let square = value * value * W::splat(1.0 / (at * at));
    let fourth = (square * square).min(W::splat(LIMIT_NONE));
    fourth / (W::splat(1.0) + fourth)
}

/// The change of a motor's impulse.
#[inline(always)]
pub(super) fn solve_motor<W: Wide, const BIASED: bool>(
    motor: &mut MotorRow,
    axis: &FreeAxis<W>,
    rate: W,
    curvature: W,
    pass: &JointPass,
) -> W {
    let law = MotorLaw::new::<BIASED>(motor, axis, curvature, pass);
    let old = W::load(&motor.impulse);
    let wanted = old
        - (law.damping * rate + old + law.pull) / (W::splat(1.0) + law.damping * axis.effective);
    let new = wanted.min(law.bound).max(-law.bound);
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

/// The lowest and the highest rate of a directly solved axis that its limits allow, and the parts of these
/// that correct an exceeded limit.
#[inline(always)]
pub(super) fn rate_limits<W: Wide, const BIASED: bool>(
    row: &AxisRow,
    position: W,
    along: &Row<W>,
    pass: &JointPass,
) -> ([W; 2], [W; 2]) {
    let (zero, min, max) = (W::zero(), W::load(&row.min), W::load(&row.max));
    let is_locked = max.le(min);
    let correction = |distance: W| {
        let rate = distance * W::splat(if BIASED { pass.softness.bias_rate } else { 0.0 });
        let most = W::select(
            SubstepEnd::is_translation(along),
            W::splat(pass.correction_max),
            W::splat(LIMIT_NONE),
        );
        rate.min(most).max(-most)
    };
    let [below, above] = [position - min, max - position].map(|distance| {
        let is_apart = zero.lt(distance);
        let closing = distance * W::splat(pass.inv_substep);
        let correction = correction(distance);
        let is_apart = W::select(is_locked, zero, W::select(is_apart, W::splat(1.0), zero));
        let is_apart = zero.lt(is_apart);
        (W::select(is_apart, closing, correction), W::select(is_apart, zero, correction))
    });
    ([-below.0, above.0], [-below.1, above.1])
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
