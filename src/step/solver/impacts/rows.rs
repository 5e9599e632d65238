//! The points of one block in an impact: which of them hit, and how fast they are to part.

use super::points::{self, NormalRows};
use crate::base::disjoint::DisjointMut;
use crate::base::wide::{LANES, Lane, Wide};
use crate::dim::contact::{ContactBlock, CoulombBlock};
use crate::dim::math::{MAX_MANIFOLD_POINTS, Real};
use crate::dim::state::{BodyState, gather_states, scatter_states};
use crate::model::params::ImpactPass;

/// Gauss–Seidel sweeps over the points of a manifold in one visit: they depend on each other more than on others.
pub(in super::super) const SWEEPS: usize = 4;
/// A round of an impact is settled when no point has to change its velocity by more than this share of that of its approach.
pub(in super::super) const SETTLED: Real = 1.0e-3;
/// How much of its speed a point's approach may be corrected by for what forces do in the rest of the substep.
pub(in super::super) const BEND_MAX: Real = 0.25;
/// Points that were at rest when the impact began take part as soon as they approach this much faster, as a share of
/// the speed below which nothing bounces. Rounding must not wake them.
pub(in super::super) const NOTICED: Real = 0.01;

/// Where points are that are put aside: beyond the reach of all passes.
pub(in super::super) const FAR: Real = 1.0e10;

/// One contact point of each lane.
#[derive(Copy, Clone, Debug, Default)]
struct ImpactRow {
    /// Its separation when the step began, as the block had it.
    separation: Lane,
    /// Its separation if it is not to be met in this substep, [`FAR`] if it is to be put aside.
    shown: Lane,
    /// By how much forces and what bears them have changed its velocity in this substep. Impulses of the last substep that
    /// act again in this one may be larger, and must not pass for forces.
    accelerated: Lane,
    /// How much of what forces did to its velocity in this substep is borne by what it presses against.
    borne: Lane,
    /// It hits where its velocity is below this.
    limit: Lane,
    /// `1 / K` where it hits in this round, zero elsewhere.
    mass: Lane,
    /// Its velocity of approach in this round (negative), and the one with which it is to part.
    approach: Lane,
    target: Lane,
    /// When it hits, from the beginning of the substep (s).
    time: Lane,
    /// Impulses of this round, and of the whole impact: of each round the share that it went.
    impulse: Lane,
    given: Lane,
}

/// The contacts of one block that bounce.
#[derive(Clone, Debug)]
pub(in super::super) struct ImpactBlock {
    /// Which block.
    pub at: usize,
    pub restitution: Lane,
    /// Are the rows filled?
    is_filled: bool,
    rows: [ImpactRow; MAX_MANIFOLD_POINTS],
    /// The island of each lane.
    pub islands: [u32; LANES],
    /// One bit per lane: does any point hit in this round?
    pub struck: u32,
    /// Has any point hit in this substep?
    pub was_struck: bool,
    /// One bit per lane: did the last visit have to change anything?
    pub moving: u32,
    /// The sum of impulse times approach in this round (negative), and how much more energy there is than there
    /// should be at most.
    pub stopped: Lane,
    pub surplus: Lane,
}

impl ImpactBlock {
    /// For the block with this index.
    pub fn new(at: usize, restitution: Lane, islands: [u32; LANES]) -> Self {
        Self {
            at,
            restitution,
            is_filled: false,
            rows: [ImpactRow::default(); MAX_MANIFOLD_POINTS],
            islands,
            struck: 0,
            was_struck: false,
            moving: 0,
            stopped: Lane::ZERO,
            surplus: Lane::ZERO,
        }
    }

    /// Takes back the points that were put aside in the last substep.
    pub fn recall(&mut self, block: &mut ContactBlock) {
        for (row, point) in self.rows.iter_mut().zip(&mut block.points) {
            if self.is_filled {
                point.separation = row.separation;
            } else {
                row.separation = point.separation;
            }
        }
        self.is_filled = true;
    }

    /// Puts the points aside that come fast and do not arrive in this substep. Left to the other passes, which let
    /// nothing come nearer than to touch, they would arrive too slowly.
    pub fn put_aside(&self, block: &mut ContactBlock) {
        for (row, point) in self.rows.iter().zip(&mut block.points) {
            point.separation = row.shown;
        }
    }

    /// Begins a substep: notes how the points move, and what forces did to that since the last one ended (`last`).
    /// `loaded` are the velocities with the impulses of the last substep, which bear these forces.
    #[inline(always)]
    pub fn begin<W: Wide>(
        &mut self,
        rows: &NormalRows<'_, W>,
        block: &ContactBlock,
        [last, loaded]: [&[BodyState]; 2],
        pass: &ImpactPass,
    ) {
        self.was_struck = false;
        let free = rows.velocities();
        let [then, loaded] = [last, loaded].map(|states| points::velocities_of::<W>(states, block));
        let (zero, threshold) = (W::zero(), W::splat(-pass.threshold));
        let (noticed, fall) = (W::splat(pass.threshold * NOTICED), W::splat(pass.fall));
        for (k, row) in self.rows.iter_mut().enumerate() {
            let forced = free[k] - then[k];
            let borne = (loaded[k] - free[k]).min(-forced).max(zero);
            borne.store(&mut row.borne);
            let now = free[k] + borne;
            let at_rest = threshold.le(now.max(then[k]));
            (W::select(at_rest, now.min(zero), zero) - noticed).store(&mut row.limit);
            let most = forced.abs().max(fall);
            let accelerated = (loaded[k] - then[k]).max(-most).min(most);
            accelerated.store(&mut row.accelerated);
            row.given = Lane::ZERO;
        }
    }

    /// Begins a round: finds the points that hit before the substep ends, and how they are to part.
    #[inline(always)]
    pub fn mark<W: Wide>(
        &mut self,
        rows: &NormalRows<'_, W>,
        block: &ContactBlock,
        pass: &ImpactPass,
    ) {
        let (velocities, separations) = (rows.velocities(), rows.separations());
        let (zero, half) = (W::zero(), W::splat(0.5));
        let (h, inv_h) = (W::splat(pass.substep), W::splat(pass.inv_substep));
        let restitution = W::load(&self.restitution);
        self.struck = 0;
        for (k, row) in self.rows.iter_mut().enumerate() {
            let velocity = velocities[k] + W::load(&row.borne);
            let separation = separations[k];
            let mass = W::load(&block.points[k].mass);
            // Points that the manifold has not got have no mass.
            let can_be_hit = zero.lt(restitution) & zero.lt(mass);
            let comes = velocity.lt(W::load(&row.limit)) & can_be_hit;
            let end = separation + velocity * h;
            let hits = comes & end.lt(zero);
            let waits = comes & zero.le(end);
            W::select(waits, W::splat(FAR), W::load(&row.separation)).store(&mut row.shown);
            self.struck |= W::bits(hits);
            let mass = W::select(hits, mass, zero);
            let speed = W::select(hits, -velocity, W::splat(1.0));
            let time = (separation / speed).max(W::splat(-pass.step)).min(h);
            let most = speed * W::splat(BEND_MAX);
            let bend = W::load(&row.accelerated) * (time * inv_h - half);
            let bend = bend.max(-most).min(most);
            let target = (restitution * (speed - bend) - bend).max(zero);
            (bend + bend - speed).store(&mut row.approach);
            target.store(&mut row.target);
            mass.store(&mut row.mass);
            time.store(&mut row.time);
            row.impulse = Lane::ZERO;
        }
        self.was_struck |= self.struck != 0;
    }

    /// Leaves a lane as it is for the rest of the round.
    pub fn let_be(&mut self, lane: usize) {
        self.rows.iter_mut().for_each(|row| row.mass.0[lane] = 0.0);
    }

    /// Visits the points that hit, in turn: pushes until they part as they are to.
    #[inline(always)]
    pub fn visit<W: Wide>(&mut self, rows: &mut NormalRows<'_, W>) {
        self.moving = 0;
        for sweep in 0..SWEEPS {
            rows.visit(|k, velocity| {
                let row = &mut self.rows[k];
                let (mass, old) = (W::load(&row.mass), W::load(&row.impulse));
                let missing = W::load(&row.target) - W::load(&row.borne) - velocity;
                let new = (old + mass * missing).max(W::zero());
                new.store(&mut row.impulse);
                if sweep == 0 {
                    let little = -(mass * W::load(&row.approach) * W::splat(SETTLED));
                    self.moving |= W::bits(little.lt((new - old).abs()));
                }
                new - old
            });
        }
    }

    /// Ends a round: does the accounts of its energy, and tells the bodies when they were hit (see
    /// [`SolverBodies::accept_impact`](crate::step::solver::bodies::SolverBodies::accept_impact)).
    ///
    /// # Safety
    /// Nobody else may touch the delays of the block's bodies meanwhile.
    #[inline(always)]
    pub unsafe fn end<W: Wide>(
        &mut self,
        rows: &NormalRows<'_, W>,
        block: &ContactBlock,
        delays: &DisjointMut<BodyState>,
    ) {
        let velocities = rows.velocities();
        let half = W::splat(0.5);
        let allowed = W::load(&self.restitution).max(W::splat(1.0));
        let (mut stopped, mut surplus) = (W::zero(), W::zero());
        let (mut weight, mut moment) = (W::zero(), W::zero());
        for (k, row) in self.rows.iter().enumerate() {
            let (impulse, approach) = (W::load(&row.impulse), W::load(&row.approach));
            stopped = stopped + impulse * approach;
            let velocity = velocities[k] + W::load(&row.borne);
            surplus = surplus + impulse * (velocity + allowed * approach) * half;
            weight = weight + impulse;
            moment = moment + impulse * W::load(&row.time);
        }
        stopped.store(&mut self.stopped);
        surplus.store(&mut self.surplus);
        for indices in &block.bodies {
            // SAFETY: the caller's promise.
            unsafe {
                let (mut motion, displacement) = gather_states::<W>(delays, indices);
                motion.linear.x = motion.linear.x + weight;
                motion.linear.y = motion.linear.y + moment;
                scatter_states(delays, indices, (motion, displacement));
            }
        }
    }

    /// Counts the impulses of a round in a lane: the share that its island went.
    pub fn settle(&mut self, lane: usize, share: Real) {
        self.rows.iter_mut().for_each(|row| row.given.0[lane] += share * row.impulse.0[lane]);
    }

    /// Ends the impact: friction acts under its normal impulses, which count into those of the step.
    ///
    /// # Safety
    /// Nobody else may touch the states of the block's bodies meanwhile.
    #[inline(always)]
    pub unsafe fn rub<W: Wide>(
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
        unsafe { points::rub::<W>(block, coulomb, states, given) };
    }
}
