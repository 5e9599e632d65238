//! Contact constraints: from manifolds to lane-wide blocks, through the passes, and back.

use super::bodies::SolverBodies;
use crate::base::disjoint::DisjointMut;
use crate::base::tasks::Tasks;
use crate::base::wide::{Kernel, LANES, Simd, Wide};
use crate::dim::contact::{self, ContactBlock, ContactInput};
use crate::dim::math::Real;
use crate::dim::state::{BodyPose, BodyState};
use crate::model::constraint_graph::{ConstraintGraph, ManifoldRef, OVERFLOW};
use crate::model::contact::{ContactManifold, NarrowPhase};
use crate::model::params::{ContactPass, IntegrationParameters};
use core::ops::Range;

/// Blocks that are worth handing over to another thread together (some ten microseconds).
const BLOCKS_PER_TASK: usize = 32;

/// All contact constraints of a step.
#[derive(Default)]
pub(super) struct SolverContacts {
    /// Blocks of one colour stand together.
    blocks: Vec<ContactBlock>,
    inputs: Vec<ContactInput>,
    /// The blocks of each colour in solving order; each block of the overflow is a colour of its own.
    colors: Vec<Range<usize>>,
    len: usize,
}

/// Splits the graph into what stands in one block: whole lanes of a colour, single manifolds of the
/// overflow.
fn chunks(graph: &ConstraintGraph) -> impl Iterator<Item = (u32, &[ManifoldRef])> {
    graph.in_solving_order().flat_map(|(color, list)| {
        let size = if color == OVERFLOW { 1 } else { LANES };
        list.chunks(size).map(move |chunk| (color, chunk))
    })
}

impl SolverContacts {
    /// Number of manifolds.
    pub fn len(&self) -> usize {
        self.len
    }

    /// Fills the inputs from the manifolds.
    pub fn load(
        &mut self,
        graph: &ConstraintGraph,
        narrow_phase: &NarrowPhase,
        bodies: &SolverBodies,
    ) {
        self.colors.clear();
        self.len = graph.len();
        let mut count = 0;
        let mut current = None;
        for (color, chunk) in chunks(graph) {
            if current != Some(color) || color == OVERFLOW {
                self.colors.push(count..count);
                current = Some(color);
            }
            if let Some(range) = self.colors.last_mut() {
                range.end += 1;
            }
            if count == self.inputs.len() {
                self.inputs.push(ContactInput::EMPTY);
                self.blocks.push(ContactBlock::EMPTY);
            }
            fill(&mut self.inputs[count], chunk, narrow_phase, bodies);
            count += 1;
        }
        self.inputs.truncate(count);
        self.blocks.truncate(count);
    }

    /// Makes constraints of the manifolds, and gives the bodies last step's impulses.
    pub fn prepare(
        &mut self,
        bodies: &mut SolverBodies,
        params: &IntegrationParameters,
        simd: Simd,
        tasks: Tasks,
    ) {
        let prediction = params.prediction_distance();
        let (poses, states, before) = bodies.shared();
        let (inputs, blocks) =
            (DisjointMut::new(&mut self.inputs), DisjointMut::new(&mut self.blocks));
        for color in &self.colors {
            tasks.par_for(color.len(), BLOCKS_PER_TASK, |range| {
                let range = color.start + range.start..color.start + range.end;
                simd.run(Prepare { range, inputs, blocks, poses, states, before, prediction });
            });
        }
    }

    /// Lets a substep start with this share of the last one's impulses, as the bodies do.
    pub fn scale_impulses(&mut self, factor: Real) {
        if factor != 1.0 {
            self.blocks.iter_mut().for_each(|block| block.scale_impulses(factor));
        }
    }

    /// Solves all constraints once, with bias.
    pub fn solve(
        &mut self,
        bodies: &mut SolverBodies,
        pass: &ContactPass,
        simd: Simd,
        tasks: Tasks,
    ) {
        self.for_each_color(bodies, tasks, |blocks, states| {
            simd.run(Solve { blocks, states, pass });
        });
    }

    /// Solves all constraints once, without bias and with friction.
    pub fn relax(
        &mut self,
        bodies: &mut SolverBodies,
        pass: &ContactPass,
        simd: Simd,
        tasks: Tasks,
    ) {
        self.for_each_color(bodies, tasks, |blocks, states| {
            simd.run(Relax { blocks, states, pass });
        });
    }

    /// Lets the contacts bounce that hit something in this step.
    pub fn restitute(
        &mut self,
        bodies: &mut SolverBodies,
        pass: &ContactPass,
        simd: Simd,
        tasks: Tasks,
    ) {
        self.for_each_color(bodies, tasks, |blocks, states| {
            simd.run(Restitute { blocks, states, pass });
        });
    }

    fn for_each_color(
        &mut self,
        bodies: &mut SolverBodies,
        tasks: Tasks,
        work: impl Fn(&mut [ContactBlock], DisjointMut<'_, BodyState>) + Sync,
    ) {
        let (_, states, _) = bodies.shared();
        for color in &self.colors {
            let blocks = &mut self.blocks[color.clone()];
            tasks.par_chunks_mut(blocks, BLOCKS_PER_TASK, |blocks| work(blocks, states));
        }
    }

    /// Writes impulses, and where the contacts were, back to the manifolds.
    pub fn store(&self, graph: &ConstraintGraph, narrow_phase: &mut NarrowPhase) {
        for (((_, chunk), block), input) in chunks(graph).zip(&self.blocks).zip(&self.inputs) {
            for (lane, at) in chunk.iter().enumerate() {
                let pair = &mut narrow_phase.contacts[at.pair];
                store_lane(block, input, lane, &mut pair.manifolds[at.manifold as usize]);
            }
        }
    }
}

/// Fills one input, lane by lane.
fn fill(
    input: &mut ContactInput,
    chunk: &[ManifoldRef],
    narrow_phase: &NarrowPhase,
    bodies: &SolverBodies,
) {
    if chunk.len() < LANES {
        *input = ContactInput::EMPTY;
    }
    for (lane, at) in chunk.iter().enumerate() {
        let slots = narrow_phase.contacts.bodies(at.pair);
        let indices = slots.map(|slot| bodies.index_of(slot));
        let manifold = &narrow_phase.contacts[at.pair].manifolds[at.manifold as usize];
        load_lane(input, lane, indices, manifold);
    }
}

fn load_lane(input: &mut ContactInput, lane: usize, indices: [u32; 2], manifold: &ContactManifold) {
    let data = &manifold.data;
    let world = BodyPose::WORLD_INDEX;
    for side in 0..2 {
        input.bodies[side][lane] = indices[side];
        input.is_world[side].0[lane] = if indices[side] == world { 1.0 } else { 0.0 };
    }
    input.mass_factors[0].0[lane] = if data.relative_dominance > 0 { 0.0 } else { 1.0 };
    input.mass_factors[1].0[lane] = if data.relative_dominance < 0 { 0.0 } else { 1.0 };
    input.normal.set_lane(lane, data.body_normal);
    input.friction.0[lane] = data.friction;
    input.restitution.0[lane] = data.restitution;
    input.tangent_velocity.set_lane(lane, data.tangent_velocity);
    input.friction_impulse.set_lane(lane, data.warmstart_friction);
    input.set_twist_impulse(lane, data.warmstart_twist);
    for k in 0..input.present.len() {
        let Some(point) = data.points.get(k) else {
            input.present[k].0[lane] = 0.0;
            input.impulses[k].0[lane] = 0.0;
            continue;
        };
        input.anchors[0][k].set_lane(lane, point.anchor1);
        input.anchors[1][k].set_lane(lane, point.anchor2);
        input.present[k].0[lane] = 1.0;
        input.impulses[k].0[lane] = point.warmstart_impulse;
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
    let of_pair = [input.world_normal.lane(lane), block.friction_impulse(lane)];
    of_pair.iter().all(|vector| vector.is_finite())
        && block.twist_impulse(lane).is_finite()
        && (0..count).all(|k| {
            input.points[k].lane(lane).is_finite()
                && input.separations[k].0[lane].is_finite()
                && block.totals[k].0[lane].is_finite()
                && block.points[k].impulse.0[lane].is_finite()
        })
}

/// See [`contact::prepare`].
struct Prepare<'a> {
    range: Range<usize>,
    inputs: DisjointMut<'a, ContactInput>,
    blocks: DisjointMut<'a, ContactBlock>,
    poses: &'a [BodyPose],
    states: DisjointMut<'a, BodyState>,
    before: &'a [BodyState],
    prediction: Real,
}

impl Kernel for Prepare<'_> {
    type Output = ();

    #[inline(always)]
    fn run<W: Wide>(self) {
        for index in self.range {
            // SAFETY: each block belongs to one task, and the constraints of one colour share no body
            // that is not read-only.
            unsafe {
                let (input, block) = (self.inputs.get_mut(index), self.blocks.get_mut(index));
                contact::prepare::<W>(
                    input,
                    block,
                    self.poses,
                    &self.states,
                    self.before,
                    self.prediction,
                );
            }
        }
    }
}

/// A pass over some blocks of one colour.
macro_rules! pass_kernel {
    ($name:ident, $function:ident) => {
        struct $name<'a> {
            blocks: &'a mut [ContactBlock],
            states: DisjointMut<'a, BodyState>,
            pass: &'a ContactPass,
        }

        impl Kernel for $name<'_> {
            type Output = ();

            #[inline(always)]
            fn run<W: Wide>(self) {
                for block in self.blocks {
                    // SAFETY: the constraints of one colour share no body that is not read-only, and
                    // one colour is done before the next begins.
                    unsafe { contact::$function::<W>(block, &self.states, self.pass) };
                }
            }
        }
    };
}

pass_kernel!(Solve, solve);
pass_kernel!(Relax, relax);
pass_kernel!(Restitute, restitute);
