//! Contact constraints: from manifolds to lane-wide blocks, through the passes, and back.

mod follow;
mod load;
pub(super) mod passes;
mod prepare;
mod soft_row;
mod store_impulses;

use super::blocks::{Layout, OverflowOrder, block_kernel, for_each_color};
use super::bodies::SolverBodies;
use super::context::{ImpulseOutput, SolverPass, SolverSettings};
use super::ledger::{Entry, Ledger, deep_overlap};
use crate::base::disjoint::DisjointMut;
use crate::base::tasks::Tasks;
use crate::base::wide::{Kernel, LANES, Lane, Wide};
use crate::dim::contact::{ContactBlock, CoulombBlock};
use crate::dim::math::Real;
use crate::dim::state::{BodyPose, BodyState};
use crate::model::constraint_graph::ManifoldRef;
use crate::model::contact::{ContactLanes, ContactReport, LaneBlock, NarrowPhase};
use crate::model::frozen::Frozen;
use crate::model::params::ContactPass;
use core::ops::Range;
use core::sync::atomic::{AtomicBool, Ordering};
use follow::FollowContext;
pub(super) use load::ContactLoadContext;
pub(super) use passes::{solve_friction, values_at};
pub(super) use prepare::{PrepareContext, prepare};
pub(super) use store_impulses::store_impulses;

/// Number of blocks per parallel task (a microsecond or two).
const BLOCKS_PER_TASK: usize = 8;

/// All contact constraints of a step.
#[derive(Default)]
pub(super) struct SolverContacts {
    /// Blocks of one colour are contiguous.
    blocks: Vec<ContactBlock>,
    /// The lanes of the narrow phase while they are borrowed, otherwise a separate set.
    lanes: ContactLanes,
    are_on_loan: bool,
    /// Whether the lanes begin with a reduced fraction of the last impulses.
    lanes_are_scaled: bool,
    /// By colour, its first block, if each colour is solved in the order of the graph; else empty.
    starts: Vec<u32>,
    /// Friction per point of each block; empty with the standard friction model.
    coulomb: Vec<CoulombBlock>,
    layout: Layout<ManifoldRef>,
    overflow: OverflowOrder,
    /// Manifolds of links, which have no lanes.
    of_links: Vec<ManifoldRef>,
    point_count: usize,
    /// Whether a contact is deep enough that its correction may eject bodies.
    has_deep_overlap: bool,
}

impl SolverContacts {
    /// Number of manifolds.
    pub fn len(&self) -> usize {
        self.layout.len()
    }

    /// Number of contact points in them.
    pub fn point_count(&self) -> usize {
        self.point_count
    }

    /// Discards the results of the step.
    pub fn give_back(&mut self, narrow_phase: &mut Frozen<'_, NarrowPhase>) {
        if self.lanes_are_scaled {
            self.lanes.invalidate();
        }
        if self.are_on_loan {
            *narrow_phase.lanes_mut().0 = core::mem::take(&mut self.lanes);
        }
    }

    /// Prepares the constraints of the manifolds, and applies the last step's impulses to the bodies.
    pub fn prepare_and_warm_start(&mut self, bodies: &mut SolverBodies, pass: &SolverPass<'_>) {
        let &SolverPass { params, simd, tasks, .. } = pass;
        let rows = if pass.has_friction_per_point() { self.blocks.len() } else { 0 };
        self.coulomb.resize(rows, CoulombBlock::EMPTY);
        let (prediction, half_step) = (params.prediction_distance(), 0.5 * params.dt);
        debug_assert!(self.have_states(bodies), "lanes name bodies of this step");
        let (poses, states) = bodies.shared();
        let lanes = &self.lanes.blocks[..];
        let blocks = Blocks::new(&mut self.blocks, &mut self.coulomb);
        let (deep, has_deep_overlap) = (deep_overlap(&pass.contacts), AtomicBool::new(false));
        for_each_color(self.layout.colors(), tasks, BLOCKS_PER_TASK, |range| {
            if simd.run(Prepare {
                range,
                lanes,
                blocks,
                poses,
                states,
                prediction,
                half_step,
                deep,
            }) {
                has_deep_overlap.store(true, Ordering::Relaxed);
            }
        });
        self.has_deep_overlap = has_deep_overlap.into_inner();
    }

    /// Returns whether any overlap is deep.
    pub fn has_deep_overlap(&self) -> bool {
        self.has_deep_overlap
    }

    /// Notes deep overlaps and driven contacts.
    pub fn note_in(&self, ledger: &mut Ledger, bodies: &SolverBodies, pass: &SolverPass<'_>) {
        let deep = self.has_deep_overlap.then(|| deep_overlap(&pass.contacts));
        // Blocks beyond the colour's count keep the data of an earlier step.
        for index in self.layout.colors().iter().flat_map(Clone::clone) {
            let (block, input) = (&self.blocks[index], &self.lanes.blocks[index].input);
            ledger.note_contacts(block, input, deep, bodies);
        }
    }

    /// Gives the contacts of uneven bodies their inertias anew, after a substep.
    pub fn follow(&mut self, bodies: &mut SolverBodies, pass: &SolverPass<'_>) {
        if !bodies.any_uneven() {
            return;
        }
        let SolverBodies { poses, uneven, before, .. } = bodies;
        let before = &DisjointMut::new(before);
        let context = FollowContext { poses, uneven, before };
        let blocks = Blocks::new(&mut self.blocks, &mut self.coulomb);
        let (lanes, simd) = (&self.lanes.blocks[..], pass.simd);
        for_each_color(self.layout.colors(), pass.tasks, BLOCKS_PER_TASK, |range| {
            simd.run(Follow { range, lanes, blocks, context });
        });
    }

    /// Begins a substep: scales its warm-start impulses as those of bodies.
    pub fn begin_substep(&mut self, pass: &SolverPass<'_>) {
        let factor = pass.params.warmstart_coefficient;
        if factor != 1.0 {
            let factors = Lane::splat(factor);
            self.blocks.iter_mut().for_each(|block| block.scale_impulses(&factors));
            self.coulomb.iter_mut().for_each(|rows| rows.scale_impulses(&factors));
        }
    }

    /// Leaves all islands the fractions of their impulses that they keep.
    pub fn limit(&mut self, ledger: &Ledger, entry: Entry, bodies: &SolverBodies) {
        // Blocks that no colour fills name bodies of an earlier step.
        for index in self.layout.colors().iter().flat_map(Clone::clone) {
            let block = &mut self.blocks[index];
            if let Some(factors) = ledger.kept_by(&block.bodies, bodies) {
                if entry == Entry::End {
                    take_off_totals(block, &factors);
                }
                block.scale_impulses(&factors);
                self.coulomb.get_mut(index).into_iter().for_each(|it| it.scale_impulses(&factors));
            }
        }
    }

    /// Solves all constraints once, with bias.
    pub fn solve(&mut self, bodies: &mut SolverBodies, pass: &SolverPass<'_>) {
        let (_, states) = bodies.shared();
        let blocks = Blocks::new(&mut self.blocks, &mut self.coulomb);
        let (simd, pass, tasks) = (pass.simd, &pass.contacts, pass.tasks);
        for_each_color(self.layout.colors(), tasks, BLOCKS_PER_TASK, |range| {
            simd.run(Solve { range, blocks, states, pass });
        });
    }

    /// Solves all constraints once, without bias and with friction.
    pub fn relax(&mut self, bodies: &mut SolverBodies, pass: &SolverPass<'_>) {
        let (_, states) = bodies.shared();
        let blocks = Blocks::new(&mut self.blocks, &mut self.coulomb);
        let (simd, pass, tasks) = (pass.simd, &pass.contacts, pass.tasks);
        for_each_color(self.layout.colors(), tasks, BLOCKS_PER_TASK, |range| {
            simd.run(Relax { range, blocks, states, pass });
        });
        debug_assert!(!self.has_negative_numbers(), "contacts push");
    }

    /// Returns whether the bodies of all filled lanes have a state.
    fn have_states(&self, bodies: &SolverBodies) -> bool {
        self.layout.colors().iter().flat_map(Clone::clone).all(|index| {
            let [first, second] = &self.lanes.blocks[index].input.bodies;
            let count = self.layout.block(index).len();
            first[..count].iter().chain(&second[..count]).all(|&body| bodies.has_state(body))
        })
    }

    /// Returns whether an effective mass or a normal impulse is negative. NaN is not: a diverging world may
    /// contain NaN until the divergence check.
    fn has_negative_numbers(&self) -> bool {
        let points = self.blocks.iter().flat_map(|block| &block.points);
        let numbers = points.flat_map(|point| point.mass.0.iter().chain(&point.impulse.0));
        numbers.into_iter().any(|&number| number < 0.0)
    }

    /// The blocks of each colour.
    pub fn colors(&self) -> &[Range<usize>] {
        self.layout.colors()
    }

    /// The manifolds of each block.
    pub fn lanes(&self) -> &[LaneBlock] {
        &self.lanes.blocks
    }

    /// The manifolds of links, which have no lanes.
    pub fn of_links(&self) -> &[ManifoldRef] {
        &self.of_links
    }

    /// The block at an index.
    pub fn block_mut(&mut self, index: usize) -> &mut ContactBlock {
        &mut self.blocks[index]
    }

    /// The blocks, for impacts.
    pub fn blocks(&mut self) -> Blocks<'_> {
        Blocks::new(&mut self.blocks, &mut self.coulomb)
    }

    /// Stores the impulses for the next step, and writes back the manifolds whose lanes are not indexed.
    pub fn store(&mut self, output: &mut ImpulseOutput<'_>) {
        let ImpulseOutput { settings, narrow_phase, .. } = output;
        let SolverSettings { pace, simd, tasks, .. } = *settings;
        let withheld = pace.reference_ratio - 1.0;
        let lanes = DisjointMut::new(&mut self.lanes.blocks);
        let reports = DisjointMut::new(&mut self.lanes.reports);
        let blocks = Blocks::new(&mut self.blocks, &mut self.coulomb);
        let layout = &self.layout;
        tasks.par_for(layout.block_count(), BLOCKS_PER_TASK, |range| {
            simd.run(Store { range, layout, lanes, reports, blocks, withheld });
        });
        self.lanes.has_friction_per_point = !self.coulomb.is_empty();
        for color in self.layout.colors().iter().take_while(|color| self.needs_write_back(color)) {
            self.write_back(color.clone(), narrow_phase, tasks);
        }
        if self.are_on_loan {
            self.lanes.go_ahead(&self.starts, narrow_phase.contacts.id_bound());
            *narrow_phase.lanes_mut().0 = core::mem::take(&mut self.lanes);
            debug_assert!(narrow_phase.has_indexed_lanes(), "a lane is that of its manifold");
        }
    }

    /// Returns whether the blocks of a colour must write back to their manifolds now. The overflow comes
    /// first, in an order of its own.
    fn needs_write_back(&self, color: &Range<usize>) -> bool {
        self.starts.first().is_none_or(|&first| color.start < first as usize)
    }

    fn write_back(
        &self,
        color: Range<usize>,
        narrow_phase: &mut Frozen<'_, NarrowPhase>,
        tasks: Tasks<'_>,
    ) {
        let pairs = narrow_phase.share_pairs();
        tasks.par_for(color.len(), BLOCKS_PER_TASK, |range| {
            for index in color.start + range.start..color.start + range.end {
                let soon = self.layout.block_or_none(index + 1);
                soon.iter().for_each(|later| pairs.prefetch(later.pair as usize));
                for (lane, at) in self.layout.block(index).iter().enumerate() {
                    // SAFETY: the manifolds of a pair have the same bodies, so no two of them have the same
                    // colour.
                    if let Some(pair) = unsafe { pairs.get_mut(at.pair as usize) } {
                        let manifold = &mut pair.manifolds[at.manifold as usize];
                        self.lanes.write_back_manifold(index, lane, manifold);
                    }
                }
            }
        });
    }
}

/// All blocks, and the friction per point of each if the model has it.
#[derive(Clone, Copy)]
pub(super) struct Blocks<'a> {
    contacts: DisjointMut<'a, ContactBlock>,
    coulomb: DisjointMut<'a, CoulombBlock>,
}

impl<'a> Blocks<'a> {
    fn new(contacts: &'a mut [ContactBlock], coulomb: &'a mut [CoulombBlock]) -> Self {
        Self { contacts: DisjointMut::new(contacts), coulomb: DisjointMut::new(coulomb) }
    }

    /// # Safety
    /// The caller must own the block with this index exclusively.
    #[inline(always)]
    pub unsafe fn get(&self, index: usize) -> (&'a mut ContactBlock, Option<&'a mut CoulombBlock>) {
        // SAFETY: the caller's promise; every index of a colour is one of a block.
        unsafe {
            let block = self.contacts.get_mut(index);
            let per_point = index < self.coulomb.len();
            (block, if per_point { Some(self.coulomb.get_mut(index)) } else { None })
        }
    }
}

/// See [`prepare()`].
struct Prepare<'a> {
    range: Range<usize>,
    lanes: &'a [LaneBlock],
    blocks: Blocks<'a>,
    poses: &'a [BodyPose],
    states: DisjointMut<'a, BodyState>,
    prediction: Real,
    half_step: Real,
    /// The overlap from which on contacts are reported.
    deep: Real,
}

impl Kernel for Prepare<'_> {
    /// Whether one of the contacts is deep.
    type Output = bool;

    #[inline(always)]
    fn run<W: Wide>(self) -> bool {
        let Self { poses, states, prediction, half_step, .. } = self;
        let mut least = W::zero();
        for index in self.range {
            // SAFETY: each block belongs to one task, and constraints of one colour have no common dynamic
            // body.
            unsafe {
                let (block, coulomb) = self.blocks.get(index);
                let input = &self.lanes[index].input;
                let context = PrepareContext { poses, states: &states, prediction, half_step };
                prepare::<W>(input, block, coulomb, context);
                for point in &block.points {
                    least = least.min(W::load(&point.separation));
                }
            }
        }
        W::any(least.lt(W::splat(-self.deep)))
    }
}

/// Takes the rest of this substep's impulses off the sums, if these fractions are kept.
fn take_off_totals(block: &mut ContactBlock, kept: &Lane) {
    for (total, point) in block.totals.iter_mut().zip(&block.points) {
        let lanes = total.0.iter_mut().zip(point.impulse.0).zip(kept.0);
        lanes.for_each(|((total, impulse), kept)| *total -= impulse * (1.0 - kept));
    }
}

block_kernel! {
    /// See [`store_impulses`].
    struct Store<'a> {
        layout: &'a Layout<ManifoldRef>,
        lanes: DisjointMut<'a, LaneBlock>,
        reports: DisjointMut<'a, [ContactReport; LANES]>,
        blocks: Blocks<'a>,
        withheld: Real,
    }
    |index| if !layout.block(index).is_empty() {
        let (block, coulomb) = blocks.get(index);
        let input = &mut lanes.get_mut(index).input;
        let reports = reports.get_mut(index);
        store_impulses::<W>(block, coulomb.as_deref(), input, reports, withheld);
    }
}

block_kernel! {
    /// See [`follow::follow`].
    struct Follow<'a> {
        lanes: &'a [LaneBlock],
        blocks: Blocks<'a>,
        context: FollowContext<'a>,
    }
    |index| follow::follow::<W>(&lanes[index].input, blocks.get(index), context)
}

block_kernel! {
    /// See [`passes::solve`].
    struct Solve<'a> {
        blocks: Blocks<'a>,
        states: DisjointMut<'a, BodyState>,
        pass: &'a ContactPass,
    }
    |index| passes::solve::<W>(blocks.get(index).0, &states, pass)
}

block_kernel! {
    /// See [`passes::relax`].
    struct Relax<'a> {
        blocks: Blocks<'a>,
        states: DisjointMut<'a, BodyState>,
        pass: &'a ContactPass,
    }
    |index| {
        let (block, coulomb) = blocks.get(index);
        passes::relax::<W>(block, coulomb, &states, pass);
    }
}
