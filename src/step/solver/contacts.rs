//! Contact constraints: from manifolds to lane-wide blocks, through the passes, and back.

use super::bodies::SolverBodies;
use super::impacts::{ImpactContext, Impacts};
use super::layout::Layout;
use super::multibodies::SolverMultibodies;
use super::overflow::OverflowOrder;
use super::recovery::{Recovery, deep_overlap};
use super::store_impulses::store_impulses;
use crate::base::disjoint::DisjointMut;
use crate::base::tasks::Tasks;
use crate::base::wide::{Kernel, LANES, Lane, Simd, Wide};
use crate::dim::contact::{self, ContactBlock, CoulombBlock};
use crate::dim::math::Real;
use crate::dim::state::{BodyPose, BodyState};
use crate::model::constraint_graph::{ConstraintGraph, ManifoldRef, OVERFLOW};
use crate::model::contact::{
    ContactInput, ContactLanes, ContactPair, ContactReport, LaneBlock, LaneCapacity, NarrowPhase,
    PairStore, reserve_blocks,
};
use crate::model::params::{ContactPass, FrictionModel, ImpactPass, IntegrationParameters};
use core::ops::Range;
use core::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// Blocks that are worth handing over to another thread together (a microsecond or two).
const BLOCKS_PER_TASK: usize = 8;
/// Prefetch distance, in blocks.
const BLOCKS_AHEAD: usize = 2;

/// The context for which contacts are loaded.
#[derive(Copy, Clone)]
pub(super) struct LoadKind {
    /// Whether all moving bodies are solved together.
    pub is_only_group: bool,
    /// Whether each point has its own friction.
    pub per_point: bool,
}

/// All contact constraints of a step.
#[derive(Default)]
pub(super) struct SolverContacts {
    /// Blocks of one colour are contiguous.
    blocks: Vec<ContactBlock>,
    /// The lanes of the narrow phase while they are borrowed, else an own set.
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
    impacts: Impacts,
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

    /// There are none.
    pub fn clear(&mut self) {
        self.layout.clear();
        self.starts.clear();
        self.are_on_loan = false;
        self.point_count = 0;
    }

    /// Fills the lanes from the manifolds of the solved bodies: whole lanes of a colour, and independent
    /// constraints of the overflow. Manifolds of links are left to their multibodies.
    pub fn load(
        &mut self,
        graph: &ConstraintGraph,
        narrow_phase: &mut NarrowPhase,
        (bodies, kind): (&SolverBodies, LoadKind),
        multibodies: &mut SolverMultibodies,
        tasks: Tasks<'_>,
    ) {
        let LoadKind { is_only_group, per_point } = kind;
        let are_all = is_only_group && multibodies.move_no_body();
        let NarrowPhase { contacts, lanes, .. } = &mut *narrow_phase;
        let capacity = is_only_group.then_some(&mut lanes.capacity);
        self.lay_out((graph, contacts, capacity), (bodies, are_all), multibodies);
        // A lane whose manifold changed is filled from the manifold, which must be written back by then. So
        // must those be whose impulses are about to change before they act.
        let lanes = &narrow_phase.lanes;
        let stay = is_only_group && lanes.starts() == self.starts;
        if !stay || lanes.are_rough != per_point || bodies.any_scaled() {
            narrow_phase.settle_all(tasks);
        }
        // The set of groups may change from step to step, and a group has no data of the others.
        self.lanes_are_scaled = bodies.any_scaled();
        self.are_on_loan = is_only_group;
        if is_only_group {
            self.lanes = core::mem::take(&mut narrow_phase.lanes);
        } else {
            narrow_phase.lanes.forget();
            self.lanes.forget();
        }
        let count = self.layout.block_count();
        self.lanes.resize(count);
        reserve_blocks(&mut self.blocks, count);
        self.blocks.resize_with(count, || ContactBlock::EMPTY);
        self.point_count = self.fill_lanes(narrow_phase, (bodies, per_point), tasks);
        self.impacts.load(&self.lanes, self.layout.colors(), bodies);
    }

    /// Assigns manifolds to lanes: all of the graph, or those of the solved bodies.
    fn lay_out(
        &mut self,
        (graph, contacts, mut capacity): (
            &ConstraintGraph,
            &PairStore<ContactPair>,
            Option<&mut LaneCapacity>,
        ),
        (bodies, are_all): (&SolverBodies, bool),
        multibodies: &mut SolverMultibodies,
    ) {
        self.layout.clear();
        self.starts.clear();
        for (color, list) in graph.all_in_solving_order() {
            let first = self.layout.block_count();
            let slots = |at: ManifoldRef| contacts.bodies(at.pair);
            let members = list.iter().copied().filter(|&at| {
                are_all || !multibodies.adopt(at, slots(at)) && bodies.has_one_of(slots(at))
            });
            if color == OVERFLOW {
                // These are solved one after the other, and their order in the list depends on the rest of
                // the world.
                let mut members: Vec<_> = members.collect();
                members.sort_unstable_by_key(|at| (contacts.collider_slots(at.pair), at.manifold));
                let members = members.into_iter().map(|at| (at, slots(at)));
                self.layout.add_side_by_side(members, &mut self.overflow);
            } else if are_all {
                // All manifolds are loaded, so the list is copied as it is.
                self.layout.add(color, list.iter().copied());
                self.starts.push(first as u32);
            } else {
                self.layout.add(color, members);
                self.starts.push(first as u32);
            }
            if let Some(capacity) = &mut capacity {
                self.layout.keep_room(first, &mut capacity[color as usize]);
            }
        }
        if !are_all {
            self.starts.clear();
        }
    }

    /// Discards the results of the step.
    pub fn give_back(&mut self, narrow_phase: &mut NarrowPhase) {
        if self.lanes_are_scaled {
            self.lanes.forget();
        }
        if self.are_on_loan {
            narrow_phase.lanes = core::mem::take(&mut self.lanes);
        }
    }

    /// Returns the number of points.
    fn fill_lanes(
        &mut self,
        narrow_phase: &NarrowPhase,
        bodies: (&SolverBodies, bool),
        tasks: Tasks<'_>,
    ) -> usize {
        let (layout, lanes) = (&self.layout, DisjointMut::new(&mut self.lanes.blocks));
        let point_count = AtomicUsize::new(0);
        tasks.par_for(layout.block_count(), BLOCKS_PER_TASK, |range| {
            let mut count = 0;
            for index in range.clone() {
                let soon = index + BLOCKS_AHEAD;
                if soon < range.end {
                    // SAFETY: each block has lanes, and belongs to one task.
                    let block = unsafe { lanes.get(soon) };
                    prefetch(block, layout.block(soon), narrow_phase);
                }
                // SAFETY: as above.
                let block = unsafe { lanes.get_mut(index) };
                fill(block, layout.block(index), narrow_phase, bodies);
                count += block.point_count();
            }
            point_count.fetch_add(count, Ordering::Relaxed);
        });
        point_count.into_inner()
    }

    /// Makes constraints of the manifolds, and gives the bodies last step's impulses.
    pub fn prepare(
        &mut self,
        bodies: &mut SolverBodies,
        (params, pass): (&IntegrationParameters, &ContactPass),
        simd: Simd,
        tasks: Tasks<'_>,
    ) {
        let per_point = params.friction_model == FrictionModel::Coulomb;
        let rows = if per_point { self.blocks.len() } else { 0 };
        self.coulomb.resize(rows, CoulombBlock::EMPTY);
        let prediction = params.prediction_distance();
        let (poses, states) = bodies.shared();
        let lanes = &self.lanes.blocks[..];
        let blocks = Blocks::new(&mut self.blocks, &mut self.coulomb);
        let (deep, has_deep_overlap) = (deep_overlap(pass), AtomicBool::new(false));
        for_each_color(self.layout.colors(), (tasks, BLOCKS_PER_TASK), |range| {
            if simd.run(Prepare { range, lanes, blocks, poses, states, prediction, deep }) {
                has_deep_overlap.store(true, Ordering::Relaxed);
            }
        });
        self.has_deep_overlap = has_deep_overlap.into_inner();
    }

    /// Notes the islands in which overlap is deep, if there are any. Returns whether there may be.
    pub fn note_deep_overlaps(
        &self,
        recovery: &mut Recovery,
        bodies: &SolverBodies,
        pass: &ContactPass,
    ) -> bool {
        recovery.clear();
        if self.has_deep_overlap {
            recovery.begin(bodies);
            let deep = deep_overlap(pass);
            // Blocks beyond the colour's count keep the data of an earlier step.
            for index in self.layout.colors().iter().flat_map(Clone::clone) {
                recovery.note(&self.blocks[index], &self.lanes.blocks[index].input, deep, bodies);
            }
        }
        self.has_deep_overlap
    }

    /// Scales the warm-start impulses of a substep by this fraction, as for bodies.
    pub fn scale_impulses(&mut self, factor: Real) {
        if factor != 1.0 {
            let factors = Lane::splat(factor);
            self.blocks.iter_mut().for_each(|block| block.scale_impulses(&factors));
            self.coulomb.iter_mut().for_each(|rows| rows.scale_impulses(&factors));
        }
    }

    /// Removes the energy that the correction of overlap added to bodies, and the corresponding impulses.
    pub fn return_gains(&mut self, recovery: &mut Recovery, bodies: &mut SolverBodies) {
        if !recovery.limit(bodies) {
            return;
        }
        // Blocks that no colour fills name bodies of an earlier step.
        for index in self.layout.colors().iter().flat_map(Clone::clone) {
            let block = &mut self.blocks[index];
            if let Some(factors) = recovery.kept_by(block) {
                block.scale_impulses(&factors);
                self.coulomb.get_mut(index).into_iter().for_each(|it| it.scale_impulses(&factors));
            }
        }
    }

    /// Solves all constraints once, with bias.
    pub fn solve(
        &mut self,
        bodies: &mut SolverBodies,
        pass: &ContactPass,
        simd: Simd,
        tasks: Tasks<'_>,
    ) {
        let (_, states) = bodies.shared();
        let blocks = Blocks::new(&mut self.blocks, &mut self.coulomb);
        for_each_color(self.layout.colors(), (tasks, BLOCKS_PER_TASK), |range| {
            simd.run(Solve { range, blocks, states, pass });
        });
    }

    /// Solves all constraints once, without bias and with friction.
    pub fn relax(
        &mut self,
        bodies: &mut SolverBodies,
        pass: &ContactPass,
        simd: Simd,
        tasks: Tasks<'_>,
    ) {
        let (_, states) = bodies.shared();
        let blocks = Blocks::new(&mut self.blocks, &mut self.coulomb);
        for_each_color(self.layout.colors(), (tasks, BLOCKS_PER_TASK), |range| {
            simd.run(Relax { range, blocks, states, pass });
        });
    }

    /// Returns whether any contact has restitution.
    pub fn has_restitution(&self) -> bool {
        !self.impacts.is_empty()
    }

    /// Applies restitution to the contacts that hit in this substep.
    pub fn solve_impacts(
        &mut self,
        bodies: &mut SolverBodies,
        context: ImpactContext<'_>,
        pass: &ImpactPass,
    ) {
        let blocks = Blocks::new(&mut self.blocks, &mut self.coulomb);
        self.impacts.run(blocks, bodies, context, pass);
    }

    /// Stores the impulses for the next step, and writes back the manifolds whose lanes are not indexed.
    pub fn store(&mut self, narrow_phase: &mut NarrowPhase, simd: Simd, tasks: Tasks<'_>) {
        self.impacts.restore(&mut self.blocks);
        let lanes = DisjointMut::new(&mut self.lanes.blocks);
        let reports = DisjointMut::new(&mut self.lanes.reports);
        let blocks = Blocks::new(&mut self.blocks, &mut self.coulomb);
        let layout = &self.layout;
        tasks.par_for(layout.block_count(), BLOCKS_PER_TASK, |range| {
            simd.run(Keep { range, layout, lanes, reports, blocks });
        });
        self.lanes.are_rough = !self.coulomb.is_empty();
        for color in self.layout.colors().iter().take_while(|color| self.needs_write_back(color)) {
            self.write_back(color.clone(), narrow_phase, tasks);
        }
        if self.are_on_loan {
            self.lanes.go_ahead(&self.starts, narrow_phase.contacts.id_bound());
            narrow_phase.lanes = core::mem::take(&mut self.lanes);
        }
    }

    /// Returns whether the blocks of a colour must write back to their manifolds now. The overflow comes
    /// first, in an order of its own.
    fn needs_write_back(&self, color: &Range<usize>) -> bool {
        self.starts.first().is_none_or(|&first| color.start < first as usize)
    }

    fn write_back(&self, color: Range<usize>, narrow_phase: &mut NarrowPhase, tasks: Tasks<'_>) {
        let pairs = DisjointMut::new(narrow_phase.contacts.split().pairs);
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

/// Asks for the manifolds with which lanes will be filled: pairs are spread over memory.
fn prefetch(lanes: &LaneBlock, chunk: &[ManifoldRef], narrow_phase: &NarrowPhase) {
    for (lane, &at) in chunk.iter().enumerate() {
        if !lanes.is_seated(lane, at) || narrow_phase.contacts.is_renewed(at.pair) {
            narrow_phase.contacts.prefetch(at.pair);
        }
    }
}

/// Fills the lanes of a block that are not up to date, and sets the body indices of all lanes.
fn fill(
    block: &mut LaneBlock,
    chunk: &[ManifoldRef],
    narrow_phase: &NarrowPhase,
    (bodies, per_point): (&SolverBodies, bool),
) {
    if chunk.is_empty() && block.is_empty() {
        return;
    }
    let contacts = &narrow_phase.contacts;
    for (lane, &at) in chunk.iter().enumerate() {
        if block.assign(lane, Some(at)) || contacts.is_renewed(at.pair) {
            block.learn(lane, at.manifold, &contacts[at.pair], contacts.bodies(at.pair));
        }
    }
    for lane in chunk.len()..LANES {
        block.clear(lane);
    }
    for lane in 0..chunk.len() {
        assign_bodies(block, lane, bodies);
    }
    if bodies.any_scaled() {
        scale_impulses(&mut block.input, bodies, per_point);
    }
}

fn assign_bodies(block: &mut LaneBlock, lane: usize, bodies: &SolverBodies) {
    let (index1, creeps1) = bodies.find(block.slots[0][lane]);
    let (index2, creeps2) = bodies.find(block.slots[1][lane]);
    let input = &mut block.input;
    (input.bodies[0][lane], input.bodies[1][lane]) = (index1, index2);
    for (side, index) in [index1, index2].into_iter().enumerate() {
        input.is_world[side].0[lane] = if index == BodyPose::WORLD_INDEX { 1.0 } else { 0.0 };
    }
    input.anchor_frame.set_near_rest(lane, creeps1 && creeps2);
}

/// Scales the warm-start impulses of all lanes by the fraction of their bodies.
fn scale_impulses(input: &mut ContactInput, bodies: &SolverBodies, per_point: bool) {
    for lane in 0..LANES {
        let fraction = bodies.impulse_fraction([input.bodies[0][lane], input.bodies[1][lane]]);
        if fraction != 1.0 {
            input.scale_impulses(lane, fraction, per_point);
        }
    }
}

/// Distributes the blocks colour by colour, in tasks of this size; blocks of one colour run concurrently.
pub(super) fn for_each_color(
    colors: &[Range<usize>],
    (tasks, grain): (Tasks<'_>, usize),
    work: impl Fn(Range<usize>) + Sync,
) {
    for color in colors {
        tasks.par_for(color.len(), grain, |range| {
            work(color.start + range.start..color.start + range.end);
        });
    }
}

/// All blocks, and the friction per point of each if that is wanted.
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

/// See [`contact::prepare`].
struct Prepare<'a> {
    range: Range<usize>,
    lanes: &'a [LaneBlock],
    blocks: Blocks<'a>,
    poses: &'a [BodyPose],
    states: DisjointMut<'a, BodyState>,
    prediction: Real,
    /// The overlap from which on contacts are reported.
    deep: Real,
}

impl Kernel for Prepare<'_> {
    /// Whether one of the contacts is deep.
    type Output = bool;

    #[inline(always)]
    fn run<W: Wide>(self) -> bool {
        let Self { poses, states, prediction, .. } = self;
        let mut least = W::zero();
        for index in self.range {
            // SAFETY: each block belongs to one task, and constraints of one colour have no common dynamic
            // body.
            unsafe {
                let (block, coulomb) = self.blocks.get(index);
                let input = &self.lanes[index].input;
                let context = contact::PrepareContext { poses, states: &states };
                contact::prepare::<W>(input, block, coulomb, context, prediction);
                for point in &block.points {
                    least = least.min(W::load(&point.separation));
                }
            }
        }
        W::any(least.lt(W::splat(-self.deep)))
    }
}

/// See [`store_impulses`].
struct Keep<'a> {
    range: Range<usize>,
    layout: &'a Layout<ManifoldRef>,
    lanes: DisjointMut<'a, LaneBlock>,
    reports: DisjointMut<'a, [ContactReport; LANES]>,
    blocks: Blocks<'a>,
}

impl Kernel for Keep<'_> {
    type Output = ();

    #[inline(always)]
    fn run<W: Wide>(self) {
        for index in self.range.filter(|&index| !self.layout.block(index).is_empty()) {
            // SAFETY: each block belongs to one task.
            unsafe {
                let (block, coulomb) = self.blocks.get(index);
                let input = &mut self.lanes.get_mut(index).input;
                let reports = self.reports.get_mut(index);
                store_impulses::<W>(block, coulomb.as_deref(), input, reports);
            }
        }
    }
}

/// A pass over some blocks of one colour.
macro_rules! pass_kernel {
    ($name:ident, |$block:ident, $coulomb:ident, $states:ident, $pass:ident| $visit:expr) => {
        struct $name<'a> {
            range: Range<usize>,
            blocks: Blocks<'a>,
            states: DisjointMut<'a, BodyState>,
            pass: &'a ContactPass,
        }

        impl Kernel for $name<'_> {
            type Output = ();

            #[inline(always)]
            fn run<W: Wide>(self) {
                let ($states, $pass) = (&self.states, self.pass);
                for index in self.range {
                    // SAFETY: each block belongs to one task, constraints of one colour have no common
                    // dynamic body, and the colours run in sequence.
                    unsafe {
                        let ($block, $coulomb) = self.blocks.get(index);
                        $visit
                    }
                }
            }
        }
    };
}

pass_kernel!(Solve, |block, _coulomb, states, pass| contact::solve::<W>(block, states, pass));
pass_kernel!(Relax, |block, coulomb, states, pass| {
    contact::relax::<W>(block, coulomb, states, pass);
});
