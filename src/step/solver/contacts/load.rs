//! From manifolds to lanes: once per step, on several threads.

use super::{BLOCKS_PER_TASK, SolverContacts};
use crate::base::disjoint::DisjointMut;
use crate::base::tasks::Tasks;
use crate::base::wide::LANES;
use crate::dim::contact::ContactBlock;
use crate::dim::state::BodyPose;
use crate::model::constraint_graph::{ConstraintGraph, ManifoldRef, OVERFLOW};
use crate::model::contact::{
    ContactInput, ContactPair, LaneBlock, LaneCapacity, NarrowPhase, PairStore, reserve_blocks,
};
use crate::model::frozen::Frozen;
use crate::step::solver::bodies::SolverBodies;
use crate::step::solver::links::Links;
use core::sync::atomic::{AtomicUsize, Ordering};

/// Prefetch distance, in blocks.
const BLOCKS_AHEAD: usize = 2;

/// Context for loading contacts.
#[derive(Copy, Clone)]
pub(in crate::step::solver) struct ContactLoadContext<'a> {
    pub bodies: &'a SolverBodies,
    pub links: &'a Links,
    /// Whether all moving bodies are solved together.
    pub is_only_group: bool,
    /// Whether each point has its own friction.
    pub per_point: bool,
}

impl SolverContacts {
    /// Fills the lanes from the manifolds of the solved bodies: whole lanes of a colour, and independent
    /// constraints of the overflow. Manifolds of links are left to their multibodies.
    pub fn load(
        &mut self,
        context: ContactLoadContext<'_>,
        graph: &ConstraintGraph,
        narrow_phase: &mut Frozen<'_, NarrowPhase>,
        tasks: Tasks<'_>,
    ) {
        let ContactLoadContext { bodies, is_only_group, per_point, .. } = context;
        let (lanes, contacts) = narrow_phase.lanes_mut();
        let capacity = is_only_group.then_some(&mut lanes.capacity);
        self.lay_out(context, graph, contacts, capacity);
        // A lane whose manifold changed is filled from the manifold, so the manifold must be written back
        // before. The same holds for manifolds whose impulses are scaled before they act.
        let lanes = &narrow_phase.lanes;
        let stay = is_only_group && lanes.starts() == self.starts;
        if !stay || lanes.has_friction_per_point != per_point || bodies.any_scaled() {
            narrow_phase.write_back_all(tasks);
        }
        // The set of groups may change from step to step, and a group has no data of the others.
        self.lanes_are_scaled = bodies.any_scaled();
        self.are_on_loan = is_only_group;
        if is_only_group {
            self.lanes = core::mem::take(narrow_phase.lanes_mut().0);
        } else {
            narrow_phase.lanes_mut().0.invalidate();
            self.lanes.invalidate();
        }
        let count = self.layout.block_count();
        self.lanes.resize(count);
        reserve_blocks(&mut self.blocks, count);
        self.blocks.resize_with(count, || ContactBlock::EMPTY);
        self.point_count = self.fill_lanes(context, narrow_phase, tasks);
    }

    /// Assigns manifolds to lanes: all of the graph, or those of the solved bodies.
    fn lay_out(
        &mut self,
        ContactLoadContext { bodies, links, is_only_group, .. }: ContactLoadContext<'_>,
        graph: &ConstraintGraph,
        contacts: &PairStore<ContactPair>,
        mut capacity: Option<&mut LaneCapacity>,
    ) {
        let are_all = is_only_group && links.is_empty();
        self.layout.clear();
        self.starts.clear();
        self.of_links.clear();
        for (color, list) in graph.all_in_solving_order() {
            let first = self.layout.block_count();
            if color != OVERFLOW {
                self.starts.push(first as u32);
            }
            // Reserved blocks keep their places, or become fewer.
            let is_reserved = capacity.as_ref().is_some_and(|blocks| blocks[color as usize] > 0);
            if list.is_empty() && !is_reserved {
                continue;
            }
            let slots = |at: ManifoldRef| contacts.bodies(at.pair);
            let of_links = &mut self.of_links;
            let members = list.iter().copied().filter(|&at| {
                let is_of_links = !are_all && links.moves_one_of(slots(at));
                if is_of_links {
                    of_links.push(at);
                }
                are_all || !is_of_links && bodies.has_one_of(slots(at))
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
            } else {
                self.layout.add(color, members);
            }
            if let Some(capacity) = &mut capacity {
                self.layout.reserve_capacity(first, &mut capacity[color as usize]);
            }
        }
        if !are_all {
            self.starts.clear();
        }
    }

    /// Returns the number of points.
    fn fill_lanes(
        &mut self,
        context: ContactLoadContext<'_>,
        narrow_phase: &NarrowPhase,
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
                fill(block, layout.block(index), narrow_phase, context);
                count += block.point_count();
            }
            point_count.fetch_add(count, Ordering::Relaxed);
        });
        point_count.into_inner()
    }
}

/// Prefetches the manifolds with which lanes will be filled: pairs are spread over memory.
fn prefetch(lanes: &LaneBlock, chunk: &[ManifoldRef], narrow_phase: &NarrowPhase) {
    for (lane, &at) in chunk.iter().enumerate() {
        if !lanes.stores(lane, at) || narrow_phase.contacts.is_renewed(at.pair) {
            narrow_phase.contacts.prefetch(at.pair);
        }
    }
}

/// Fills the lanes of a block that are not up to date, and sets the body indices of all lanes.
fn fill(
    block: &mut LaneBlock,
    chunk: &[ManifoldRef],
    narrow_phase: &NarrowPhase,
    ContactLoadContext { bodies, per_point, .. }: ContactLoadContext<'_>,
) {
    if chunk.is_empty() && block.is_empty() {
        return;
    }
    let contacts = &narrow_phase.contacts;
    for (lane, &at) in chunk.iter().enumerate() {
        if block.assign(lane, Some(at)) || contacts.is_renewed(at.pair) {
            block.fill(lane, at.manifold, &contacts[at.pair], contacts.bodies(at.pair));
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
    let (index1, near_rest1) = bodies.find(block.slots[0][lane]);
    let (index2, near_rest2) = bodies.find(block.slots[1][lane]);
    let input = &mut block.input;
    (input.bodies[0][lane], input.bodies[1][lane]) = (index1, index2);
    for (side, index) in [index1, index2].into_iter().enumerate() {
        input.is_world[side].0[lane] = if index == BodyPose::WORLD_INDEX { 1.0 } else { 0.0 };
    }
    input.anchor_frame.set_near_rest(lane, near_rest1 && near_rest2);
}

/// Scales the warm-start impulses of all lanes by the fraction of their bodies.
fn scale_impulses(input: &mut ContactInput, bodies: &SolverBodies, per_point: bool) {
    for lane in 0..LANES {
        let fraction =
            bodies.impulse_fractions([input.bodies[0][lane], input.bodies[1][lane]]).of_contacts;
        if fraction != 1.0 {
            input.scale_impulses(lane, fraction, per_point);
        }
    }
}
