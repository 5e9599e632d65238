//! Friction at each point, within the exact cone of that point: the other friction model.
//!
//! Each point `k` has two tangential rows, solved together, with an impulse `λt` of its own:
//!
//! ```text
//! |λt_k| ≤ μ λ_k        rows, matrix and signs as in `friction`, with the point for the centre
//! ```
//!
//! Friction of a sliding point is opposite to its slip `s` (maximum dissipation). The impulse that would
//! stop the slip, `-K⁻¹ s`, has another direction, because a body yields more easily to an impulse that
//! rotates it: a box of 2×1×2 m decelerated with `0.90 µ g` when impulses outside the cone were only
//! shortened. They are therefore replaced by a step along the slip, whose fixed point is Coulomb's law:
//!
//! ```text
//! λt ← project(λt - ρ s)        ρ the smallest eigenvalue of K⁻¹, so that the step contracts
//! ```
//!
//! (de Saxcé, Feng, "The bipotential method", 1998.)
//!
//! Torque about the normal follows from the forces of the points. The points are solved in sequence, coupled
//! through the bodies: four small solves, about twice the work of the [central rows](super::friction). Kept
//! out of [`ContactBlock`] so that worlds with the standard model do not carry it through the caches.

use super::block::ContactBlock;
use super::friction::{self, onto_circle, stopping_impulse, tangent_mass};
use super::pair::Pair;
use super::rows::{Frame, push};
use crate::base::wide::{Lane, Wide};
use crate::dim3::math::MAX_MANIFOLD_POINTS;
use crate::dim3::state::WideMotion;
use crate::dim3::wide::WideVector;
use crate::model::contact::{ContactInput, WidePoint};

/// The tangential rows of one point of each lane.
#[derive(Copy, Clone, Debug)]
#[repr(C)]
struct TangentRows {
    /// Height of the point in the contact frame, from the first centre of mass. The other two
    /// coordinates are in the block.
    z: Lane,
    /// Inverse of the 2×2 effective-mass matrix: 11, 12, 22.
    mass: [Lane; 3],
    /// Smallest eigenvalue of that inverse: the `ρ` of a sliding point.
    mass_min: Lane,
    /// Friction impulse of this substep along the two tangents.
    impulse: [Lane; 2],
}

impl TangentRows {
    /// The impulse that stops the slip if it is within the cone, or else one of the largest size, opposite to
    /// the slip.
    #[inline(always)]
    fn impulse_within_cone<W: Wide>(&self, old: [W; 2], slip: [W; 2], limit: W) -> [W; 2] {
        let stopping = stopping_impulse(friction::load(&self.mass), old, slip);
        let is_inside = (stopping[0] * stopping[0] + stopping[1] * stopping[1]).le(limit * limit);
        let rho = W::load(&self.mass_min);
        let sliding = onto_circle([old[0] - rho * slip[0], old[1] - rho * slip[1]], limit);
        [0, 1].map(|along| W::select(is_inside, stopping[along], sliding[along]))
    }
}

/// Friction of each point of a [`ContactBlock`].
#[derive(Clone, Debug)]
pub(crate) struct CoulombBlock([TangentRows; MAX_MANIFOLD_POINTS]);

impl CoulombBlock {
    /// No friction in any lane.
    pub const EMPTY: Self = Self(
        [TangentRows {
            z: Lane::ZERO,
            mass: [Lane::ZERO; 3],
            mass_min: Lane::ZERO,
            impulse: [Lane::ZERO; 2],
        }; MAX_MANIFOLD_POINTS],
    );

    /// Stores the warm-start impulses of the points; impulses that are not finite become zero.
    #[inline(always)]
    pub fn store_impulses<W: Wide>(&self, impulses: &mut [[Lane; 2]; MAX_MANIFOLD_POINTS]) {
        let zero = W::zero();
        for (rows, kept) in self.0.iter().zip(impulses) {
            let (x, y) = (W::load(&rows.impulse[0]), W::load(&rows.impulse[1]));
            let is_sound = (zero * (x + y)).le(zero);
            W::select(is_sound, x, zero).store(&mut kept[0]);
            W::select(is_sound, y, zero).store(&mut kept[1]);
        }
    }

    /// Multiplies all impulses by a factor of each lane.
    pub fn scale_impulses(&mut self, factors: &Lane) {
        for impulse in self.0.iter_mut().flat_map(|rows| &mut rows.impulse) {
            impulse.0.iter_mut().zip(factors.0).for_each(|(value, factor)| *value *= factor);
        }
    }

    /// Fills the rows, and disables the block's central rows.
    #[inline(always)]
    pub(super) fn prepare<W: Wide>(
        &mut self,
        input: &ContactInput,
        block: &mut ContactBlock,
        pair: &Pair<W>,
        points: &[WidePoint<W>; MAX_MANIFOLD_POINTS],
    ) {
        block.friction.impulse = [Lane::ZERO; 3];
        for (k, rows) in self.0.iter_mut().enumerate() {
            points[k].local.z.store(&mut rows.z);
            let mass = tangent_mass(pair, points[k].local);
            friction::store(mass, &mut rows.mass);
            smallest_eigenvalue(mass).store(&mut rows.mass_min);
            rows.impulse = input.tangent_impulses[k];
        }
    }

    /// Applies the impulses with which the step starts.
    #[inline(always)]
    pub(super) fn warm_start<W: Wide>(
        &self,
        block: &ContactBlock,
        frame: &Frame<W>,
        mut velocities: [WideMotion<W>; 2],
    ) -> [WideMotion<W>; 2] {
        for k in 0..MAX_MANIFOLD_POINTS {
            let impulse = friction::load(&self.0[k].impulse);
            velocities = self.apply(k, impulse, block, frame, velocities);
        }
        velocities
    }

    /// Solves the rows of all points once, under the normal impulses as they are.
    #[inline(always)]
    pub(super) fn solve<W: Wide>(
        &mut self,
        block: &ContactBlock,
        frame: &Frame<W>,
        mut velocities: [WideMotion<W>; 2],
    ) -> [WideMotion<W>; 2] {
        let coefficient = W::load(&block.friction.coefficient);
        let c = WideVector::load(&block.offset);
        let surface: [W; 2] = friction::load(&block.friction.surface_velocity);
        for k in 0..MAX_MANIFOLD_POINTS {
            let limit = coefficient * W::load(&block.points[k].impulse);
            let slip = friction::slip(frame, self.point(k, block), c, velocities);
            let slip = [slip[0] - surface[0], slip[1] - surface[1]];
            let old: [W; 2] = friction::load(&self.0[k].impulse);
            let new = self.0[k].impulse_within_cone(old, slip, limit);
            friction::store(new, &mut self.0[k].impulse);
            let added = [new[0] - old[0], new[1] - old[1]];
            velocities = self.apply(k, added, block, frame, velocities);
        }
        velocities
    }

    #[inline(always)]
    fn point<W: Wide>(&self, k: usize, block: &ContactBlock) -> WideVector<W> {
        let row = &block.points[k];
        WideVector { x: W::load(&row.x), y: W::load(&row.y), z: W::load(&self.0[k].z) }
    }

    /// The velocities after an impulse along the tangents at a point.
    #[inline(always)]
    fn apply<W: Wide>(
        &self,
        k: usize,
        [x, y]: [W; 2],
        block: &ContactBlock,
        frame: &Frame<W>,
        velocities: [WideMotion<W>; 2],
    ) -> [WideMotion<W>; 2] {
        let a = self.point::<W>(k, block);
        let b = a + WideVector::load(&block.offset);
        let moments = [friction::moment(a, [x, y]), friction::moment(b, [x, y])];
        push(block, frame.t1 * x + frame.t2 * y, moments, velocities)
    }
}

/// The smallest eigenvalue of a positive definite matrix: 11, 12, 22.
#[inline(always)]
fn smallest_eigenvalue<W: Wide>([m11, m12, m22]: [W; 3]) -> W {
    let half = W::splat(0.5);
    let (mean, difference) = (half * (m11 + m22), half * (m11 - m22));
    mean - (difference * difference + m12 * m12).sqrt()
}
