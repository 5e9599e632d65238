//! From constraints back to joints: once per step, on several threads.

use super::block::{AxisRow, JointBlock};
use super::{BLOCKS_PER_TASK, SolverJoints};
use crate::dim::joint::set_couple;
use crate::dim::math::{DIM, Real};
use crate::dim::wide::ang_lane;
use crate::model::event::JointBreakEvent;
use crate::model::frozen::Frozen;
use crate::model::island::IslandManager;
use crate::model::joint::{ImpulseJoint, ImpulseJointSet};
use crate::step::solver::bodies::SolverBodies;
use crate::step::solver::context::{ImpulseOutput, SolverPass};
use crate::step::solver::joint_rules::{break_if_overloaded, is_overloaded};
use core::sync::atomic::{AtomicBool, Ordering};

impl SolverJoints {
    /// Ends the step, while the bodies are still where the solver has put them.
    pub fn finish(&mut self, bodies: &mut SolverBodies, pass: &SolverPass<'_>) {
        let (_, states) = bodies.shared();
        self.point_to_point.finish(states, pass.simd, pass.tasks);
        self.transmissions.finish(&bodies.states);
    }

    /// Writes impulses, forces and turn counts back to the joints, and breaks overloaded joints.
    pub fn store(&self, output: &mut ImpulseOutput<'_>) {
        let ImpulseOutput { settings, islands, joints, broken, .. } = output;
        let (inv_dt, tasks) = (settings.params.inv_dt(), settings.tasks);
        let overload =
            AtomicBool::new(self.transmissions.store(islands, joints, &self.rows, inv_dt));
        self.point_to_point.store(islands, joints, inv_dt, &overload, tasks);
        let (layout, blocks, all_rows) = (&self.layout, &self.blocks, &self.rows);
        let shared = joints.share();
        tasks.par_for(layout.block_count(), BLOCKS_PER_TASK, |range| {
            for index in range {
                let block = &blocks[index];
                let rows = &all_rows[block.first_row..block.first_row + block.row_count];
                for (lane, lane_slot) in layout.block(index).iter().enumerate() {
                    let Some(link) = islands.joints.get(lane_slot.slot) else { continue };
                    // SAFETY: each joint has one lane slot.
                    let Some(entry) = (unsafe { shared.get_mut(link.handle.0) }) else { continue };
                    store_lane(block, rows, lane, &mut entry.joint, inv_dt);
                    if is_overloaded(&entry.joint) {
                        overload.store(true, Ordering::Relaxed);
                    }
                }
            }
        });
        if overload.into_inner() {
            self.break_overloaded(islands, joints, broken);
        }
    }

    /// Breaks joints in the order in which they were solved: which thread saw them first must not matter.
    fn break_overloaded(
        &self,
        islands: &IslandManager,
        joints: &mut Frozen<'_, ImpulseJointSet>,
        broken: &mut Vec<JointBreakEvent>,
    ) {
        let of_blocks = self.layout.iter().map(|lane_slot| lane_slot.slot);
        let slots = self.point_to_point.slots().chain(of_blocks).chain(self.transmissions.slots());
        for handle in slots.filter_map(|slot| Some(islands.joints.get(slot)?.handle)) {
            let Some(joint) = joints.get_unnoted_mut(handle) else { continue };
            if let Some(event) = break_if_overloaded(handle, joint) {
                broken.push(event);
                joints.note_broken(handle);
            }
        }
    }
}

/// Writes one lane of a block, and of its rows, back to the joint.
fn store_lane(
    block: &JointBlock,
    rows: &[AxisRow],
    lane: usize,
    joint: &mut ImpulseJoint,
    inv_dt: Real,
) {
    for (impulse, lanes) in joint.impulses.iter_mut().zip(&block.impulses[..DIM]) {
        *impulse = lanes.0[lane];
    }
    set_couple(&mut joint.impulses, ang_lane(&block.couple, lane));
    for (axis, row) in joint.data.driven_axes().zip(rows) {
        let k = axis as usize;
        let limits = [row.lower.0[lane], row.upper.0[lane]];
        debug_assert!(!limits.iter().any(|&impulse| impulse < 0.0), "limits push: {limits:?}");
        joint.data.limits[k].impulse = limits[0] - limits[1];
        joint.data.motors[k].impulse = row.motor.impulse.0[lane];
        let (angles, angle) = (joint.angles.as_mut(), row.position.0[lane]);
        if let (Some(angles), Some(k), true) = (angles, k.checked_sub(DIM), angle.is_finite()) {
            angles[k] = angle;
        }
    }
    joint.force = block.total_impulse.lane(lane) * inv_dt;
    joint.torque = ang_lane(&block.total_moment, lane) * inv_dt;
    if !joint.is_sound() {
        joint.clear_impulses();
    }
}
