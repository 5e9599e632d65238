//! Surfaces that turn during a step.

use crate::base::wide::Wide;
use crate::dim::wide::{WideAngVector, WideVector};

/// How the bodies of a contact turn during a step.
///
/// A point with the arm `r` moves along the chord of its arc, not along the tangent at the start of the step:
///
/// ```text
/// (R(θ) - 1) r / dt  =  sin θ/θ ω × r + (1 - cos θ)/θ² dt ω × (ω × r)        θ = |ω| dt
/// ```
///
/// Friction with the tangent as the velocity lets a box creep outwards on a turntable, at 1 rad/s from 2 m to
/// 2.6 m in 30 s. This holds for bodies that impulses do not move. The velocities of others change within the
/// step, and the mean is not known at its start.
#[derive(Copy, Clone)]
pub(crate) struct Turning<W> {
    pub angvels: [WideAngVector<W>; 2],
    /// Half the length of the step (s).
    pub half_step: W,
}

impl<W: Wide> Turning<W> {
    /// `sin θ/θ - 1` and `(1 - cos θ)/θ² dt` for the square of an angular velocity; zero for bodies with a
    /// mass. The errors, below `θ⁴/200` of the second, are those of the rational functions.
    #[inline(always)]
    pub fn factors(&self, square: W, inv_mass: WideVector<W>) -> [W; 2] {
        let one = W::splat(1.0);
        let angle_squared = W::splat(4.0) * square * self.half_step * self.half_step;
        let tangent = -angle_squared / (W::splat(6.0) + angle_squared * W::splat(0.3));
        let chord = self.half_step / (one + angle_squared * W::splat(1.0 / 12.0));
        let is_moved = W::zero().lt(inv_mass.dot(inv_mass));
        [W::select(is_moved, W::zero(), tangent), W::select(is_moved, W::zero(), chord)]
    }
}
