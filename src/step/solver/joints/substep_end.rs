//! Joint positions at the end of the substep: see the head of this folder.

use super::block::JointBlock;
use super::geometry::Geometry;
use super::rows::Row;
use crate::base::wide::Wide;
use crate::dim::rotation_vector::turned_further;
use crate::dim::state::{WideDisplacement, WideMotion};
use crate::dim::wide::{ang_dot, cross};
use crate::model::params::JointPass;
use crate::step::solver::joint_rules::CURVATURE_FRACTION_MAX;
use crate::step::solver::states::Bodies;

/// Joint positions of a block at the end of the substep.
pub(super) struct SubstepEnd<W> {
    pub then: Geometry<W>,
    /// With these velocities.
    velocities: [WideMotion<W>; 2],
}

impl<W: Wide> SubstepEnd<W> {
    /// With the velocities that the bodies have.
    #[cfg_attr(not(target_arch = "wasm32"), inline(always))]
    pub fn new(block: &JointBlock, bodies: &Bodies<W>, pass: &JointPass) -> Self {
        let (velocities, h) = (bodies.velocities, W::splat(pass.substep));
        let places = [
            advanced(&bodies.displacements[0], &velocities[0], h),
            advanced(&bodies.displacements[1], &velocities[1], h),
        ];
        Self { then: Geometry::new(block, &places), velocities }
    }

    /// The rates of locked axes by the end of the substep, from where the joints are `now`, with the bias of
    /// the errors: those of now and `then`.
    #[inline(always)]
    pub fn rates<const N: usize>(
        &self,
        block: &mut JointBlock,
        now: &Geometry<W>,
        [errors, mut then]: [[W; N]; 2],
        pass: &JointPass,
    ) -> [W; N] {
        let is_stiff = W::zero().lt(W::load(&block.is_stiff));
        let seen_from_now = self.then.errors_seen_from(then, now, block);
        for (then, seen) in then.iter_mut().zip(seen_from_now) {
            *then = W::select(is_stiff, *then, seen);
        }
        let (inv_h, bias_rate) = (W::splat(pass.inv_substep), W::load(&block.bias_rate));
        let mut rates = [W::zero(); N];
        for k in 0..N {
            let bias = errors[k] * bias_rate;
            bias.store(&mut block.held_bias[k]);
            rates[k] = (then[k] - errors[k]) * inv_h + bias;
        }
        rates
    }

    /// Curvature of a free axis that moves by this `distance` in the substep, and has this `rate` `now`: a
    /// body on a rope, or on a cone, leaves along a tangent. No more than [`CURVATURE_FRACTION_MAX`].
    #[inline(always)]
    pub fn curvature(
        &self,
        now: &Geometry<W>,
        along: &Row<W>,
        distance: W,
        rate: W,
        pass: &JointPass,
    ) -> W {
        let curvature = distance * W::splat(pass.inv_substep) - rate;
        let is_translation = Self::is_translation(along);
        let bound = W::splat(CURVATURE_FRACTION_MAX) * self.speed(now, is_translation);
        curvature.min(bound).max(-bound)
    }

    /// Returns where a row is that of a translation.
    #[inline(always)]
    pub fn is_translation(along: &Row<W>) -> W::Mask {
        W::splat(0.5).lt(along.linear.dot(along.linear))
    }

    /// Speed of the joint in the mode of an axis (along or about it), in any direction.
    #[inline(always)]
    fn speed(&self, now: &Geometry<W>, is_translation: W::Mask) -> W {
        let [m1, m2] = &self.velocities;
        let angular_velocity = m2.angular - m1.angular;
        let at = [cross(m1.angular, now.arms[0]), cross(m2.angular, now.arms[1])];
        let linear_velocity = (m2.linear - m1.linear) + (at[1] - at[0]);
        W::select(
            is_translation,
            linear_velocity.dot(linear_velocity),
            ang_dot(angular_velocity, angular_velocity),
        )
        .sqrt()
    }
}

#[inline(always)]
fn advanced<W: Wide>(
    displacement: &WideDisplacement<W>,
    velocity: &WideMotion<W>,
    h: W,
) -> WideDisplacement<W> {
    WideDisplacement::new(
        displacement.linear + velocity.linear * h,
        turned_further(displacement.angular, velocity.angular * h),
    )
}
