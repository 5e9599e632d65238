//! The contacts that hit in a round, side by side.
//!
//! Few of the contacts with restitution hit in a round, and seldom two of one block. Each round iterates
//! until it converges, so the data of an iteration is copied to separate blocks. 2D `spinner` then visits a
//! quarter of the blocks. Lanes do not depend on each other, and the order of colours is kept.

use super::points::NormalRows;
use super::rows::{ImpactBlock, ImpactMark};
use super::{ImpactIsland, lanes};
use crate::base::disjoint::DisjointMut;
use crate::base::wide::{LANES, Lane, Wide};
use crate::dim::contact::ContactBlock;
use crate::dim::math::{MAX_MANIFOLD_POINTS, Real};
use crate::dim::state::{BodyState, READ_ONLY};
use crate::step::solver::blocks::block_kernel;
use crate::step::solver::contacts::Blocks;
use crate::step::solver::impact_time::ImpactTime;
use crate::step::solver::restitution::{HitRow, POINT_ITERATIONS};
use core::ops::Range;

/// All contacts of a round.
#[derive(Default)]
pub(super) struct Active {
    pub blocks: Vec<ActiveBlock>,
    /// Blocks of one colour are contiguous.
    pub colors: Vec<Range<usize>>,
    /// The islands that they are in.
    pub islands: Vec<u32>,
}

impl Active {
    pub fn clear(&mut self) {
        self.blocks.clear();
        self.colors.clear();
        self.islands.clear();
    }

    /// Includes an island.
    pub fn include(&mut self, island: u32, impact_island: &mut ImpactIsland) {
        if !impact_island.is_active {
            impact_island.is_active = true;
            self.islands.push(island);
        }
    }

    /// Copies the hitting contacts of a colour in islands with iterations left.
    pub fn add_color(
        &mut self,
        color: Range<usize>,
        impacts: &[ImpactBlock],
        marks: &[ImpactMark],
        contacts: Blocks<'_>,
        impact_islands: &mut [ImpactIsland],
    ) {
        let start = self.blocks.len();
        let active = marks[color.clone()].iter().map(|mark| mark.active);
        for (index, active) in color.zip(active).filter(|&(_, active)| active != 0) {
            let impact = &impacts[index];
            for lane in lanes(active) {
                let island = impact.islands[lane];
                let impact_island = &mut impact_islands[island as usize];
                if impact_island.iterations == 0 {
                    continue;
                }
                self.include(island, impact_island);
                if self.blocks[start..].last().is_none_or(ActiveBlock::is_full) {
                    self.blocks.push(ActiveBlock::EMPTY);
                }
                // SAFETY: no task runs meanwhile.
                let (contact, _) = unsafe { contacts.get(impact.at) };
                let last = self.blocks.len() - 1;
                self.blocks[last].push(index, lane, impact, contact);
            }
        }
        if start < self.blocks.len() {
            self.colors.push(start..self.blocks.len());
        }
    }
}

/// One contact point of each lane.
#[derive(Copy, Clone, Debug)]
struct RoundRow {
    active: HitRow<Lane>,
    /// The impulse of this round.
    impulse: Lane,
}

/// Up to [`LANES`] contacts of one colour that hit.
#[derive(Clone, Debug)]
pub(in super::super) struct ActiveBlock {
    /// Copies of the input of normal impulses.
    contact: ContactBlock,
    rows: [RoundRow; MAX_MANIFOLD_POINTS],
    restitution: Lane,
    /// The block and the lane of origin of each lane.
    from: [(u32, u32); LANES],
    /// The island of each lane.
    pub islands: [u32; LANES],
    count: usize,
    /// One bit per lane: set if the last iteration changed the lane.
    pub moving: u32,
    /// The sum of impulse times approach in this round (negative), and the excess of energy above the bound.
    pub dissipated: Lane,
    pub energy_gain: Lane,
}

impl ActiveBlock {
    /// No contact in any lane.
    pub const EMPTY: Self = {
        let zero = Lane::ZERO;
        Self {
            contact: ContactBlock::EMPTY,
            rows: [RoundRow { active: HitRow::ZERO, impulse: zero }; MAX_MANIFOLD_POINTS],
            restitution: zero,
            from: [(0, 0); LANES],
            islands: [0; LANES],
            count: 0,
            moving: 0,
            dissipated: zero,
            energy_gain: zero,
        }
    };

    fn is_full(&self) -> bool {
        self.count == LANES
    }

    /// The lanes that are taken.
    pub fn lanes(&self) -> Range<usize> {
        0..self.count
    }

    /// The two bodies of each contact.
    pub fn bodies(&self) -> impl Iterator<Item = u32> {
        self.contact.bodies.iter().flat_map(|bodies| &bodies[self.lanes()]).copied()
    }

    /// Copies a lane of a block.
    pub fn push(
        &mut self,
        index: usize,
        lane: usize,
        impact: &ImpactBlock,
        contact: &ContactBlock,
    ) {
        let to = self.count;
        self.count += 1;
        self.contact.copy_normal_lane(to, contact, lane);
        self.restitution.0[to] = impact.restitution.0[lane];
        self.islands[to] = impact.islands[lane];
        self.from[to] = (index as u32, lane as u32);
        for (row, active) in self.rows.iter_mut().zip(impact.active_rows(lane)) {
            row.active.set_lane(to, &active);
        }
    }

    /// Leaves a lane as it is for the rest of the round.
    pub fn deactivate(&mut self, lane: usize) {
        self.rows.iter_mut().for_each(|row| row.active.mass.0[lane] = 0.0);
    }

    /// Commits the impulses of the round, scaled by the fraction of each lane's island.
    pub fn commit(&self, impacts: &mut [ImpactBlock], fraction: impl Fn(u32) -> Real) {
        for lane in self.lanes() {
            let (fraction, (index, from)) = (fraction(self.islands[lane]), self.from[lane]);
            let impulses = self.rows.map(|row| fraction * row.impulse.0[lane]);
            impacts[index as usize].give(from as usize, impulses);
        }
    }

    /// Iterates over the points in order, and applies impulses until they separate at their target
    /// velocities. A lane has converged after an iteration without change. It needs one if at most one point
    /// hits.
    ///
    /// # Safety
    /// The caller has exclusive access to the states of the block's bodies.
    #[inline(always)]
    pub unsafe fn iterate<W: Wide>(&mut self, states: &DisjointMut<BodyState>) {
        let Self { contact, rows, moving, .. } = self;
        // SAFETY: the caller's promise.
        let mut normals = unsafe { NormalRows::<W>::gather(states, contact) };
        let zero = W::zero();
        let mut goes_on = zero.le(zero);
        for iteration in 0..POINT_ITERATIONS {
            let mut changes = zero.lt(zero);
            normals.iterate(|k, velocity| {
                let RoundRow { active, impulse } = &mut rows[k];
                let (active, old) = (HitRow::<W>::load(active), W::load(impulse));
                let new = W::select(goes_on, active.impulse(velocity, old), old);
                new.store(impulse);
                changes = changes | active.tolerance().lt((new - old).abs());
                new - old
            });
            if iteration == 0 {
                *moving = W::bits(changes);
                goes_on = have_several::<W>(rows);
            }
            goes_on = goes_on & changes;
            if !W::any(goes_on) {
                break;
            }
        }
        // SAFETY: the caller's promise.
        unsafe { normals.scatter(states) };
    }

    /// Ends the round: sums up its energy, and records the impact times of bodies (see
    /// [`SolverBodies::accept_impact`](crate::step::solver::bodies::SolverBodies::accept_impact)).
    ///
    /// # Safety
    /// The caller has exclusive access to the states and impact times of the block's bodies.
    #[inline(always)]
    pub unsafe fn end<W: Wide>(
        &mut self,
        states: &DisjointMut<BodyState>,
        times: &DisjointMut<ImpactTime>,
    ) {
        // SAFETY: the caller's promise.
        let velocities = unsafe { NormalRows::<W>::gather(states, &self.contact) }.velocities();
        let restitution = W::load(&self.restitution);
        let (mut dissipated, mut energy_gain) = (W::zero(), W::zero());
        let (mut weight, mut moment) = (W::zero(), W::zero());
        for (k, RoundRow { active, impulse }) in self.rows.iter().enumerate() {
            let (active, impulse) = (HitRow::<W>::load(active), W::load(impulse));
            let [of_approach, gain] = active.energies(velocities[k], impulse, restitution);
            dissipated = dissipated + of_approach;
            energy_gain = energy_gain + gain;
            weight = weight + impulse;
            moment = moment + impulse * active.time;
        }
        dissipated.store(&mut self.dissipated);
        energy_gain.store(&mut self.energy_gain);
        let mut sums = [Lane::ZERO; 2];
        weight.store(&mut sums[0]);
        moment.store(&mut sums[1]);
        let [weight, moment] = sums;
        for lane in self.lanes() {
            let time = ImpactTime { weight: weight.0[lane], moment: moment.0[lane] };
            let pair = self.contact.bodies.map(|side| side[lane]);
            for body in pair.into_iter().filter(|body| body & READ_ONLY == 0) {
                // SAFETY: the caller's promise.
                unsafe { *times.get_mut(body as usize) += time };
            }
        }
    }
}

/// Returns the lanes in which more than one point hits.
#[inline(always)]
fn have_several<W: Wide>(rows: &[RoundRow; MAX_MANIFOLD_POINTS]) -> W::Mask {
    let zero = W::zero();
    let (mut one, mut several) = (zero.lt(zero), zero.lt(zero));
    for row in rows {
        let hits = zero.lt(W::load(&row.active.mass));
        several = several | (one & hits);
        one = one | hits;
    }
    several
}

/// The operation on each block.
#[derive(Copy, Clone)]
pub(super) enum Phase {
    Iterate,
    End,
}

block_kernel! {
    /// A turn, for some blocks of one colour.
    pub(super) struct Round<'a> {
        phase: Phase,
        blocks: DisjointMut<'a, ActiveBlock>,
        /// Velocities before any impulse of the substep.
        states: DisjointMut<'a, BodyState>,
        times: DisjointMut<'a, ImpactTime>,
    }
    |index| {
        let block = blocks.get_mut(index);
        match phase {
            Phase::Iterate => block.iterate::<W>(&states),
            Phase::End => block.end::<W>(&states, &times),
        }
    }
}
