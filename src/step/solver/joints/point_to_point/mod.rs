//! # Point-to-point joints
//!
//! Point-to-point joints: hinges in 2D and ball joints in 3D, without limits, motors or springs, that are not
//! solved directly (`../direct/`). Nets and cloths have thousands of them. The general data of joints
//! (frames, rows of rotations, free axes) is omitted, and the rows are the axes of the world:
//!
//! ```text
//! C = p2 - p1        Ċ = v2 + ω2 × r2 - v1 - ω1 × r1        K = Σ (1/m - [r]ₓ I⁻¹ [r]ₓ)
//! ```
//!
//! That also improves the iteration. The load of a net has a direction in the world, and the bodies of the
//! net tremble until the iteration has converged. Impulses along axes that turn with a body are turned to and
//! fro by that, and the net stretches by a multiple. Along the axes of the world, a joint starts each substep
//! with its last load, and needs half the compliance of other iterated joints. For the same reason each end
//! has its own moment arm: the moment of the position error is not applied to one of the bodies. It is taken
//! from the angular momentum, as long as the gap is there.

mod block;
mod load;
mod store;

use super::BLOCKS_PER_TASK;
use super::load::JointLoadContext;
use crate::base::disjoint::DisjointMut;
use crate::base::tasks::Tasks;
use crate::base::wide::{LANES, Lane, Simd};
use crate::dim::math::Real;
use crate::dim::state::BodyState;
use crate::model::frozen::Frozen;
use crate::model::island::IslandManager;
use crate::model::joint::{ImpulseJoint, ImpulseJointSet};
use crate::model::params::JointPass;
use crate::step::solver::blocks::{Layout, block_kernel, for_each_color};
use crate::step::solver::joint_rules::is_overloaded;
use block::PointToPointBlock;
use core::sync::atomic::{AtomicBool, Ordering};

/// All point-to-point joints of a step.
#[derive(Default)]
pub(super) struct PointToPointJoints {
    blocks: Vec<PointToPointBlock>,
    /// The joints of each block, by their slots in the islands' list.
    layout: Layout<u32>,
}

/// Number of blocks per parallel task of filling.
const FILLED_PER_TASK: usize = 16;

impl PointToPointJoints {
    /// Number of joints.
    pub fn len(&self) -> usize {
        self.layout.len()
    }

    /// Removes all joints.
    pub fn clear(&mut self) {
        self.layout.clear();
    }

    /// Adds the joints of the next colour.
    pub fn add(&mut self, color: u32, slots: impl IntoIterator<Item = u32>) {
        self.layout.add(color, slots);
    }

    /// The slots of all joints.
    pub fn slots(&self) -> impl Iterator<Item = u32> {
        self.layout.iter().copied()
    }

    /// Makes constraints of the joints that were added.
    pub fn load(
        &mut self,
        joints: &ImpulseJointSet,
        context: JointLoadContext<'_>,
        pass: &JointPass,
        tasks: Tasks<'_>,
    ) {
        let JointLoadContext { islands, world, bodies, .. } = context;
        let layout = &self.layout;
        self.blocks.resize(layout.block_count(), PointToPointBlock::EMPTY);
        tasks.par_fill(&mut self.blocks, FILLED_PER_TASK, |index| {
            let mut block = PointToPointBlock::EMPTY;
            for &slot in layout.block_or_none(index + 1) {
                joints.prefetch(slot);
                if let Some(link) = islands.joints.get(slot) {
                    link.body_slots().into_iter().for_each(|body| world.prefetch(body));
                }
            }
            for (lane, &slot) in layout.block(index).iter().enumerate() {
                let link = islands.joints.get(slot);
                if let Some(joint) = link.and_then(|link| joints.get(link.handle)) {
                    load::load_lane(&mut block, lane, joint, world, bodies, pass);
                }
            }
            block
        });
        let mut ends = self.blocks.iter().flat_map(|block| block.bodies).flatten();
        debug_assert!(ends.all(|body| bodies.has_state(body)));
    }

    /// Gives the bodies the impulses with which the step starts.
    pub fn warm_start(&mut self, states: DisjointMut<'_, BodyState>, simd: Simd, tasks: Tasks<'_>) {
        let blocks = DisjointMut::new(&mut self.blocks);
        for_each_color(self.layout.colors(), tasks, BLOCKS_PER_TASK, |range| {
            simd.run(WarmStart { range, blocks, states });
        });
    }

    /// Scales impulses by the fraction, if any, that the constraints of a block of bodies keep.
    /// `are_counted`: whether the sums over all substeps include the impulses.
    pub fn scale_impulses(
        &mut self,
        kept_by: impl Fn(&[[u32; LANES]; 2]) -> Option<Lane>,
        are_counted: bool,
    ) {
        for block in &mut self.blocks {
            let kept = kept_by(&block.bodies);
            kept.iter().for_each(|kept| block.scale_impulses(kept, are_counted));
        }
    }

    /// Solves all joints once: with bias, or towards zero relative velocity.
    pub fn iterate(
        &mut self,
        states: DisjointMut<'_, BodyState>,
        pass: &JointPass,
        simd: Simd,
        tasks: Tasks<'_>,
    ) {
        let pass = &block::softened(pass);
        let blocks = DisjointMut::new(&mut self.blocks);
        for_each_color(self.layout.colors(), tasks, BLOCKS_PER_TASK, |range| {
            simd.run(Iterate { range, blocks, states, pass });
        });
    }

    /// Turns impulses back with the bodies, to how these stood when the step began.
    pub fn finish(&mut self, states: DisjointMut<'_, BodyState>, simd: Simd, tasks: Tasks<'_>) {
        let blocks = DisjointMut::new(&mut self.blocks);
        tasks.par_for(self.layout.block_count(), FILLED_PER_TASK, |range| {
            simd.run(TurnBack { range, blocks, states });
        });
    }

    /// Writes impulses and forces back to the joints. Sets `overload` if the load of a joint exceeds its
    /// limit.
    pub fn store(
        &self,
        islands: &IslandManager,
        joints: &mut Frozen<'_, ImpulseJointSet>,
        inv_dt: Real,
        overload: &AtomicBool,
        tasks: Tasks<'_>,
    ) {
        let (layout, blocks) = (&self.layout, &self.blocks);
        let joints = joints.share();
        tasks.par_for(layout.block_count(), FILLED_PER_TASK, |range| {
            for index in range {
                let later = layout.block_or_none(index + 1);
                later.iter().for_each(|slot| joints.prefetch_front(*slot, ImpulseJoint::FRONT));
                let block = &blocks[index];
                for (lane, &slot) in layout.block(index).iter().enumerate() {
                    let Some(link) = islands.joints.get(slot) else { continue };
                    // SAFETY: each joint has one lane.
                    let Some(entry) = (unsafe { joints.get_mut(link.handle.0) }) else { continue };
                    store::store_lane(block, lane, &mut entry.joint, inv_dt);
                    if is_overloaded(&entry.joint) {
                        overload.store(true, Ordering::Relaxed);
                    }
                }
            }
        });
    }
}

block_kernel! {
    /// See [`block::warm_start`].
    struct WarmStart<'a> {
        blocks: DisjointMut<'a, PointToPointBlock>,
        states: DisjointMut<'a, BodyState>,
    }
    |index| block::warm_start::<W>(blocks.get_mut(index), &states)
}

block_kernel! {
    /// See [`block::iterate`].
    struct Iterate<'a> {
        blocks: DisjointMut<'a, PointToPointBlock>,
        states: DisjointMut<'a, BodyState>,
        pass: &'a JointPass,
    }
    |index| block::iterate::<W>(blocks.get_mut(index), &states, pass)
}

block_kernel! {
    /// See [`block::turn_back`].
    struct TurnBack<'a> {
        blocks: DisjointMut<'a, PointToPointBlock>,
        states: DisjointMut<'a, BodyState>,
    }
    |index| block::turn_back::<W>(blocks.get_mut(index), &states)
}
