//! Transmissions: gears, racks and pulleys.
//!
//! ```text
//! low ≤ q ≤ high        q = r₁ q₁ + r₂ q₂        q̇ = Σ r J v
//! ```
//!
//! A transmission has one driven row (`../axis_law.rs`) in the system of the joints that it is connected
//! with: a gear with the hinges of both wheels. The sum is relative to the world, so the forces on the two
//! bodies are not opposite to each other, and lanes of ordinary joints cannot hold them. There are few
//! transmissions, and rows are computed one by one (`../transmission_end.rs`). Laws and masses have lanes: a
//! block after those of the other joints holds up to [`LANES`] transmissions.

mod constraint;

use super::block::{AxisRow, JointBlock};
use super::direct::{AxisNow, Direct, Jacobians, write_law};
use super::{DirectJoint, JointLoadContext, Parts, SharedJacobians};
use crate::base::disjoint::DisjointMut;
use crate::base::wide::{LANES, Lane, Simd};
use crate::dim::joint_axes::JointAxis;
use crate::dim::math::{Real, SPATIAL_DIM};
use crate::dim::state::BodyState;
use crate::dim::wide::WideVector;
use crate::model::frozen::Frozen;
use crate::model::island::IslandManager;
use crate::model::joint::ImpulseJointSet;
use crate::model::params::JointPass;
use crate::step::solver::blocks::block_kernel;
use crate::step::solver::joint_rules::{CURVATURE_FRACTION_MAX, is_overloaded};
use crate::step::solver::states::Bodies;
use constraint::{Constraint, impulse, load_lane, plus, rate, response_of, speed, sum};

/// All transmissions.
#[derive(Default)]
pub(super) struct Transmissions {
    list: Vec<Constraint>,
    /// Position of their first block, and of its row.
    first: [usize; 2],
    /// By block of transmissions: the curvatures of the rows.
    curvatures: Vec<Lane>,
    /// By transmission: the angles by which the step has rotated its ends.
    rotated: Vec<[Real; 2]>,
}

/// Block, row and lane of a transmission.
#[derive(Copy, Clone)]
struct Place {
    block: usize,
    row: usize,
    lane: usize,
}

impl Transmissions {
    /// Number of transmissions.
    pub fn len(&self) -> usize {
        self.list.len()
    }

    /// The slots of all transmissions.
    pub fn slots(&self) -> impl Iterator<Item = u32> {
        self.list.iter().map(|constraint| constraint.slot)
    }

    fn place(&self, index: usize) -> Place {
        let block = index / LANES;
        Place { block: self.first[0] + block, row: self.first[1] + block, lane: index % LANES }
    }

    /// Makes constraints of the transmissions among these joints. Their blocks follow those of the other
    /// joints.
    pub fn load(
        &mut self,
        members: &[DirectJoint],
        joints: &mut Frozen<'_, ImpulseJointSet>,
        context: JointLoadContext<'_>,
        pass: &JointPass,
        (blocks, rows): (&mut Vec<JointBlock>, &mut Vec<AxisRow>),
    ) {
        self.list.clear();
        self.first = [blocks.len(), rows.len()];
        let transmissions = members.iter().filter(|member| member.form.is_transmission);
        let mut slots: Vec<u32> = transmissions.map(|member| member.slot).collect();
        // The order of the colours depends on the rest of the world.
        slots.sort_unstable();
        for slot in slots {
            let handle = context.islands.joints.get(slot).map(|link| link.handle);
            let Some(joint) = handle.and_then(|handle| joints.get_unnoted_mut(handle)) else {
                continue;
            };
            let place = self.place(self.list.len());
            if place.block == blocks.len() {
                blocks.push(JointBlock { first_row: place.row, row_count: 1, ..JointBlock::EMPTY });
                rows.push(AxisRow::EMPTY);
            }
            let lanes = (&mut blocks[place.block], &mut rows[place.row], place.lane);
            self.list.extend(load_lane(lanes, slot, joint, context, pass));
        }
        self.curvatures.clear();
        self.curvatures.resize(blocks.len() - self.first[0], Lane::ZERO);
    }

    /// Notes the transmissions that are connected with no other joint.
    pub fn note_alone(&self, direct: &Direct, rows: &mut [AxisRow]) {
        for (index, constraint) in self.list.iter().enumerate() {
            let Place { row, lane, .. } = self.place(index);
            let is_alone = direct.is_alone(constraint.slot);
            rows[row].motor.is_alone.0[lane] = if is_alone { 1.0 } else { 0.0 };
        }
    }

    /// Notes the places of the rows in the direct solver. `note` receives each body.
    pub fn note_places(
        &self,
        direct: &mut Direct,
        blocks: &[JointBlock],
        mut note: impl FnMut(&JointBlock, usize, usize),
    ) {
        for (index, constraint) in self.list.iter().enumerate() {
            let Place { block, lane, .. } = self.place(index);
            direct.place(constraint.slot, [block, lane]);
            (0..2).for_each(|side| note(&blocks[block], side, lane));
        }
    }

    /// Notes the rates when the step begins, before any force.
    pub fn begin(
        &mut self,
        rows: &mut [AxisRow],
        blocks: &[JointBlock],
        states: &[BodyState],
        h: Real,
    ) {
        for index in 0..self.list.len() {
            let Place { block, row, lane } = self.place(index);
            let constraint = &mut self.list[index];
            constraint.block_ends(states, h);
            constraint.move_ends(states);
            rows[row].motor.rate.0[lane] = rate(&constraint.now, constraint.velocities(states));
            rows[row].response.0[lane] = constraint.response(&blocks[block], lane);
        }
    }

    /// Gives the bodies the impulses with which the step starts.
    pub fn warm_start(
        &mut self,
        rows: &[AxisRow],
        blocks: &[JointBlock],
        states: &mut [BodyState],
    ) {
        for index in 0..self.list.len() {
            let Place { block, row, lane } = self.place(index);
            self.list[index].apply(impulse(&rows[row], lane), &blocks[block], lane, states);
        }
    }

    /// Scales the effect of impulses by the fraction, if any, that the constraints of a block of bodies keep,
    /// and their part of the sums over all substeps if that is counted.
    pub fn scale_impulses(
        &mut self,
        (blocks, rows): (&[JointBlock], &[AxisRow]),
        kept_by: impl Fn(&[[u32; LANES]; 2]) -> Option<Lane>,
        are_counted: bool,
    ) {
        for index in 0..self.list.len() {
            let Place { block, row, lane } = self.place(index);
            let Some(kept) = kept_by(&blocks[block].bodies).map(|kept| kept.0[lane]) else {
                continue;
            };
            let constraint = &mut self.list[index];
            constraint.applied.iter_mut().flatten().for_each(|change| *change *= kept);
            if are_counted {
                constraint.count_impulse(impulse(&rows[row], lane) * (kept - 1.0));
            }
        }
    }

    /// Prepares the solve pass: the impulses act along the rows of the current poses. Stiff components start
    /// without.
    pub fn begin_solve(
        &mut self,
        rows: &mut [AxisRow],
        blocks: &[JointBlock],
        states: &mut [BodyState],
    ) {
        for index in 0..self.list.len() {
            let Place { block, row, lane } = self.place(index);
            let (block, row) = (&blocks[block], &mut rows[row]);
            if block.is_stiff.0[lane] > 0.0 {
                row.motor.impulse.0[lane] = 0.0;
                (row.lower.0[lane], row.upper.0[lane]) = (0.0, 0.0);
            }
            self.list[index].move_ends(states);
            self.list[index].apply(impulse(row, lane), block, lane, states);
        }
    }

    /// Prepares the relax pass: the inertias rotate with the bodies.
    pub fn begin_relax(
        &mut self,
        (blocks, rows): (&mut [JointBlock], &mut [AxisRow]),
        states: &mut [BodyState],
        simd: Simd,
    ) {
        let range = self.first[0]..blocks.len();
        let shared = DisjointMut::new(&mut *states);
        simd.run(RotateInertias { range, blocks: DisjointMut::new(blocks), states: shared });
        for index in 0..self.list.len() {
            let Place { block, row, lane } = self.place(index);
            self.list[index].move_ends(states);
            rows[row].response.0[lane] = self.list[index].response(&blocks[block], lane);
        }
    }

    /// Computes the rows and the laws of a pass.
    pub(super) fn write_rows(
        &mut self,
        parts: Parts<'_>,
        jacobians: &mut Jacobians,
        states: &[BodyState],
        pass: &JointPass,
        simd: Simd,
    ) {
        if self.list.is_empty() {
            return;
        }
        for index in 0..self.list.len() {
            let place = self.place(index);
            self.write_row(index, place, parts, jacobians, states, pass);
        }
        let (first, curvatures) = (self.first, &self.curvatures);
        let range = 0..curvatures.len();
        let jacobians = jacobians.share();
        simd.run(WriteLaws { range, first, parts, jacobians, curvatures, pass });
    }

    fn write_row(
        &mut self,
        index: usize,
        Place { block, row, lane }: Place,
        parts: Parts<'_>,
        jacobians: &mut Jacobians,
        states: &[BodyState],
        pass: &JointPass,
    ) {
        let constraint = &mut self.list[index];
        let velocities = constraint.velocities(states);
        let (to, driven) = (&mut jacobians.blocks[block], &mut jacobians.driven[row]);
        let mut used = constraint.now;
        let mut curvature = 0.0;
        if pass.is_biased {
            let predicted = constraint.predicted_ends(states, pass.substep);
            let linear_rate = rate(&constraint.now, velocities);
            let whole_rate = (sum(&predicted) - sum(&constraint.now)) * pass.inv_substep;
            if to.includes_curvature.0[lane] > 0.0 {
                let bound = CURVATURE_FRACTION_MAX * speed(&constraint.now, velocities);
                curvature = (whole_rate - linear_rate).min(bound).max(-bound);
            }
            if to.at_predicted_pose.0[lane] > 0.0 {
                used = predicted;
                curvature += linear_rate - rate(&used, velocities);
            }
        }
        // SAFETY: nothing else uses the parts, and the row is that of this transmission.
        let axis_row = unsafe { parts.rows.get_mut(row) };
        axis_row.position.0[lane] = constraint.counted + sum(&constraint.now);
        driven.rate.0[lane] = rate(&used, velocities);
        self.curvatures[block - self.first[0]].0[lane] = curvature;
        for (side, end) in used.iter().enumerate() {
            for (lanes, number) in driven.row[side].iter_mut().zip(end.row()) {
                lanes.0[lane] = number;
            }
        }
        // SAFETY: nothing else uses the parts.
        let block = unsafe { parts.blocks.get(block) };
        to.first_row = row;
        (to.inv_mass, to.inv_inertia) = (block.inv_mass, *block.inertias.lanes());
    }

    /// Takes the changes of the impulses. The bodies have them already. The last round of a substep has their
    /// states, and the length of the next one.
    pub fn finish_round(
        &mut self,
        (blocks, rows): (&mut [JointBlock], &mut [AxisRow]),
        jacobians: &Jacobians,
        last_of_substep: Option<(&[BodyState], Real)>,
    ) {
        for index in 0..self.list.len() {
            let Place { block, row, lane } = self.place(index);
            let (block, row, from) = (&mut blocks[block], &mut rows[row], &jacobians.driven[row]);
            row.motor.impulse.0[lane] = from.motor.0[lane];
            row.lower.0[lane] = from.lower.0[lane];
            row.upper.0[lane] = from.upper.0[lane];
            let constraint = &mut self.list[index];
            for side in 0..2 {
                let mut wrench = [0.0; SPATIAL_DIM];
                for (number, lanes) in wrench.iter_mut().zip(&from.row[side]) {
                    *number = lanes.0[lane] * from.change.0[lane];
                }
                let change = response_of(block, side, lane, &wrench);
                constraint.applied[side] = plus(constraint.applied[side], change);
            }
            if let Some((states, h)) = last_of_substep {
                row.motor.rate.0[lane] = from.rate.0[lane];
                constraint.count_impulse(impulse(row, lane));
                constraint.block_ends(states, h);
            }
            constraint.note_pull(block, lane, impulse(row, lane));
        }
    }

    /// Ends the step, while the bodies are still where the solver has put them.
    pub fn finish(&mut self, states: &[BodyState]) {
        self.rotated.clear();
        self.rotated.extend(self.list.iter().map(|constraint| constraint.rotated(states)));
    }

    /// Writes impulses, forces and rotations to the joints. Returns whether one is overloaded.
    pub fn store(
        &self,
        islands: &IslandManager,
        joints: &mut Frozen<'_, ImpulseJointSet>,
        rows: &[AxisRow],
        inv_dt: Real,
    ) -> bool {
        let mut any_overloaded = false;
        for (index, constraint) in self.list.iter().enumerate() {
            let Place { row, lane, .. } = self.place(index);
            let handle = islands.joints.get(constraint.slot).map(|link| link.handle);
            let Some(joint) = handle.and_then(|handle| joints.get_unnoted_mut(handle)) else {
                continue;
            };
            let (k, row) = (JointAxis::LinX as usize, &rows[row]);
            joint.data.limits[k].impulse = row.lower.0[lane] - row.upper.0[lane];
            joint.data.motors[k].impulse = row.motor.impulse.0[lane];
            if let Some(count) = &mut joint.count {
                count.rotated = self.rotated[index];
            }
            let (force, torque) = constraint.total;
            (joint.force, joint.torque) = (force * inv_dt, torque * inv_dt);
            if !joint.is_sound() {
                joint.clear_impulses();
            }
            any_overloaded |= is_overloaded(joint);
        }
        any_overloaded
    }
}

block_kernel! {
    /// Rotates the inertias of a block by the displacements of the bodies.
    struct RotateInertias<'a> {
        blocks: DisjointMut<'a, JointBlock>,
        states: DisjointMut<'a, BodyState>,
    }
    |index| {
        let block = blocks.get_mut(index);
        let bodies = Bodies::<W>::gather(&states, &block.bodies);
        block.inertias.rotate(&bodies.displacements);
    }
}

block_kernel! {
    /// Computes the laws of the rows of a block.
    struct WriteLaws<'a> {
        first: [usize; 2],
        parts: Parts<'a>,
        jacobians: SharedJacobians<'a>,
        curvatures: &'a [Lane],
        pass: &'a JointPass,
    }
    |index| {
        let row = parts.rows.get_mut(first[1] + index);
        let memory = jacobians.blocks.get(first[0] + index);
        let to = jacobians.driven.get_mut(first[1] + index);
        let direction = WideVector::<W>::load(&row.linear);
        let now = AxisNow {
            position: W::load(&row.position),
            curvature: W::load(&curvatures[index]),
            is_translation: W::splat(0.5).lt(direction.dot(direction)),
        };
        write_law::<W>(memory, row, to, &now, pass);
    }
}
