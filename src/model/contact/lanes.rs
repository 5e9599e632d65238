//! The solver's data of contact manifolds, persistent from step to step, lane by lane.
//!
//! In a settled pile a step computes hardly any manifold. The data of other manifolds is that of the last
//! step, and the impulses are the solver's own. A pair is large, and random access to it is slow. The lanes
//! therefore stay filled. A lane is filled from its manifold only if it had another one before, or if the
//! pair was [renewed](super::PairStore::renew).
//!
//! For the same reason results are not written back to the manifolds in each step. Lanes are *dirty*, newer
//! than their pairs, until the pair is read, by the user or by the narrow phase, which recomputes it. Then
//! the pair is written back, once. Code that removes a manifold from its colour, or moves it to another place
//! there, writes it back before: the lane will be reused.
//!
//! The alternative, a write-back of all pairs in each step, cost a seventh of the step of a large pyramid.

use super::anchor_frame::AnchorFrame;
use super::input::ContactInput;
use super::manifold::{ContactManifold, ContactManifoldData};
use super::pair::ContactPair;
use super::report::ContactReport;
use super::store::PairId;
use crate::base::wide::{LANES, prefetch};
use crate::dim::math::{MAX_MANIFOLD_POINTS, Vector};
use crate::model::constraint_graph::{COLORS, ColorSlot, ManifoldRef, OVERFLOW};
use crate::model::island::NONE;
use core::sync::atomic::{AtomicU32, Ordering};
use std::sync::{Mutex, PoisonError};

/// Manifold of an empty lane.
const NO_MANIFOLD: ManifoldRef = ManifoldRef { pair: u32::MAX, manifold: u32::MAX };

/// The manifolds of a block.
#[derive(Clone, Debug)]
pub(crate) struct LaneBlock {
    /// The manifolds of the lanes.
    members: [ManifoldRef; LANES],
    /// Slots of their two bodies.
    pub slots: [[u32; LANES]; 2],
    /// Number of points of each.
    counts: [u8; LANES],
    pub input: ContactInput,
}

impl LaneBlock {
    const EMPTY: Self = Self {
        members: [NO_MANIFOLD; LANES],
        slots: [[NONE; LANES]; 2],
        counts: [0; LANES],
        input: ContactInput::EMPTY,
    };

    /// Assigns a manifold, or none, to a lane. Returns whether the lane had another manifold.
    pub fn assign(&mut self, lane: usize, manifold: Option<ManifoldRef>) -> bool {
        let manifold = manifold.unwrap_or(NO_MANIFOLD);
        core::mem::replace(&mut self.members[lane], manifold) != manifold
    }

    /// Removes the manifold of a lane.
    pub fn clear(&mut self, lane: usize) {
        if self.assign(lane, None) {
            [self.slots[0][lane], self.slots[1][lane]] = [NONE; 2];
            self.counts[lane] = 0;
            self.input.clear(lane);
        }
    }

    /// Returns whether all lanes are empty.
    pub fn is_empty(&self) -> bool {
        self.members == [NO_MANIFOLD; LANES]
    }

    /// Number of points in all lanes.
    pub fn point_count(&self) -> usize {
        self.counts.iter().map(|&count| usize::from(count)).sum()
    }

    /// Returns whether a lane stores this manifold.
    pub fn stores(&self, lane: usize, manifold: ManifoldRef) -> bool {
        self.members[lane] == manifold
    }

    /// Fills a lane from a manifold of a pair of bodies in these slots.
    pub fn fill(&mut self, lane: usize, manifold: u32, pair: &ContactPair, slots: [u32; 2]) {
        let input = &mut self.input;
        let data = &pair.manifolds[manifold as usize].data;
        [self.slots[0][lane], self.slots[1][lane]] = slots;
        self.counts[lane] = data.points.len() as u8;
        let frozen_angle = if pair.anchor_frame.may_freeze {
            AnchorFrame::frozen_angle(data.friction)
        } else {
            0.0
        };
        input.anchor_frame.set_lane(lane, &pair.anchor_frame, data.anchor_normal, frozen_angle);
        input.mass_factors[0].0[lane] = if data.relative_dominance > 0 { 0.0 } else { 1.0 };
        input.mass_factors[1].0[lane] = if data.relative_dominance < 0 { 0.0 } else { 1.0 };
        input.friction.0[lane] = data.friction;
        input.restitution.0[lane] = data.restitution;
        input.tangent_velocity.set_lane(lane, data.tangent_velocity);
        input.friction_impulse.set_lane(lane, data.warmstart_friction);
        input.torsional_impulse.0[lane] = data.warmstart_torsion;
        for k in 0..MAX_MANIFOLD_POINTS {
            let Some(point) = data.points.get(k) else {
                input.leave_out(k, lane);
                continue;
            };
            input.arms[k].set_lane(lane, point.arm);
            input.anchor_separations[k].0[lane] = point.anchor_dist;
            input.present[k].0[lane] = 1.0;
            input.impulses[k].0[lane] = point.warmstart_impulse;
            input.set_tangent_impulse(k, lane, point.warmstart_tangent_impulse);
        }
    }
}

/// Writes a report to its manifold, and the friction impulse with which the next step starts.
fn write_back(report: &ContactReport, friction: Vector, data: &mut ContactManifoldData) {
    if !report.is_sound() {
        return data.clear_impulses();
    }
    data.normal = report.normal();
    data.last_friction = report.friction_impulse();
    data.warmstart_friction = friction;
    data.warmstart_torsion = report.torsional_impulse();
    for (k, point) in data.points.iter_mut().enumerate() {
        point.point = report.point(k);
        point.dist = report.separation(k);
        point.impulse = report.total(k);
        point.warmstart_impulse = report.impulse(k);
    }
}

/// By colour, the overflow last: a number of blocks.
pub(crate) type LaneCapacity = [usize; COLORS as usize + 1];

/// All lanes; see the [module](self).
#[derive(Debug)]
pub(crate) struct ContactLanes {
    pub blocks: Vec<LaneBlock>,
    /// Reports of the last stored step.
    pub reports: Vec<[ContactReport; LANES]>,
    /// Whether each point has its own friction.
    pub has_friction_per_point: bool,
    /// By colour: its first block, if lanes are in the order of the constraint graph and write-backs may be
    /// pending; else nothing.
    starts: Vec<u32>,
    /// Number of blocks per colour, including empty ones.
    pub capacity: LaneCapacity,
    /// Number of times that lanes were stored.
    stores: u32,
    /// By pair: the store count at its last write-back. Newer pairs, beyond the end, have no results.
    written: Vec<AtomicU32>,
    /// Locked by a write-back behind a shared reference.
    writing: Mutex<()>,
}

impl Default for ContactLanes {
    fn default() -> Self {
        Self {
            blocks: Vec::new(),
            reports: Vec::new(),
            has_friction_per_point: false,
            starts: Vec::new(),
            capacity: [0; _],
            stores: 0,
            written: Vec::new(),
            writing: Mutex::default(),
        }
    }
}

impl Clone for ContactLanes {
    fn clone(&self) -> Self {
        let mut copy = Self::default();
        copy.clone_from(self);
        copy
    }

    fn clone_from(&mut self, source: &Self) {
        let Self {
            blocks,
            reports,
            has_friction_per_point,
            starts,
            capacity,
            stores,
            written,
            writing: _,
        } = source;
        self.blocks.clone_from(blocks);
        self.reports.clone_from(reports);
        self.starts.clone_from(starts);
        (self.has_friction_per_point, self.capacity, self.stores) =
            (*has_friction_per_point, *capacity, *stores);
        self.written.clear();
        self.written
            .extend(written.iter().map(|stores| AtomicU32::new(stores.load(Ordering::Acquire))));
    }
}

/// Reserves this number of blocks in all. They are large: the reserve is an eighth more, and not twice as
/// much.
pub(crate) fn reserve_blocks<T>(blocks: &mut Vec<T>, count: usize) {
    if count > blocks.capacity() {
        blocks.reserve_exact(count + count / 8 - blocks.len());
    }
}

impl ContactLanes {
    /// Reserves this number of blocks. Lanes of earlier ones stay filled.
    pub fn resize(&mut self, block_count: usize) {
        reserve_blocks(&mut self.blocks, block_count);
        self.blocks.resize_with(block_count, || LaneBlock::EMPTY);
        reserve_blocks(&mut self.reports, block_count);
        self.reports.resize(block_count, [ContactReport::EMPTY; LANES]);
    }

    /// Empties all lanes, which must be filled again. No write-back is pending.
    pub fn invalidate(&mut self) {
        debug_assert!(!self.has_pending_write_backs());
        self.blocks.clear();
    }

    /// Returns whether results of lanes may still have to be written back to their pairs.
    pub fn has_pending_write_backs(&self) -> bool {
        !self.starts.is_empty()
    }

    /// By colour, the first block of lanes with pending write-backs; empty without pending ones.
    pub fn starts(&self) -> &[u32] {
        &self.starts
    }

    /// Marks all pairs as written back.
    pub fn mark_written_back(&mut self) {
        self.starts.clear();
    }

    /// Marks the write-backs of the lanes as pending. Those of a colour, in the order of the graph, begin
    /// at one of `starts`; if there are none, all pairs are up to date. `ids` is above the ids of all pairs.
    pub fn go_ahead(&mut self, starts: &[u32], ids: usize) {
        self.starts.clear();
        self.starts.extend_from_slice(starts);
        self.stores = self.stores.wrapping_add(1);
        self.written.resize_with(ids, AtomicU32::default);
    }

    /// Calls `write_back` for a pair, unless it is up to date: by one thread at a time, and not again until
    /// lanes are stored.
    pub fn complete(&self, id: PairId, write_back: impl FnOnce()) {
        if !self.is_written(id) {
            let _telling = self.writing.lock().unwrap_or_else(PoisonError::into_inner);
            if !self.is_written(id) {
                write_back();
            }
        }
    }

    /// Writes the results of a pair back, unless it is up to date.
    pub fn write_back(&self, id: PairId, pair: &mut ContactPair) {
        if self.is_written(id) {
            return;
        }
        for (index, manifold) in pair.manifolds.iter_mut().enumerate() {
            let at = ManifoldRef { pair: id, manifold: index as u32 };
            if let Some((block, lane)) = self.find(at, manifold) {
                self.write_back_manifold(block, lane, manifold);
            }
        }
        self.written[id as usize].store(self.stores, Ordering::Release);
    }

    /// The normal of a manifold of a pair after the last step, whether or not it is written back.
    pub fn normal_of(&self, id: PairId, index: usize, manifold: &ContactManifold) -> Vector {
        let at = ManifoldRef { pair: id, manifold: index as u32 };
        let ahead = if self.is_written(id) { None } else { self.find(at, manifold) };
        let report = ahead.map(|(block, lane)| &self.reports[block][lane]);
        report
            .filter(|report| report.is_sound())
            .map_or(manifold.data.normal, ContactReport::normal)
    }

    /// Writes the results of a lane back to its manifold.
    pub fn write_back_manifold(&self, block: usize, lane: usize, manifold: &mut ContactManifold) {
        let (data, input) = (&mut manifold.data, &self.blocks[block].input);
        write_back(&self.reports[block][lane], input.friction_impulse.lane(lane), data);
        if self.has_friction_per_point {
            for (k, point) in data.points.iter_mut().enumerate() {
                point.warmstart_tangent_impulse = input.tangent_impulse(k, lane);
            }
        }
    }

    /// Prefetches the results and the lane of a pair that will be written back.
    pub fn prefetch(&self, pair: &ContactPair) {
        let first = pair.manifolds.first().filter(|_| self.has_pending_write_backs());
        if let Some((block, lane)) = first.and_then(|manifold| self.place_of(manifold)) {
            prefetch(&self.reports[block][lane]);
            prefetch(&self.blocks[block].members);
        }
    }

    /// Returns whether the results of a pair are written back, or each manifold with a colour has a lane.
    /// True from the solver to the next edit of the colours.
    pub fn has_results_of(&self, id: PairId, pair: &ContactPair) -> bool {
        let is_apart = |slot: ColorSlot| slot.color == OVERFLOW;
        self.is_written(id)
            || (0..).zip(&pair.manifolds).all(|(index, manifold)| {
                let at = ManifoldRef { pair: id, manifold: index };
                manifold.slot.is_none_or(is_apart) || self.find(at, manifold).is_some()
            })
    }

    /// Returns whether the manifold of each lane with a pending write-back has its place at this lane.
    /// `manifold_of` finds a manifold.
    pub fn are_indexed<'a>(
        &self,
        manifold_of: impl Fn(ManifoldRef) -> Option<&'a ContactManifold>,
    ) -> bool {
        // The blocks before the first colour are those of the overflow.
        let first = self.starts.first().map_or(self.blocks.len(), |&first| first as usize);
        self.blocks.iter().enumerate().skip(first).all(|(block, lanes)| {
            let mut members = lanes.members.iter().enumerate();
            members.all(|(lane, &at)| {
                let place = || self.place_of(manifold_of(at)?);
                at == NO_MANIFOLD || place() == Some((block, lane))
            })
        })
    }

    #[inline]
    fn is_written(&self, id: PairId) -> bool {
        let stores = self.written.get(id as usize);
        !self.has_pending_write_backs()
            || stores.is_none_or(|stores| stores.load(Ordering::Acquire) == self.stores)
    }

    /// The block and the lane of a manifold.
    fn find(&self, at: ManifoldRef, manifold: &ContactManifold) -> Option<(usize, usize)> {
        self.place_of(manifold).filter(|&(block, lane)| self.blocks[block].stores(lane, at))
    }

    /// The indices of the block and the lane of a manifold, unless the lane was reused.
    fn place_of(&self, manifold: &ContactManifold) -> Option<(usize, usize)> {
        let ColorSlot { color, position } = manifold.slot?;
        let start = *self.starts.get(color as usize)? as usize;
        let (block, lane) = (start + position as usize / LANES, position as usize % LANES);
        (block < self.blocks.len().min(self.reports.len())).then_some((block, lane))
    }
}
