//! Blocks of point-to-point joints, and the passes over them.

use super::super::rows::Factored;
use crate::base::disjoint::DisjointMut;
use crate::base::wide::{LANES, Lane, Wide};
use crate::dim::joint::{JointedInertias, axes, from_numbers, numbers, point_response};
use crate::dim::math::{DIM, Real};
use crate::dim::state::{BodyState, READ_ONLY, WideMotion};
use crate::dim::wide::{
    ANG_ZERO_LANES, WideAngVector, WideRotation, WideSymmetric, WideVector, ang_lane, cross,
    load_ang, mul_inertia, set_ang_lane, store_ang, torque,
};
use crate::model::params::{JointPass, Softness};
use crate::step::solver::states::{Bodies, gather_states};

/// The least compliance of point-to-point joints: half that of other iterated joints. With a quarter of it, a
/// net of 100 × 100 gains energy.
const POINT_COMPLIANCE: Real = 1.0 / 16.0;

/// [`LANES`] point-to-point joints of one colour.
#[derive(Clone, Debug)]
pub(super) struct PointToPointBlock {
    pub bodies: [[u32; LANES]; 2],
    pub inv_mass: [WideVector<Lane>; 2],
    pub inertias: JointedInertias,
    /// From the centres of mass to the anchors when the step began.
    pub arms: [WideVector<Lane>; 2],
    /// From the first anchor to the second when the step began.
    pub separation: WideVector<Lane>,
    /// The factor on the bias: less than 1 where the anchors are far apart.
    pub bias_scale: Lane,
    /// The impulse of this substep on the second body, in world space; at the end of the step in the joint's
    /// first frame.
    pub impulse: WideVector<Lane>,
    /// Angular velocities that result from it.
    pub turned: [WideAngVector<Lane>; 2],
    /// The impulse of all substeps together.
    pub total: WideVector<Lane>,
    /// The joint's first frame when the step began.
    pub frame: WideRotation<Lane>,
}

impl PointToPointBlock {
    /// No joint in any lane.
    pub const EMPTY: Self = Self {
        bodies: [[READ_ONLY; LANES]; 2],
        inv_mass: [WideVector::ZERO; 2],
        inertias: JointedInertias::NONE,
        arms: [WideVector::ZERO; 2],
        separation: WideVector::ZERO,
        bias_scale: Lane::ZERO,
        impulse: WideVector::ZERO,
        turned: [ANG_ZERO_LANES; 2],
        total: WideVector::ZERO,
        frame: WideRotation::IDENTITY,
    };

    /// Scales the impulses of this substep, and their part of the sum over all substeps if that is counted.
    pub fn scale_impulses(&mut self, factors: &Lane, are_counted: bool) {
        for (lane, factor) in factors.0.into_iter().enumerate() {
            if are_counted {
                let removed = self.impulse.lane(lane) * (1.0 - factor);
                self.total.set_lane(lane, self.total.lane(lane) - removed);
            }
            self.impulse.set_lane(lane, self.impulse.lane(lane) * factor);
            for turned in &mut self.turned {
                set_ang_lane(turned, lane, ang_lane(turned, lane) * factor);
            }
        }
    }
}

/// The pass with the softness of point-to-point joints.
pub(super) fn softened(pass: &JointPass) -> JointPass {
    let compliance = pass.softness.compliance().max(POINT_COMPLIANCE);
    JointPass { softness: pass.softness.with_compliance(compliance), ..*pass }
}

/// The inverse masses of a block's bodies.
struct Masses<W> {
    linear: [WideVector<W>; 2],
    angular: [WideSymmetric<W>; 2],
}

impl<W: Wide> Masses<W> {
    #[inline(always)]
    fn load(block: &PointToPointBlock) -> Self {
        Self { linear: load_both(&block.inv_mass), angular: block.inertias.load() }
    }

    /// The angular velocities that result from the moments of an impulse.
    #[inline(always)]
    fn turned(&self, [first, second]: [WideAngVector<W>; 2]) -> [WideAngVector<W>; 2] {
        [-mul_inertia(self.angular[0], first), mul_inertia(self.angular[1], second)]
    }

    /// Applies an impulse to the bodies, the opposite one to the first, and the resulting changes of their
    /// angular velocities.
    #[inline(always)]
    fn push(
        &self,
        impulse: WideVector<W>,
        turned: &[WideAngVector<W>; 2],
        [v1, v2]: &mut [WideMotion<W>; 2],
    ) {
        v1.linear = v1.linear - impulse.component_mul(self.linear[0]);
        v2.linear = v2.linear + impulse.component_mul(self.linear[1]);
        v1.angular = v1.angular + turned[0];
        v2.angular = v2.angular + turned[1];
    }

    /// `K⁻¹ b` for the matrix `K` of the two points.
    #[inline(always)]
    fn solve(&self, arms: &[WideVector<W>; 2], b: WideVector<W>) -> WideVector<W> {
        let mut k = point_response(self.angular[0], arms[0]);
        let second = point_response(self.angular[1], arms[1]);
        let sum = numbers(self.linear[0] + self.linear[1]);
        for i in 0..DIM {
            for j in 0..=i {
                k[i][j] = k[i][j] + second[i][j];
            }
            k[i][i] = k[i][i] + sum[i];
        }
        from_numbers(Factored::new(k).solve(numbers(b)))
    }
}

/// The moments of an impulse at two moment arms.
#[inline(always)]
fn moments_of<W: Wide>(arms: &[WideVector<W>; 2], impulse: WideVector<W>) -> [WideAngVector<W>; 2] {
    [torque(arms[0], impulse), torque(arms[1], impulse)]
}

/// Gives the bodies the impulse with which the step starts.
///
/// # Safety
/// The caller has exclusive access to the states of the block's bodies.
#[inline(always)]
pub(super) unsafe fn warm_start<W: Wide>(
    block: &mut PointToPointBlock,
    states: &DisjointMut<BodyState>,
) {
    // SAFETY: the caller's promise.
    let mut bodies = unsafe { Bodies::<W>::gather(states, &block.bodies) };
    let impulse = WideVector::load(&block.impulse);
    let masses = Masses::load(block);
    let turned = masses.turned(moments_of(&load_both(&block.arms), impulse));
    masses.push(impulse, &turned, &mut bodies.velocities);
    store_turned(turned, block);
    // SAFETY: the caller's promise.
    unsafe { bodies.scatter(states, &block.bodies) };
}

/// Solves the joints once: with bias, or towards zero relative velocity.
///
/// # Safety
/// The caller has exclusive access to the states of the block's bodies.
#[inline(always)]
pub(super) unsafe fn iterate<W: Wide>(
    block: &mut PointToPointBlock,
    states: &DisjointMut<BodyState>,
    pass: &JointPass,
) {
    // SAFETY: the caller's promise.
    let mut bodies = unsafe { Bodies::<W>::gather(states, &block.bodies) };
    let [d1, d2] = bodies.displacements;
    if !pass.is_biased {
        block.inertias.rotate(&bodies.displacements);
    }
    let masses = Masses::load(block);
    let old = load_both::<W>(&block.arms);
    let arms = [d1.rotation().rotate(old[0]), d2.rotation().rotate(old[1])];
    let impulse = WideVector::<W>::load(&block.impulse);
    let mut turned = [load_ang::<W>(&block.turned[0]), load_ang(&block.turned[1])];
    if pass.is_biased {
        // The bodies already have the last substep's impulse; moment arms and inertias have rotated since.
        let now = masses.turned(moments_of(&arms, impulse));
        for side in 0..2 {
            let angular = &mut bodies.velocities[side].angular;
            *angular = *angular + (now[side] - turned[side]);
        }
        turned = now;
    }
    let [v1, v2] = &bodies.velocities;
    let mut rate =
        (v2.linear - v1.linear) + (cross(v2.angular, arms[1]) - cross(v1.angular, arms[0]));
    if pass.is_biased {
        let separation = WideVector::load(&block.separation)
            + (d2.linear - d1.linear)
            + ((arms[1] - old[1]) - (arms[0] - old[0]));
        let bias_rate = W::splat(pass.softness.bias_rate) * W::load(&block.bias_scale);
        rate = rate + separation * bias_rate;
    }
    let mut change = -masses.solve(&arms, rate);
    if pass.is_biased {
        let Softness { mass_scale, impulse_scale, .. } = pass.softness;
        change = change * W::splat(mass_scale) - impulse * W::splat(impulse_scale);
    }
    let added = masses.turned(moments_of(&arms, change));
    masses.push(change, &added, &mut bodies.velocities);
    let impulse = impulse + change;
    impulse.store(&mut block.impulse);
    store_turned([turned[0] + added[0], turned[1] + added[1]], block);
    if !pass.is_biased && pass.is_last_iteration {
        (WideVector::load(&block.total) + impulse).store(&mut block.total);
    }
    // SAFETY: the caller's promise.
    unsafe { bodies.scatter(states, &block.bodies) };
}

/// Expresses the impulses along the axes of the joints' first frames, where the next step finds them.
///
/// # Safety
/// No other thread writes the states of the block's first bodies.
#[inline(always)]
pub(super) unsafe fn turn_back<W: Wide>(
    block: &mut PointToPointBlock,
    states: &DisjointMut<BodyState>,
) {
    // SAFETY: the caller's promise.
    let (_, moved) = unsafe { gather_states::<W>(states, &block.bodies[0]) };
    let impulse = WideVector::<W>::load(&block.impulse);
    let axes = axes(moved.rotation().times(WideRotation::load(&block.frame)));
    let mut along = [W::zero(); DIM];
    for (along, axis) in along.iter_mut().zip(&axes) {
        *along = axis.dot(impulse);
    }
    from_numbers(along).store(&mut block.impulse);
}

#[inline(always)]
fn load_both<W: Wide>(both: &[WideVector<Lane>; 2]) -> [WideVector<W>; 2] {
    // Without closures, which would not be compiled for the kernel's instructions.
    [WideVector::load(&both[0]), WideVector::load(&both[1])]
}

#[inline(always)]
fn store_turned<W: Wide>([first, second]: [WideAngVector<W>; 2], block: &mut PointToPointBlock) {
    store_ang(first, &mut block.turned[0]);
    store_ang(second, &mut block.turned[1]);
}
