//! The points of one block in an impact: those that hit, and their target velocities. The rounds are in
//! `active.rs`.
//!
//! The velocity of a substep, which is that of its middle, is not that of the time `τ`. With the acceleration
//! `A/h` the velocities before and after at `τ` are `c + b` and `-e (c + b)`, in the middle `c` and
//!
//! ```text
//! -e (c + b) - b,      b = A (τ/h - ½)
//! ```
//!
//! so a ball that bounces with `e = 1` keeps its height to second order in `h`.

use super::lanes;
use super::points::{self, NormalRows};
use crate::base::disjoint::DisjointMut;
use crate::base::wide::{LANES, Lane, Wide};
use crate::dim::contact::{ContactBlock, CoulombBlock};
use crate::dim::math::{MAX_MANIFOLD_POINTS, Real};
use crate::dim::state::BodyState;
use crate::model::params::ImpactPass;
use crate::step::solver::restitution::{DEFERRED_SEPARATION, HitRow, supported};

/// One contact point of each lane.
#[derive(Copy, Clone, Debug, Default)]
struct ImpactRow {
    /// While the point is deferred: its separation at the start of the step, which the block does not
    /// contain.
    separation: Lane,
    /// Velocity change in this substep by forces and their supports. Impulses of the last substep that act
    /// again in this one may be larger, and must not pass for forces.
    accelerated: Lane,
    /// It hits where its velocity is below this.
    limit: Lane,
    /// Impulses of the whole impact: the committed fraction of each round.
    given: Lane,
    /// Support velocity and, in active blocks, the data of this round.
    active: HitRow<Lane>,
}

/// Velocities of all bodies, which impacts read and do not change.
#[derive(Copy, Clone)]
pub(in super::super) struct KnownVelocities<'a> {
    /// At the end of the last substep.
    pub last: &'a [BodyState],
    /// In this substep, with the impulses of the last one, which support the forces.
    pub loaded: &'a [BodyState],
}

/// The contacts of one block that bounce.
#[derive(Clone, Debug)]
pub(in super::super) struct ImpactBlock {
    /// Index of the block.
    pub at: usize,
    pub restitution: Lane,
    rows: [ImpactRow; MAX_MANIFOLD_POINTS],
    /// The island of each lane.
    pub islands: [u32; LANES],
}

/// Flags that each round reads for every block; often they show that nothing is to do. They are stored
/// separately, so that thousands of blocks are skipped without reading their rows.
#[derive(Copy, Clone, Debug, Default)]
pub(in super::super) struct ImpactMark {
    /// One bit per lane: set if any point hits in this round.
    pub active: u32,
    /// Whether any point hit in this substep.
    pub was_active: bool,
    /// One bit per point and lane: set if it approaches fast and does not arrive in this substep.
    to_defer: u32,
    /// One bit per point and lane: set if it is deferred.
    deferred: u32,
}

const _: () = assert!(MAX_MANIFOLD_POINTS * LANES <= u32::BITS as usize);

impl ImpactMark {
    /// Returns whether any point is to be deferred.
    pub fn has_points_to_defer(&self) -> bool {
        self.to_defer != 0
    }

    /// Returns whether any point is deferred.
    pub fn is_deferred(&self) -> bool {
        self.deferred != 0
    }
}

/// The bits of a point's lanes among those of all points.
fn of_point(bits: u32, point: usize) -> u32 {
    bits >> (point * LANES) & (u32::MAX >> (u32::BITS as usize - LANES))
}

impl ImpactBlock {
    /// For the block with this index.
    pub fn new(at: usize, restitution: Lane, islands: [u32; LANES]) -> Self {
        Self { at, restitution, rows: [ImpactRow::default(); MAX_MANIFOLD_POINTS], islands }
    }

    /// Restores the points that the last substep deferred.
    pub fn restore(&self, mark: &mut ImpactMark, block: &mut ContactBlock) {
        for (k, (row, point)) in self.rows.iter().zip(&mut block.points).enumerate() {
            for lane in lanes(of_point(mark.deferred, k)) {
                point.separation.0[lane] = row.separation.0[lane];
            }
        }
        mark.deferred = 0;
    }

    /// Defers the points that approach fast and do not arrive in this substep. The other passes would stop
    /// them at contact, so they would arrive too slowly.
    pub fn defer(&mut self, mark: &mut ImpactMark, block: &mut ContactBlock) {
        for (k, (row, point)) in self.rows.iter_mut().zip(&mut block.points).enumerate() {
            for lane in lanes(of_point(mark.to_defer, k)) {
                row.separation.0[lane] =
                    core::mem::replace(&mut point.separation.0[lane], DEFERRED_SEPARATION);
            }
        }
        mark.deferred = mark.to_defer;
    }

    /// Begins a substep: stores the velocities of the points, and their change by forces since the end of the
    /// last one.
    #[inline(always)]
    pub fn begin<W: Wide>(
        &mut self,
        rows: &NormalRows<'_, W>,
        block: &ContactBlock,
        known: KnownVelocities<'_>,
        pass: &ImpactPass,
    ) {
        let free = rows.velocities();
        let KnownVelocities { last, loaded } = known;
        let [then, loaded] = [last, loaded].map(|states| points::velocities_of::<W>(states, block));
        let fall = W::splat(pass.fall);
        for (k, row) in self.rows.iter_mut().enumerate() {
            let (support_velocity, limit) = supported(free[k], then[k], loaded[k], pass);
            support_velocity.store(&mut row.active.support_velocity);
            limit.store(&mut row.limit);
            let most = (free[k] - then[k]).abs().max(fall);
            let accelerated = (loaded[k] - then[k]).max(-most).min(most);
            accelerated.store(&mut row.accelerated);
            row.given = Lane::ZERO;
        }
    }

    /// Begins a round: finds the points that hit before the substep ends, and how they are to part.
    #[inline(always)]
    pub fn mark<W: Wide>(
        &mut self,
        mark: &mut ImpactMark,
        rows: &NormalRows<'_, W>,
        block: &ContactBlock,
        pass: &ImpactPass,
    ) {
        let (velocities, separations) = (rows.velocities(), rows.separations());
        let (zero, h) = (W::zero(), W::splat(pass.substep));
        let restitution = W::load(&self.restitution);
        let mut hits = [zero.lt(zero); MAX_MANIFOLD_POINTS];
        (mark.active, mark.to_defer) = (0, 0);
        for (k, row) in self.rows.iter().enumerate() {
            let velocity = velocities[k] + W::load(&row.active.support_velocity);
            // Points that the manifold has not got have no mass.
            let can_be_hit = zero.lt(restitution) & zero.lt(W::load(&block.points[k].mass));
            let comes = velocity.lt(W::load(&row.limit)) & can_be_hit;
            let end = separations[k] + velocity * h;
            hits[k] = comes & end.lt(zero);
            mark.active |= W::bits(hits[k]);
            mark.to_defer |= W::bits(comes & zero.le(end)) << (k * LANES);
        }
        if mark.active == 0 {
            return;
        }
        mark.was_active = true;
        for (k, row) in self.rows.iter_mut().enumerate() {
            let velocity = velocities[k] + W::load(&row.active.support_velocity);
            let speed = W::select(hits[k], -velocity, W::splat(1.0));
            let mut active = HitRow::<W>::load(&row.active);
            active.mass = W::select(hits[k], W::load(&block.points[k].mass), zero);
            active.time = (separations[k] / speed).max(W::splat(-pass.step)).min(h);
            active.aim(speed, W::load(&row.accelerated), restitution, pass);
            active.store(&mut row.active);
        }
    }

    /// The targets of the points of a lane.
    pub(super) fn active_rows(&self, lane: usize) -> [HitRow<Real>; MAX_MANIFOLD_POINTS] {
        core::array::from_fn(|k| self.rows[k].active.lane(lane))
    }

    /// Counts impulses at the points of a lane.
    pub fn give(&mut self, lane: usize, impulses: [Real; MAX_MANIFOLD_POINTS]) {
        for (row, impulse) in self.rows.iter_mut().zip(impulses) {
            row.given.0[lane] += impulse;
        }
    }

    /// Ends the impact: friction acts under its normal impulses, which count into those of the step.
    ///
    /// # Safety
    /// The caller has exclusive access to the states of the block's bodies.
    #[inline(always)]
    pub unsafe fn solve_friction<W: Wide>(
        &self,
        block: &mut ContactBlock,
        coulomb: Option<&mut CoulombBlock>,
        states: &DisjointMut<BodyState>,
    ) {
        let given = self.rows.map(|row| row.given);
        for (total, given) in block.totals.iter_mut().zip(&given) {
            (W::load(total) + W::load(given)).store(total);
        }
        // SAFETY: the caller's promise.
        unsafe { points::solve_friction::<W>(block, coulomb, states, given) };
    }
}
