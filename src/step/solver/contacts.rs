//! Contact constraints: from manifolds to lane-wide blocks, through the passes, and back.

use super::bodies::SolverBodies;
use super::impacts::{Around, Impacts};
use super::layout::Layout;
use super::multibodies::SolverMultibodies;
use super::overflow::OverflowOrder;
use crate::base::disjoint::DisjointMut;
use crate::base::tasks::Tasks;
use crate::base::wide::{Kernel, LANES, Simd, Wide};
use crate::dim::contact::{self, ContactBlock, ContactInput, CoulombBlock};
use crate::dim::math::Real;
use crate::dim::state::{BodyPose, BodyState};
use crate::model::constraint_graph::{ConstraintGraph, ManifoldRef, OVERFLOW};
use crate::model::contact::{ContactManifold, NarrowPhase, Placement};
use crate::model::params::{ContactPass, FrictionModel, ImpactPass, IntegrationParameters};
use core::ops::Range;
use core::sync::atomic::{AtomicUsize, Ordering};

/// Blocks that are worth handing over to another thread together (a microsecond or two).
const BLOCKS_PER_TASK: usize = 8;
/// Blocks that are worth being filled by another thread: their manifolds are spread over memory.
const FILLED_PER_TASK: usize = 8;

/// All contact constraints of a step.
#[derive(Default)]
pub(super) struct SolverContacts {
    /// Blocks of one colour stand together.
    blocks: Vec<ContactBlock>,
    inputs: Vec<ContactInput>,
    /// Friction per point of each block; empty with the standard friction model.
    coulomb: Vec<CoulombBlock>,
    layout: Layout<ManifoldRef>,
    overflow: OverflowOrder,
    impacts: Impacts,
    point_count: usize,
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

    /// Fills the inputs from the manifolds of the bodies that are solved: whole lanes of a colour, and of the overflow what does
    /// not notice each other. Those of links are left to their multibodies.
    pub fn load(
        &mut self,
        graph: &ConstraintGraph,
        narrow_phase: &NarrowPhase,
        bodies: &SolverBodies,
        multibodies: &mut SolverMultibodies,
        tasks: Tasks<'_>,
    ) {
        self.layout.clear();
        let are_all = bodies.are_one_group() && multibodies.move_nobody();
        for (color, list) in graph.in_solving_order() {
            let members = list.iter().copied().filter(|&manifold| {
                let slots = || narrow_phase.contacts.bodies(manifold.pair);
                are_all || !multibodies.take_over(manifold, slots()) && bodies.has_one_of(slots())
            });
            if color == OVERFLOW {
                let members = members.map(|at| (at, narrow_phase.contacts.bodies(at.pair)));
                self.layout.add_side_by_side(members, &mut self.overflow);
            } else {
                self.layout.add(color, members);
            }
        }
        let count = self.layout.block_count();
        self.inputs.resize_with(count, || ContactInput::EMPTY);
        self.blocks.resize_with(count, || ContactBlock::EMPTY);
        self.point_count = self.fill_inputs(narrow_phase, bodies, tasks);
        self.impacts.load(&self.inputs, self.layout.colors(), bodies);
    }

    /// Returns the number of points.
    fn fill_inputs(
        &mut self,
        narrow_phase: &NarrowPhase,
        bodies: &SolverBodies,
        tasks: Tasks<'_>,
    ) -> usize {
        let (layout, inputs) = (&self.layout, DisjointMut::new(&mut self.inputs));
        let point_count = AtomicUsize::new(0);
        tasks.par_for(layout.block_count(), FILLED_PER_TASK, |range| {
            let fill_one = |index: usize| {
                // SAFETY: each block has an input, and belongs to one task.
                let input = unsafe { inputs.get_mut(index) };
                let soon = layout.block_or_none(index + 1);
                fill(input, [layout.block(index), soon], narrow_phase, bodies)
            };
            point_count.fetch_add(range.map(fill_one).sum(), Ordering::Relaxed);
        });
        point_count.into_inner()
    }

    /// Makes constraints of the manifolds, and gives the bodies last step's impulses.
    pub fn prepare(
        &mut self,
        bodies: &mut SolverBodies,
        params: &IntegrationParameters,
        simd: Simd,
        tasks: Tasks<'_>,
    ) {
        let per_point = params.friction_model == FrictionModel::Coulomb;
        let rows = if per_point { self.blocks.len() } else { 0 };
        self.coulomb.resize(rows, CoulombBlock::EMPTY);
        let prediction = params.prediction_distance();
        let (poses, states, _) = bodies.shared();
        let inputs = DisjointMut::new(&mut self.inputs);
        let blocks = Blocks::new(&mut self.blocks, &mut self.coulomb);
        for_each_color(self.layout.colors(), tasks, |range| {
            simd.run(Prepare { range, inputs, blocks, poses, states, prediction });
        });
    }

    /// Lets a substep start with this share of the last one's impulses, as the bodies do.
    pub fn scale_impulses(&mut self, factor: Real) {
        if factor != 1.0 {
            self.blocks.iter_mut().for_each(|block| block.scale_impulses(factor));
            self.coulomb.iter_mut().for_each(|rows| rows.scale_impulses(factor));
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
        let (_, states, _) = bodies.shared();
        let blocks = Blocks::new(&mut self.blocks, &mut self.coulomb);
        for_each_color(self.layout.colors(), tasks, |range| {
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
        let (_, states, _) = bodies.shared();
        let blocks = Blocks::new(&mut self.blocks, &mut self.coulomb);
        for_each_color(self.layout.colors(), tasks, |range| {
            simd.run(Relax { range, blocks, states, pass });
        });
    }

    /// Notes how the bodies move at the end of a substep, before forces act in the next.
    pub fn note_velocities(&mut self, velocities: &[BodyState]) {
        self.impacts.note_velocities(velocities);
    }

    /// Lets the contacts bounce that hit something in this substep.
    pub fn bounce(&mut self, bodies: &mut SolverBodies, around: Around<'_>, pass: &ImpactPass) {
        let blocks = Blocks::new(&mut self.blocks, &mut self.coulomb);
        self.impacts.run(blocks, bodies, around, pass);
    }

    /// Writes impulses, and where the contacts were, back to the manifolds.
    pub fn store(&self, narrow_phase: &mut NarrowPhase, tasks: Tasks<'_>) {
        let pairs = DisjointMut::new(narrow_phase.contacts.split().pairs);
        for_each_color(self.layout.colors(), tasks, |range| {
            for index in range {
                let soon = self.layout.block_or_none(index + 1);
                for (lane, at) in self.layout.block(index).iter().enumerate() {
                    if let Some(later) = soon.get(lane) {
                        pairs.prefetch(later.pair as usize);
                    }
                    // SAFETY: the manifolds of a pair have the same bodies, so no two of them have the same colour.
                    let pair = unsafe { pairs.get_mut(at.pair as usize) };
                    let Some(pair) = pair else { continue };
                    self.store_lane(index, lane, &mut pair.manifolds[at.manifold as usize]);
                }
            }
        });
    }

    fn store_lane(&self, index: usize, lane: usize, manifold: &mut ContactManifold) {
        store_lane(&self.blocks[index], &self.inputs[index], lane, manifold);
        let Some(coulomb) = self.coulomb.get(index) else { return };
        for (k, point) in manifold.data.points.iter_mut().enumerate() {
            let impulse = coulomb.impulse(k, lane);
            let sound = impulse.iter().all(|value| value.is_finite());
            point.warmstart_tangent_impulse = if sound { impulse } else { [0.0; _] };
        }
    }
}

/// Fills one input, lane by lane, and asks for what the next one needs: pairs are spread over memory. Returns the number
/// of points.
fn fill(
    input: &mut ContactInput,
    [chunk, soon]: [&[ManifoldRef]; 2],
    narrow_phase: &NarrowPhase,
    bodies: &SolverBodies,
) -> usize {
    let mut point_count = 0;
    if chunk.len() < LANES {
        *input = ContactInput::EMPTY;
    }
    for (lane, at) in chunk.iter().enumerate() {
        if let Some(later) = soon.get(lane) {
            narrow_phase.contacts.prefetch(later.pair);
        }
        let slots = narrow_phase.contacts.bodies(at.pair);
        let indices = slots.map(|slot| bodies.index_of(slot));
        let pair = &narrow_phase.contacts[at.pair];
        load_bodies(input, lane, indices);
        let manifold = &pair.manifolds[at.manifold as usize];
        load_manifold(input, lane, manifold, bodies.share(indices));
        let creep = pair.placement.may_hold && indices.iter().all(|&index| bodies.creeps(index));
        let data = &manifold.data;
        let held = if creep { Placement::held_turn(data.friction) } else { 0.0 };
        input.placement.set_lane(lane, &pair.placement, data.placed_normal, held);
        point_count += manifold.contacts().len();
    }
    point_count
}

fn load_bodies(input: &mut ContactInput, lane: usize, indices: [u32; 2]) {
    let world = BodyPose::WORLD_INDEX;
    for (side, index) in indices.into_iter().enumerate() {
        input.bodies[side][lane] = index;
        input.is_world[side].0[lane] = if index == world { 1.0 } else { 0.0 };
    }
}

/// `share` is that of its impulses with which the step begins.
fn load_manifold(input: &mut ContactInput, lane: usize, manifold: &ContactManifold, share: Real) {
    let data = &manifold.data;
    input.mass_factors[0].0[lane] = if data.relative_dominance > 0 { 0.0 } else { 1.0 };
    input.mass_factors[1].0[lane] = if data.relative_dominance < 0 { 0.0 } else { 1.0 };
    input.friction.0[lane] = data.friction;
    input.restitution.0[lane] = data.restitution;
    input.tangent_velocity.set_lane(lane, data.tangent_velocity);
    input.friction_impulse.set_lane(lane, data.warmstart_friction * share);
    input.set_twist_impulse(lane, data.warmstart_twist * share);
    for k in 0..input.present.len() {
        let Some(point) = data.points.get(k) else {
            input.present[k].0[lane] = 0.0;
            input.impulses[k].0[lane] = 0.0;
            input.set_tangent_impulse(k, lane, [0.0; _]);
            continue;
        };
        input.levers[k].set_lane(lane, point.lever);
        input.placed_separations[k].0[lane] = point.placed_dist;
        input.present[k].0[lane] = 1.0;
        input.impulses[k].0[lane] = point.warmstart_impulse * share;
        let tangent = point.warmstart_tangent_impulse.map(|impulse| impulse * share);
        input.set_tangent_impulse(k, lane, tangent);
    }
}

fn store_lane(
    block: &ContactBlock,
    input: &ContactInput,
    lane: usize,
    manifold: &mut ContactManifold,
) {
    let data = &mut manifold.data;
    if !lane_is_sound(block, input, lane, data.points.len()) {
        return data.forget_impulses();
    }
    data.normal = input.world_normal.lane(lane);
    data.warmstart_friction = block.friction_impulse(lane);
    data.warmstart_twist = block.twist_impulse(lane);
    for (k, point) in data.points.iter_mut().enumerate() {
        point.point = input.points[k].lane(lane);
        point.dist = input.separations[k].0[lane];
        point.impulse = block.totals[k].0[lane];
        point.warmstart_impulse = block.points[k].impulse.0[lane];
    }
}

/// Did the numbers of a manifold stay finite? Otherwise its impulses must not start the next step: the
/// bodies would never get rid of them.
fn lane_is_sound(block: &ContactBlock, input: &ContactInput, lane: usize, count: usize) -> bool {
    // Stays zero unless a number is not finite: 0·∞ and 0·NaN are NaN.
    let mut probe = 0.0 * input.world_normal.lane(lane).element_sum();
    probe += 0.0 * block.friction_impulse(lane).element_sum();
    probe += 0.0 * block.twist_impulse(lane);
    for k in 0..count {
        probe += 0.0 * input.points[k].lane(lane).element_sum();
        probe += 0.0 * input.separations[k].0[lane];
        probe += 0.0 * block.totals[k].0[lane];
        probe += 0.0 * block.points[k].impulse.0[lane];
    }
    probe == 0.0
}

/// Hands out the blocks of one colour after the other; those of one colour may be worked on at once.
pub(super) fn for_each_color(
    colors: &[Range<usize>],
    tasks: Tasks<'_>,
    work: impl Fn(Range<usize>) + Sync,
) {
    for color in colors {
        tasks.par_for(color.len(), BLOCKS_PER_TASK, |range| {
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
    /// Nobody else may use the block with this index meanwhile.
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
    inputs: DisjointMut<'a, ContactInput>,
    blocks: Blocks<'a>,
    poses: &'a [BodyPose],
    states: DisjointMut<'a, BodyState>,
    prediction: Real,
}

impl Kernel for Prepare<'_> {
    type Output = ();

    #[inline(always)]
    fn run<W: Wide>(self) {
        let Self { poses, states, prediction, .. } = self;
        for index in self.range {
            // SAFETY: each block belongs to one task, and the constraints of one colour share no body
            // that is not read-only.
            unsafe {
                let (block, coulomb) = self.blocks.get(index);
                let input = self.inputs.get_mut(index);
                let surroundings = contact::Surroundings { poses, states: &states };
                contact::prepare::<W>(input, block, coulomb, surroundings, prediction);
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
                    // SAFETY: each block belongs to one task, the constraints of one colour share no
                    // body that is not read-only, and one colour is done before the next begins.
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
