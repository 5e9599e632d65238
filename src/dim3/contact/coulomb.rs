//! Friction at each point, within the exact cone of that point: the other friction model.
//!
//! Each point `k` has two tangential rows, solved together, with an impulse `λt` of its own:
//!
//! ```text
//! |λt_k| ≤ μ λ_k        rows, matrix and signs as in `friction` and `tangents`, with the point for the centre
//! ```
//!
//! Torque about the normal follows from the forces of the points. The points are solved in sequence, coupled
//! through the bodies. The four small solves are about twice the work of the [central rows](super::friction).
//! [`ContactBlock`] excludes these rows, so worlds with the standard model do not load them into the caches.

use super::block::ContactBlock;
use super::friction::{moment, slip, tangent_mass};
use super::pair::Pair;
use super::rows::{Frame, push};
use super::tangents::{TangentMass, load, store};
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
    mass: TangentMass<Lane>,
    /// Friction impulse of this substep along the two tangents.
    impulse: [Lane; 2],
}

/// Friction of each point of a [`ContactBlock`].
#[derive(Clone, Debug)]
pub(crate) struct CoulombBlock([TangentRows; MAX_MANIFOLD_POINTS]);

impl CoulombBlock {
    /// No friction in any lane.
    pub const EMPTY: Self = Self(
        [TangentRows { z: Lane::ZERO, mass: TangentMass::ZERO, impulse: [Lane::ZERO; 2] };
            MAX_MANIFOLD_POINTS],
    );

    /// Stores the warm-start impulses of the points, with these shares of the last ones. Impulses that are
    /// not finite become zero.
    #[inline(always)]
    pub fn store_impulses<W: Wide>(
        &self,
        impulses: &mut [[Lane; 2]; MAX_MANIFOLD_POINTS],
        withheld: W,
    ) {
        let zero = W::zero();
        for (rows, kept) in self.0.iter().zip(impulses) {
            let x = W::load(&rows.impulse[0]) + W::load(&kept[0]) * withheld;
            let y = W::load(&rows.impulse[1]) + W::load(&kept[1]) * withheld;
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
            tangent_mass(pair, points[k].local).store(&mut rows.mass);
            rows.impulse = input.tangent_impulses[k];
        }
    }

    /// Computes the effective masses anew.
    #[inline(always)]
    pub(super) fn write_masses<W: Wide>(&mut self, block: &ContactBlock, pair: &Pair<W>) {
        for k in 0..MAX_MANIFOLD_POINTS {
            let point = self.point(k, block);
            tangent_mass(pair, point).store(&mut self.0[k].mass);
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
            let impulse = load(&self.0[k].impulse);
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
        let surface: [W; 2] = load(&block.friction.surface_velocity);
        for k in 0..MAX_MANIFOLD_POINTS {
            let limit = coefficient * W::load(&block.points[k].impulse);
            let slip = slip(frame, self.point(k, block), c, velocities);
            let slip = [slip[0] - surface[0], slip[1] - surface[1]];
            let old: [W; 2] = load(&self.0[k].impulse);
            let new = TangentMass::load(&self.0[k].mass).friction(old, slip, limit);
            store(new, &mut self.0[k].impulse);
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
        let moments = [moment(a, [x, y]), moment(b, [x, y])];
        push(block, frame.t1 * x + frame.t2 * y, moments, velocities)
    }
}
