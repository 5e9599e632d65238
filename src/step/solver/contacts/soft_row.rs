//! The soft normal row of a contact: the derivation is in `model/params/softness.rs`, the rule for separated
//! points in `dim3/contact/mod.rs`.

use crate::base::wide::Wide;
use crate::model::params::{ContactPass, Softness};

/// A [`ContactPass`] in registers.
pub(super) struct SoftRow<W> {
    /// Bias rate times mass scale (1/s).
    rate: W,
    mass_scale: W,
    impulse_scale: W,
    inv_substep: W,
    /// Overlap that is not corrected (length units).
    allowed: W,
    /// Largest velocity that corrects overlap, downwards.
    push: W,
}

impl<W: Wide> SoftRow<W> {
    #[inline(always)]
    pub fn new(pass: &ContactPass) -> Self {
        let Softness { bias_rate, mass_scale, impulse_scale } = pass.softness;
        Self {
            rate: W::splat(bias_rate * mass_scale),
            mass_scale: W::splat(mass_scale),
            impulse_scale: W::splat(impulse_scale),
            inv_substep: W::splat(pass.inv_substep),
            allowed: W::splat(pass.allowed_error),
            push: W::splat(-pass.push_velocity_max),
        }
    }

    /// Decrease of a point's impulse.
    #[inline(always)]
    pub fn wanted<const BIAS: bool>(&self, velocity: W, separation: W, mass: W, impulse: W) -> W {
        let zero = W::zero();
        let apart = zero.lt(separation);
        // Separated points may close the gap within the substep, and no more.
        let closing = separation * self.inv_substep;
        if !BIAS {
            return mass * (velocity + W::select(apart, closing, zero));
        }
        let error = (separation + self.allowed).min(zero);
        let opening = (error * self.rate).max(self.push);
        let bias = W::select(apart, closing, opening);
        let mass_scale = W::select(apart, W::splat(1.0), self.mass_scale);
        let impulse_scale = W::select(apart, zero, self.impulse_scale);
        mass * (velocity * mass_scale + bias) + impulse * impulse_scale
    }
}
