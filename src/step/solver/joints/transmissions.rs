//! Transmissions: gears, racks and pulleys.
//!
//! ```text
//! low ≤ q ≤ high        q = r₁ q₁ + r₂ q₂        q̇ = Σ r J v
//! ```
//!
//! A transmission has one driven row (`../axis_law.rs`) in the system of the joints that it is connected with:
//! a gear with the hinges of both wheels. The sum is relative to the world, so the forces on the two bodies
//! are not opposite to each other, and lanes of ordinary joints cannot hold them. There are few
//! transmissions, and rows are computed one by one (`../transmission_end.rs`). Laws and masses have lanes: a
//! block behind those of the other joints holds up to [`LANES`] transmissions.

use super::block::{AxisRow, JointBlock};
use super::direct::{AxisNow, Direct, Jacobians, write_law};
use super::load::{End as JointEnd, load_motor_and_limits};
use super::{DirectJoint, JointLoadContext, Parts, SharedJacobians};
use crate::base::disjoint::DisjointMut;
use crate::base::wide::{LANES, Lane, Simd};
use crate::dim::joint_axes::JointAxis;
use crate::dim::math::{
    ANG_ZERO, AngVector, Real, SPATIAL_DIM, SpatialVector, Vector, mul_inertia,
};
use crate::dim::spatial::{angular, join, linear};
use crate::dim::state::{BodyState, READ_ONLY};
use crate::dim::wide::WideVector;
use crate::model::island::IslandManager;
use crate::model::joint::{ImpulseJoint, ImpulseJointSet};
use crate::model::params::JointPass;
use crate::step::solver::blocks::block_kernel;
use crate::step::solver::joint_rules::{CURVATURE_FRACTION_MAX, is_overloaded};
use crate::step::solver::states::Bodies;
use crate::step::solver::transmission_end::{End, EndNow, Moved};

/// One transmission.
#[derive(Clone, Debug)]
struct Constraint {
    slot: u32,
    bodies: [u32; 2],
    ends: [End; 2],
    /// Sum of the angles and shifts when the step began.
    progress: Real,
    /// The ends in this pass.
    now: [EndNow; 2],
    /// The velocity changes by its impulses in this substep.
    applied: [SpatialVector; 2],
    /// Sums over all substeps: impulse and couple on the second body.
    total: (Vector, AngVector),
}

/// All transmissions.
#[derive(Default)]
pub(super) struct Transmissions {
    list: Vec<Constraint>,
    /// Position of their first block, and of its row.
    first: [usize; 2],
    /// By block of theirs: the curvatures of the rows.
    curvatures: Vec<Lane>,
}

/// Where the numbers of a transmission are.
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

    /// Their slots.
    pub fn slots(&self) -> impl Iterator<Item = u32> {
        self.list.iter().map(|constraint| constraint.slot)
    }

    fn place(&self, index: usize) -> Place {
        let block = index / LANES;
        Place { block: self.first[0] + block, row: self.first[1] + block, lane: index % LANES }
    }

    /// Makes constraints of those among these joints, and blocks behind the others.
    pub fn load(
        &mut self,
        members: &[DirectJoint],
        joints: &mut ImpulseJointSet,
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
            if place.lane == 0 {
                blocks.push(JointBlock { first_row: place.row, row_count: 1, ..JointBlock::EMPTY });
                rows.push(AxisRow::EMPTY);
            }
            let lanes = (&mut blocks[place.block], &mut rows[place.row], place.lane);
            self.list.extend(load_lane(lanes, slot, joint, context, pass));
        }
        self.curvatures.clear();
        self.curvatures.resize(blocks.len() - self.first[0], Lane::ZERO);
    }

    /// Notes which of them are connected with no other joint.
    pub fn note_alone(&self, direct: &Direct, rows: &mut [AxisRow]) {
        for (index, constraint) in self.list.iter().enumerate() {
            let Place { row, lane, .. } = self.place(index);
            let is_alone = direct.is_alone(constraint.slot);
            rows[row].motor.is_alone.0[lane] = if is_alone { 1.0 } else { 0.0 };
        }
    }

    /// Tells the direct solver where their rows are. `note` receives each body.
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
    pub fn begin(&mut self, rows: &mut [AxisRow], blocks: &[JointBlock], states: &[BodyState]) {
        for index in 0..self.list.len() {
            let Place { block, row, lane } = self.place(index);
            let constraint = &mut self.list[index];
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

    /// Scales the impulses with which the next substep starts.
    pub fn scale_impulses(&mut self, factor: Real) {
        let changes = self.list.iter_mut().flat_map(|constraint| &mut constraint.applied).flatten();
        changes.for_each(|change| *change *= factor);
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
        parts: (&mut [JointBlock], &mut [AxisRow]),
        states: DisjointMut<'_, BodyState>,
        simd: Simd,
    ) {
        let (blocks, rows) = parts;
        let range = self.first[0]..blocks.len();
        simd.run(RotateInertias { range, blocks: DisjointMut::new(blocks), states });
        for index in 0..self.list.len() {
            let Place { block, row, lane } = self.place(index);
            rows[row].response.0[lane] = self.list[index].response(&blocks[block], lane);
        }
    }

    /// Computes the rows and the laws of a pass.
    pub(super) fn write_rows<const BIASED: bool>(
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
            self.write_row::<BIASED>(index, place, parts, jacobians, states, pass);
        }
        let (first, curvatures) = (self.first, &self.curvatures);
        let range = 0..curvatures.len();
        let jacobians = jacobians.share();
        simd.run(WriteLaws::<BIASED> { range, first, parts, jacobians, curvatures, pass });
    }

    fn write_row<const BIASED: bool>(
        &mut self,
        index: usize,
        Place { block, row, lane }: Place,
        parts: Parts<'_>,
        jacobians: &mut Jacobians,
        states: &[BodyState],
        pass: &JointPass,
    ) {
        let constraint = &mut self.list[index];
        constraint.move_ends(states);
        let velocities = constraint.velocities(states);
        let (to, driven) = (&mut jacobians.blocks[block], &mut jacobians.driven[row]);
        let mut used = constraint.now;
        let mut curvature = 0.0;
        if BIASED {
            let then = constraint.ends_then(states, pass.substep);
            let straight = rate(&constraint.now, velocities);
            let whole = (sum(&then) - sum(&constraint.now)) * pass.inv_substep;
            if to.includes_curvature.0[lane] > 0.0 {
                let bound = CURVATURE_FRACTION_MAX * speed(&constraint.now, velocities);
                curvature = (whole - straight).min(bound).max(-bound);
            }
            if to.at_predicted_pose.0[lane] > 0.0 {
                used = then;
                curvature += straight - rate(&used, velocities);
            }
        }
        // SAFETY: nothing else uses the parts, and the row is that of this transmission.
        let axis_row = unsafe { parts.rows.get_mut(row) };
        axis_row.position.0[lane] = constraint.progress + sum(&constraint.now);
        driven.rate.0[lane] = rate(&used, velocities);
        self.curvatures[block - self.first[0]].0[lane] = curvature;
        for (side, end) in used.iter().enumerate() {
            for (lanes, number) in driven.row[side].iter_mut().zip(end.row()) {
                lanes.0[lane] = number;
            }
        }
        // SAFETY: as above.
        let block = unsafe { parts.blocks.get(block) };
        to.first_row = row;
        (to.inv_mass, to.inv_inertia) = (block.inv_mass, *block.inertias.lanes());
    }

    /// Takes the changes of the impulses. The bodies have them already.
    pub fn finish_round(
        &mut self,
        (blocks, rows): (&mut [JointBlock], &mut [AxisRow]),
        jacobians: &Jacobians,
        is_last_of_substep: bool,
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
            if is_last_of_substep {
                row.motor.rate.0[lane] = from.rate.0[lane];
                let (impulse, [_, second]) = (impulse(row, lane), constraint.now);
                constraint.total.0 += second.force * impulse;
                constraint.total.1 += second.couple * impulse;
                // For the test of stiffness.
                let largest = constraint.now.map(|end| end.force.length()).into_iter();
                let pull = impulse.abs() * largest.fold(0.0, Real::max);
                block.applied.linear.set_lane(lane, Vector::X * pull);
            }
        }
    }

    /// Ends the step, while the bodies are still where the solver has put them: notes the progress.
    pub fn finish(&mut self, states: &[BodyState]) {
        for constraint in &mut self.list {
            constraint.move_ends(states);
            let measured = constraint.ends.iter().zip(&constraint.now);
            let counted = measured.filter(|(end, _)| !end.is_distance());
            constraint.progress += counted.map(|(_, now)| now.coordinate).sum::<Real>();
        }
    }

    /// Writes impulses, forces and progress to the joints. Returns whether one is overloaded.
    pub fn store(
        &self,
        islands: &IslandManager,
        joints: &mut ImpulseJointSet,
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
            if let Some(transmission) = &mut joint.data.transmission
                && constraint.progress.is_finite()
            {
                transmission.progress = constraint.progress;
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

/// Fills one lane of a block and its row.
fn load_lane(
    (block, row, lane): (&mut JointBlock, &mut AxisRow, usize),
    slot: u32,
    joint: &mut ImpulseJoint,
    context: JointLoadContext<'_>,
    pass: &JointPass,
) -> Option<Constraint> {
    let transmission = joint.data.transmission?;
    let [first, second] = JointEnd::both(joint, context, pass)?;
    let bodies = [first.index, second.index];
    joint.scale_impulses(context.bodies.impulse_fraction(bodies));
    let ends = [(0, &first), (1, &second)].map(|(side, end)| {
        end.write(block, side, lane);
        End::new(&transmission, side, end.center, end.arm, end.frame)
    });
    let (progress, now) = (transmission.progress, ends.map(|end| end.after(&Moved::NOWHERE)));
    load_motor_and_limits(row, lane, &joint.data, JointAxis::LinX, pass);
    let is_angle = ends[0].is_angle() && ends[1].is_angle();
    row.linear.set_lane(lane, if is_angle { Vector::ZERO } else { Vector::X });
    let position = progress + sum(&now);
    let excess = (position - row.max.0[lane]).max(row.min.0[lane] - position);
    let is_far = excess * pass.inv_substep > super::direct::CORRECTED_APART_RATE_MIN;
    block.exceeds_limit.0[lane] = if is_far { 1.0 } else { 0.0 };
    let distances = ends.iter().zip(&now).filter(|(end, _)| end.is_distance());
    let shortest = distances.map(|(_, now)| now.coordinate.abs()).fold(Real::INFINITY, Real::min);
    if shortest.is_finite() {
        block.separation.set_lane(lane, Vector::X * shortest);
    }
    let applied = [[0.0; SPATIAL_DIM]; 2];
    Some(Constraint { slot, bodies, ends, progress, now, applied, total: (Vector::ZERO, ANG_ZERO) })
}

impl Constraint {
    /// Moves the ends to the current poses.
    fn move_ends(&mut self, states: &[BodyState]) {
        for side in 0..2 {
            let displacement = states[(self.bodies[side] & !READ_ONLY) as usize].displacement();
            self.now[side] = self.ends[side].after(&Moved::by(displacement));
        }
    }

    /// The ends after the time `h` with the current velocities.
    fn ends_then(&self, states: &[BodyState], h: Real) -> [EndNow; 2] {
        core::array::from_fn(|side| {
            let state = &states[(self.bodies[side] & !READ_ONLY) as usize];
            let moved = Moved::by(state.displacement()).further(state.velocity(), h);
            self.ends[side].after(&moved)
        })
    }

    fn velocities(&self, states: &[BodyState]) -> [SpatialVector; 2] {
        self.bodies.map(|body| {
            let (v, w) = states[(body & !READ_ONLY) as usize].velocity();
            join(v, w)
        })
    }

    /// `J M⁻¹ Jᵀ`.
    fn response(&self, block: &JointBlock, lane: usize) -> Real {
        let sides = self.now.iter().enumerate();
        sides.map(|(side, end)| dot(&end.row(), &response_of(block, side, lane, &end.row()))).sum()
    }

    /// Replaces the impulse in the velocities by this one along the current rows.
    fn apply(&mut self, impulse: Real, block: &JointBlock, lane: usize, states: &mut [BodyState]) {
        for side in 0..2 {
            let wrench = self.now[side].row().map(|number| number * impulse);
            let change = response_of(block, side, lane, &wrench);
            let added = plus(change, self.applied[side].map(|number| -number));
            self.applied[side] = change;
            if self.bodies[side] & READ_ONLY == 0 {
                states[self.bodies[side] as usize].add_velocity(added);
            }
        }
    }
}

/// The velocity change of a body of a lane by a wrench about its centre of mass.
fn response_of(
    block: &JointBlock,
    side: usize,
    lane: usize,
    wrench: &SpatialVector,
) -> SpatialVector {
    let inv_inertia = block.inertias.lane(side, lane);
    let change = linear(wrench) * block.inv_mass[side].lane(lane);
    join(change, mul_inertia(&inv_inertia, angular(wrench)))
}

/// The total impulse of a lane.
fn impulse(row: &AxisRow, lane: usize) -> Real {
    row.motor.impulse.0[lane] + row.lower.0[lane] - row.upper.0[lane]
}

/// The coordinates of both ends together.
fn sum(ends: &[EndNow; 2]) -> Real {
    ends[0].coordinate + ends[1].coordinate
}

/// `J v`.
fn rate(ends: &[EndNow; 2], velocities: [SpatialVector; 2]) -> Real {
    dot(&ends[0].row(), &velocities[0]) + dot(&ends[1].row(), &velocities[1])
}

/// The largest rate that these speeds of the anchors could give.
fn speed(ends: &[EndNow; 2], velocities: [SpatialVector; 2]) -> Real {
    let sides = ends.iter().zip(velocities).map(|(end, velocity)| end.speed(&velocity));
    sides.sum()
}

fn dot(a: &SpatialVector, b: &SpatialVector) -> Real {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn plus(a: SpatialVector, b: SpatialVector) -> SpatialVector {
    core::array::from_fn(|k| a[k] + b[k])
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
    struct WriteLaws<'a, const BIASED: bool> {
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
        write_law::<W, BIASED>(memory, row, to, &now, pass);
    }
}
