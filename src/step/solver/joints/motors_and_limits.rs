//! Motors and limits of a free axis.
//!
//! Their forces are a law of the rate `v = Ċ` at the end of a pass. Directly solved joints solve the laws of
//! all axes together with the locked axes (`../axis_law.rs`). The axes of iterated joints are solved one by
//! one.
//!
//! ## Motors
//! `force = k (target - C) + c (target velocity - v)`. Both forces are implicit, so each pass has a linear
//! law for the impulse, `λ = -(g v + p)`, which is stable at any stiffness. With the stretch `x = C - target`
//! and the rate `v₀` when the substep began, and with `K = J M⁻¹ Jᵀ` of the axis,
//!
//! ```text
//! λ = -h k (x + a h v + b h v₀) - h c (v - target velocity)
//! ```
//!
//! `a = 1`, `b = 0` is the implicit Euler method, which damps a spring by the ratio `h ω / 2`. `a = 1/4`, `b
//! = -1/4` keeps the area of the phase plane at any stiffness: a spring among others uses these while `(h ω)²
//! = h² k K` is below [`SYMPLECTIC_SQUARE_MAX`]. The velocities of that method belong to the middle of the
//! substep and not to its end. The energy that a program reads oscillates by `h ω / 2`, and a spring at
//! rest starts with half an impulse too much, an amplitude of `√(1 + (h ω)²/4)`.
//!
//! A spring that moves its bodies alone follows the midpoint rule, which keeps the energy exactly: the axis
//! moves by the mean of the rates at both ends of the substep, and the spring has its mean stretch. The solve
//! pass moves the bodies. Its rate `v*` is to be that mean, and the rest of the impulse follows in the relax
//! pass:
//!
//! ```text
//! λ = -h k (x + h v*/2)             of the whole substep
//! v' = v* + K (λ - λ*)              after the relax pass
//! v* = (v₀ + v')/2        ⇒        λ* = λ - (v* - v₀)/K
//! ```
//!
//! At rest `v* = v₀ = 0`, so that `λ* = λ` carries the load and the relax pass has nothing to do. `K` must be
//! exact. One that is too small would add energy, and beside other springs the mean is no law of a single
//! axis.
//!
//! Springs beyond [`MIDPOINT_SQUARE_MAX`] oscillate faster than substeps can follow, and fade into the
//! implicit method: a rigid motor reaches its target in one substep, and stays there.
//!
//! ## Limits
//! A limit is a contact along the axis. It pushes only, and at a distance it lets the axis approach by that
//! distance in one substep. The condition applies at the end of the substep. It includes the curvature
//! (`substep_end.rs`), and the corrections of the locked axes. A rope thus guides a body on a circle of its
//! length, and a pendulum on it keeps its energy, as on a locked joint.
//!
//! Iterated limits in series have less stiffness than a load needs. A limit between bodies of the mass `m`
//! under a load `M` responds to the load's velocity as if the load were as light. In each of the two passes
//! of a substep its impulse is `m (v + β C)`, and the load moves by
//!
//! ```text
//! v‴ + a v″ + a/h (v′ + β v) = 0          a = 2 m / (M h)
//! ```
//!
//! That is stable only for `β < a` (Routh and Hurwitz), `β h < 2 m / M`. [`LIMIT_ERROR_FRACTION`] keeps `β`
//! below this bound for loads of a hundred times the mass. A small fraction suffices: a limit acts before the
//! axis exceeds it, so little error remains.
//!
//! ## Acceleration-based motors
//! An acceleration-based motor multiplies by the mass that it moves in its own joint: that of the two bodies,
//! with the joint's locked axes. Bodies behind other joints are excluded. Consider the root of an arm whose
//! inertia is `n` times that of the first link. There the motor is `n` times too weak, and oscillates `√n`
//! times too slowly.

use super::block::{AxisRow, LIMIT_NONE, MotorRow};
use crate::base::wide::Wide;
use crate::dim::math::Real;
use crate::model::params::JointPass;
use crate::step::solver::axis_law::OPPOSED_RATE_MAX;

/// The fraction of an iterated limit's error that a substep removes: see the module's head.
const LIMIT_ERROR_FRACTION: Real = 0.02;
/// The `h² k K` from which on a spring beside others is implicit.
const SYMPLECTIC_SQUARE_MAX: Real = 0.25;
/// The same for a spring that moves its bodies alone.
const MIDPOINT_SQUARE_MAX: Real = 4.0;

/// A free axis at the moment when it is solved.
pub(super) struct FreeAxis<W> {
    pub position: W,
    /// `1 / mass`: the velocity change by a unit impulse.
    pub effective: W,
    pub inverse: W,
}

impl<W: Wide> FreeAxis<W> {
    #[inline(always)]
    pub fn new(position: W, effective: W) -> Self {
        let (zero, one) = (W::zero(), W::splat(1.0));
        let movable = zero.lt(effective);
        let inverse = W::select(movable, one / W::select(movable, effective, one), zero);
        Self { position, effective, inverse }
    }
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
    pub fn new(motor: &mut MotorRow, axis: &FreeAxis<W>, curvature: W, pass: &JointPass) -> Self {
        let (h, one) = (W::splat(pass.substep), W::splat(1.0));
        let elongation = axis.position - W::load(&motor.target_pos);
        if pass.is_biased {
            elongation.store(&mut motor.stretch);
        }
        let per_mass = W::load(&motor.per_mass);
        let unit = per_mass * axis.inverse + (one - per_mass);
        let spring = h * (W::load(&motor.stiffness) * unit);
        let damper = h * (W::load(&motor.damping) * unit);
        let stretch = Stretch {
            start: W::load(&motor.stretch),
            now: elongation,
            ahead: curvature * h,
            rate: W::load(&motor.rate),
        };
        let square = h * spring * axis.effective;
        if pass.is_biased {
            let stiffness = spring * W::splat(pass.inv_substep);
            let force_max = W::load(&motor.max_impulse) * W::splat(pass.inv_substep);
            let capacity = stretch.capacity(stiffness, force_max, h, square);
            capacity.store(&mut motor.spring_capacity);
        }
        let others = Self::among_others([spring, damper, h, square], &stretch);
        let mass = axis.inverse;
        let alone = Self::alone([spring, damper, h, square], mass, &stretch, pass.is_biased);
        let is_alone = W::zero().lt(W::load(&motor.is_alone));
        let driven = damper * W::load(&motor.target_vel);
        Self {
            damping: W::select(is_alone, alone[0], others[0]),
            pull: W::select(is_alone, alone[1], others[1]) - driven,
            bound: W::load(&motor.max_impulse),
        }
    }

    /// `g` and `p` of a spring beside others: symplectic, or implicit if it is fast.
    #[inline(always)]
    fn among_others([spring, damper, h, square]: [W; 4], x: &Stretch<W>) -> [W; 2] {
        let (one, quarter) = (W::splat(1.0), W::splat(0.25));
        let implicit = fade_in(square, SYMPLECTIC_SQUARE_MAX);
        let ahead = quarter + (one - quarter) * implicit;
        let behind = quarter * (one - implicit);
        let stretch = x.start + (ahead * x.ahead - behind * h * x.rate);
        [damper + spring * ahead * h, spring * stretch]
    }

    /// `g` and `p` of a spring that moves its bodies alone: the midpoint rule, or implicit if it is fast.
    #[inline(always)]
    fn alone(
        [spring, damper, h, square]: [W; 4],
        mass: W,
        x: &Stretch<W>,
        is_biased: bool,
    ) -> [W; 2] {
        let (one, half) = (W::splat(1.0), W::splat(0.5));
        let has_spring = W::zero().lt(spring);
        let implicit = W::select(has_spring, fade_in(square, MIDPOINT_SQUARE_MAX), one);
        let mean = one - implicit;
        if is_biased {
            let (ahead, late) = (half + half * implicit, mean * (damper + mass));
            let stretch = x.start + ahead * x.ahead;
            [damper + spring * ahead * h + late, spring * stretch - late * x.rate]
        } else {
            let stretch = x.start + half * mean * (x.now - x.start);
            [damper + spring * h * implicit, spring * stretch]
        }
    }
}

/// The stretch of a spring.
struct Stretch<W> {
    /// When the substep began, and its rate then.
    start: W,
    rate: W,
    now: W,
    /// Increase by the curvature until the end of the substep.
    ahead: W,
}

impl<W: Wide> Stretch<W> {
    /// The most energy that a spring gives in a substep. The implicit method gives no more than the spring
    /// has when the substep begins. Symplectic methods give the work along a path of that substep and the
    /// last one, at the stretch between both.
    #[inline(always)]
    fn capacity(&self, stiffness: W, force_max: W, h: W, square: W) -> W {
        let path = h * self.rate.abs() * (W::splat(1.0) - fade_in(square, MIDPOINT_SQUARE_MAX));
        let stretch = self.start.abs() + path;
        (W::splat(0.5) * stiffness * stretch).min(force_max) * stretch
    }
}

/// 0 for values much below the given value, 1 for values much above.
#[inline(always)]
fn fade_in<W: Wide>(value: W, at: Real) -> W {
    let square = value * value * W::splat(1.0 / (at * at));
    let fourth = (square * square).min(W::splat(LIMIT_NONE));
    fourth / (W::splat(1.0) + fourth)
}

/// Solves an iterated axis: the point of its law that an impulse leads to. Returns the change of the impulse.
#[inline(always)]
pub(super) fn solve_axis<W: Wide>(
    row: &mut AxisRow,
    axis: &FreeAxis<W>,
    [rate, curvature]: [W; 2],
    is_translation: W::Mask,
    pass: &JointPass,
) -> W {
    let law = MotorLaw::new(&mut row.motor, axis, curvature, pass);
    let is_alone = W::zero().lt(W::load(&row.motor.is_alone));
    let correction_rate = W::select(
        is_alone,
        W::splat(pass.softness.bias_rate),
        W::splat(LIMIT_ERROR_FRACTION * pass.inv_substep),
    );
    let ([low, high], _) =
        rate_limits::<W>(row, axis.position, correction_rate, is_translation, pass);
    let old = impulse_of(row);
    let free = rate - axis.effective * old;
    let motor = -(law.damping * free + law.pull) / (W::splat(1.0) + law.damping * axis.effective);
    let motor = motor.min(law.bound).max(-law.bound);
    let new = motor
        .max((low - curvature - free) * axis.inverse)
        .min((high - curvature - free) * axis.inverse);
    // A rigid motor against a limit has any impulse. The sum must keep its digits.
    let room = W::splat(OPPOSED_RATE_MAX) * axis.inverse;
    let motor = motor.min(new + room).max(new - room);
    let motor = motor.min(law.bound).max(-law.bound);
    motor.store(&mut row.motor.impulse);
    (new - motor).max(W::zero()).store(&mut row.lower);
    (motor - new).max(W::zero()).store(&mut row.upper);
    impulse_of::<W>(row) - old
}

/// The impulse of a free axis: motor and limits together.
#[inline(always)]
pub(super) fn impulse_of<W: Wide>(row: &AxisRow) -> W {
    W::load(&row.motor.impulse) + (W::load(&row.lower) - W::load(&row.upper))
}

/// The lowest and the highest rate that the limits allow an axis, and the parts of these that correct an
/// exceeded limit, with this rate per error.
#[inline(always)]
pub(super) fn rate_limits<W: Wide>(
    row: &AxisRow,
    position: W,
    correction_rate: W,
    is_translation: W::Mask,
    pass: &JointPass,
) -> ([W; 2], [W; 2]) {
    let (zero, min, max) = (W::zero(), W::load(&row.min), W::load(&row.max));
    let correction_max =
        W::select(is_translation, W::splat(pass.correction_max), W::splat(LIMIT_NONE));
    let (mut rates, mut corrections) = ([zero; 2], [zero; 2]);
    let distances = [position - min, max - position];
    for side in 0..2 {
        // Equal limits hold at any distance.
        let apart = W::select(max.le(min), zero, distances[side]);
        let is_apart = zero.lt(apart);
        let correction = distances[side] * correction_rate;
        let correction = correction.min(correction_max).max(-correction_max);
        let held = if pass.is_biased { correction } else { zero };
        rates[side] = W::select(is_apart, apart * W::splat(pass.inv_substep), held);
        corrections[side] = W::select(is_apart, zero, correction);
    }
    ([-rates[0], rates[1]], [-corrections[0], corrections[1]])
}
