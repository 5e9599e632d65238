//! From joints to constraints: once per step, on several threads.

use super::block::{AxisRow, JointBlock, LIMIT_NONE};
use super::direct::{CORRECTED_APART_RATE_MIN, DirectJoint};
use super::{BLOCKS_PER_TASK, LaneSlot, SolverJoints};
use crate::base::disjoint::DisjointMut;
use crate::base::tasks::Tasks;
use crate::base::wide::Lane;
use crate::dim::joint::{FreeRotations, angle_about, couple_of, is_round};
use crate::dim::joint_axes::{JointAxesMask, JointAxis};
use crate::dim::math::{
    ANG_DIM, AngularInertia, DIM, Pose, Real, Rotation, Vector, ang_length_squared, zero_inertia,
};
use crate::dim::spatial::locked_angles;
use crate::dim::state::READ_ONLY;
use crate::dim::wide::set_ang_lane;
use crate::model::body::{RigidBody, RigidBodySet};
use crate::model::constraint_graph::OVERFLOW;
use crate::model::frozen::Frozen;
use crate::model::island::IslandManager;
use crate::model::joint::{
    GenericJoint, ImpulseJoint, ImpulseJointSet, JointLimits, MotorModel, mask_of, nearest_turn,
    relative_rotation,
};
use crate::model::params::JointPass;
use crate::step::solver::bodies::SolverBodies;
use crate::step::solver::links::Links;

/// The least compliance of iteratively solved joints. Iterations leave errors, and a chain without compliance
/// gains energy by its own corrections: see [`CONTACT_COMPLIANCE`](crate::model::params::CONTACT_COMPLIANCE).
const ITERATED_COMPLIANCE: Real = 1.0 / 8.0;

/// A body that rotates by less than this angle (rad) in a substep keeps its inertia for the step.
const ROTATION_ANGLE_MIN: Real = 1.0e-4;

/// Largest angle (rad) of an error that a substep corrects. A larger linear correction throws the bodies.
const CORRECTION_ANGLE_MAX: Real = 0.5;

/// Number of joints per parallel task.
const JOINTS_PER_TASK: usize = 64;

/// Context for loading joints.
#[derive(Copy, Clone)]
pub(in crate::step::solver) struct JointLoadContext<'a> {
    pub islands: &'a IslandManager,
    pub world: &'a RigidBodySet,
    pub bodies: &'a SolverBodies,
    pub links: &'a Links,
}

impl SolverJoints {
    /// Makes constraints of the joints that have a colour. Joints of links are left to their multibodies.
    pub fn load(
        &mut self,
        joints: &mut Frozen<'_, ImpulseJointSet>,
        context: JointLoadContext<'_>,
        pass: &JointPass,
        tasks: Tasks<'_>,
    ) {
        self.find_members(context, tasks);
        self.direct.build(&self.members, context.bodies.states.len());
        self.assign_lane_slots();
        self.fill_blocks(joints, context, pass, tasks);
        let Self { transmissions, members, blocks, rows, direct, .. } = self;
        transmissions.load(members, joints, context, pass, (blocks, rows));
        transmissions.note_alone(direct, rows);
        self.note_exact_joints(context.bodies.states.len());
        self.point_to_point.load(joints, context, pass, tasks);
        debug_assert_eq!(self.len(), self.members.len(), "each joint has one place");
        debug_assert!(self.blocks.iter().all(|block| block.axis_rows().end <= self.rows.len()));
        let mut ends = self.blocks.iter().flat_map(|block| block.bodies).flatten();
        debug_assert!(ends.all(|body| context.bodies.has_state(body)));
    }

    /// Finds the active joints.
    fn find_members(&mut self, context: JointLoadContext<'_>, tasks: Tasks<'_>) {
        self.slots.clear();
        self.colors.clear();
        for (color, list) in context.islands.joint_graph.in_solving_order() {
            let first = self.slots.len();
            self.slots.extend_from_slice(list);
            if color == OVERFLOW {
                // These are solved one after the other, and their order in the list depends on the rest of
                // the world.
                self.slots[first..].sort_unstable();
            }
            self.colors.push((color, list.len()));
        }
        let slots = &self.slots;
        self.members.resize(slots.len(), DirectJoint::NONE);
        tasks.par_fill(&mut self.members, JOINTS_PER_TASK, |index| {
            context.member(slots[index]).unwrap_or(DirectJoint::NONE)
        });
        let mut rest = self.members.as_slice();
        for (_, count) in &mut self.colors {
            let (members, others) = rest.split_at(*count);
            *count = members.iter().filter(|member| member.is_valid()).count();
            rest = others;
        }
        self.members.retain(DirectJoint::is_valid);
    }

    /// Decides how each joint is solved, and where.
    fn assign_lane_slots(&mut self) {
        self.layout.clear();
        self.point_to_point.clear();
        let mut rest = self.members.as_slice();
        for &(color, count) in &self.colors {
            let (members, later) = rest.split_at(count);
            let is_point_to_point = |member: &&DirectJoint| {
                member.form.is_point_to_point && !self.direct.contains(member.slot)
            };
            let slots = |member: &DirectJoint| member.slot;
            let lane_slot =
                |member: &DirectJoint| LaneSlot { slot: member.slot, driven: member.form.driven };
            self.point_to_point.add(color, members.iter().filter(is_point_to_point).map(slots));
            for is_exact in [true, false] {
                let of_method = members.iter().filter(|member| {
                    self.direct.contains(member.slot) == is_exact
                        && !is_point_to_point(member)
                        && !member.form.is_transmission
                });
                // Blocks that lock no rotation have half of the rows.
                let turning = of_method.clone().filter(|member| !member.form.locks_rotations());
                let others = of_method.filter(|member| member.form.locks_rotations());
                self.layout.add(color, turning.chain(others).map(lane_slot));
            }
            rest = later;
        }
    }

    /// Makes the blocks of all joints that are not point-to-point joints, and their rows.
    fn fill_blocks(
        &mut self,
        joints: &mut Frozen<'_, ImpulseJointSet>,
        context: JointLoadContext<'_>,
        pass: &JointPass,
        tasks: Tasks<'_>,
    ) {
        self.first_rows.clear();
        let mut row_count = 0;
        for lane_slots in self.layout.blocks() {
            self.first_rows.push(row_count);
            row_count +=
                lane_slots.iter().map(|lane_slot| usize::from(lane_slot.driven)).max().unwrap_or(0);
        }
        self.first_rows.push(row_count);
        self.rows.resize(row_count, AxisRow::EMPTY);
        self.blocks.resize(self.layout.block_count(), JointBlock::EMPTY);
        let (layout, direct, first_rows) = (&self.layout, &self.direct, &self.first_rows);
        let (blocks, rows) = (DisjointMut::new(&mut self.blocks), DisjointMut::new(&mut self.rows));
        let joints = joints.share();
        tasks.par_for(layout.block_count(), BLOCKS_PER_TASK, |range| {
            for index in range {
                let place = first_rows[index]..first_rows[index + 1];
                // SAFETY: each block belongs to one task, and so do its rows.
                let (block, rows) =
                    unsafe { (blocks.get_mut(index), rows.range_mut(place.clone())) };
                *block = JointBlock::EMPTY;
                (block.first_row, block.row_count) = (place.start, place.len());
                rows.fill(AxisRow::EMPTY);
                for (lane, lane_slot) in layout.block(index).iter().enumerate() {
                    let Some(link) = context.islands.joints.get(lane_slot.slot) else { continue };
                    // SAFETY: each joint has one lane slot.
                    let Some(entry) = (unsafe { joints.get_mut(link.handle.0) }) else { continue };
                    block.is_exact = direct.contains(lane_slot.slot);
                    load_lane(block, rows, lane, &mut entry.joint, context, pass);
                    if direct.is_alone(lane_slot.slot) {
                        rows.iter_mut().for_each(|row| row.motor.is_alone.0[lane] = 1.0);
                    }
                }
            }
        });
    }

    /// Stores the positions of their rows in the joints that are solved directly.
    fn note_exact_joints(&mut self, body_count: usize) {
        if self.direct.is_empty() {
            self.direct.begin_step(&[], &mut []);
            return self.jacobians.clear();
        }
        self.jacobians.resize(self.blocks.len(), self.rows.len());
        self.geometric_stiffness.clear(body_count);
        for (index, block) in self.blocks.iter().enumerate().filter(|(_, block)| block.is_exact) {
            for (lane, lane_slot) in self.layout.block(index).iter().enumerate() {
                if !self.direct.place(lane_slot.slot, [index, lane]) {
                    continue;
                }
                for side in 0..2 {
                    self.geometric_stiffness.note(block, side, lane);
                }
            }
        }
        let Self { transmissions, direct, blocks, geometric_stiffness, .. } = self;
        transmissions.note_places(direct, blocks, |block, side, lane| {
            geometric_stiffness.note(block, side, lane);
        });
        self.direct.begin_step(&self.blocks, &mut self.jacobians.blocks);
    }
}

impl JointLoadContext<'_> {
    /// The joint in a slot, if it is active.
    fn member(&self, slot: u32) -> Option<DirectJoint> {
        let Self { bodies, links, .. } = self;
        let link = self.islands.joints.get(slot)?;
        let slots = link.body_slots();
        if !bodies.has_one_of(slots) || links.moves_one_of(slots) {
            return None;
        }
        let ends = slots.map(|slot| bodies.index_of(slot));
        let exceeds_energy =
            |end: &u32| end & READ_ONLY == 0 && bodies.energy_errors[*end as usize].is_exceeded;
        let is_strained = ends.iter().any(exceeds_energy);
        let joint = DirectJoint::new(slot, ends, link.form, &bodies.poses);
        Some(DirectJoint { is_strained, ..joint })
    }
}

/// One end of a joint: the solver's data of the body, and the joint's frame on it.
pub(super) struct End {
    pub index: u32,
    pub center: Vector,
    pub arm: Vector,
    pub frame: Rotation,
    inv_mass: Vector,
    inv_inertia: AngularInertia,
    is_gyroscopic: bool,
}

impl End {
    /// Both ends of a joint.
    pub fn both(
        joint: &ImpulseJoint,
        JointLoadContext { world, bodies, .. }: JointLoadContext<'_>,
        pass: &JointPass,
    ) -> Option<[Self; 2]> {
        let (body1, body2) = (joint.body1(), joint.body2());
        let (first, second) = (world.get(body1)?, world.get(body2)?);
        let frames = [joint.data.local_frame1, joint.data.local_frame2];
        Some([
            Self::new(first, body1.into_raw_parts().0, frames[0], bodies, pass),
            Self::new(second, body2.into_raw_parts().0, frames[1], bodies, pass),
        ])
    }

    /// Writes the numbers of the body to one lane of a block.
    pub fn write(&self, block: &mut JointBlock, side: usize, lane: usize) {
        block.bodies[side][lane] = self.index;
        block.inv_mass[side].set_lane(lane, self.inv_mass);
        block.inertias.set_lane(side, lane, &self.inv_inertia, self.is_gyroscopic);
        block.arms[side].set_lane(lane, self.arm);
        block.frames[side].set_lane(lane, &self.frame);
    }

    fn new(
        body: &RigidBody,
        slot: u32,
        frame: Pose,
        bodies: &SolverBodies,
        pass: &JointPass,
    ) -> Self {
        let (pose, mprops) = (body.position(), &body.mprops);
        let index = bodies.index_of(slot);
        let movable = index & READ_ONLY == 0;
        Self {
            index,
            center: mprops.world_com,
            arm: pose.rotation * (frame.translation - mprops.local_mprops.local_com),
            frame: pose.rotation * frame.rotation,
            inv_mass: if movable { mprops.inv_mass } else { Vector::ZERO },
            inv_inertia: if movable { mprops.inv_inertia } else { zero_inertia() },
            is_gyroscopic: movable && is_gyroscopic(body, pass.substep),
        }
    }
}

/// Returns whether a body rotates so far in a substep that its world-space inertia changes noticeably.
pub(super) fn is_gyroscopic(body: &RigidBody, substep: Real) -> bool {
    let angle_squared = ang_length_squared(body.vels.angvel) * substep * substep;
    let mprops = &body.mprops;
    angle_squared >= ROTATION_ANGLE_MIN * ROTATION_ANGLE_MIN
        && mprops.rotates_freely()
        && !is_round(&mprops.inv_inertia)
}

/// Fills one lane of a block, and of its rows.
fn load_lane(
    block: &mut JointBlock,
    rows: &mut [AxisRow],
    lane: usize,
    joint: &mut ImpulseJoint,
    context: JointLoadContext<'_>,
    pass: &JointPass,
) {
    let Some(ends) = End::both(joint, context, pass) else { return };
    for (side, end) in ends.iter().enumerate() {
        end.write(block, side, lane);
    }
    // Differences of positions first: far from the origin these have few digits.
    let separation = (ends[1].center - ends[0].center) + (ends[1].arm - ends[0].arm);
    block.separation.set_lane(lane, separation);
    let fractions = context.bodies.impulse_fractions([ends[0].index, ends[1].index]);
    joint.scale_impulses(fractions.of_joints);
    load_locked(block, lane, joint, pass);
    if joint.data.spring().is_none() {
        block.bias_rate.0[lane] *= pass.bias_scale(separation);
    }
    let between = relative_rotation(&ends[0].frame, &ends[1].frame);
    load_rows(rows, lane, joint, &between, pass);
    if block.is_exact {
        let seen_from_first = ends[0].frame.inverse() * separation;
        let ([distance, angle], is_rigid) =
            (largest_errors(joint, seen_from_first, &between), joint.data.spring().is_none());
        let is_large = |error| error * pass.inv_substep > CORRECTED_APART_RATE_MIN;
        joint.is_displaced &= is_rigid && is_large(distance.max(angle));
        block.is_displaced.0[lane] = if joint.is_displaced { 1.0 } else { 0.0 };
        let excess = largest_excess(joint, seen_from_first);
        block.exceeds_limit.0[lane] = if is_large(excess) { 1.0 } else { 0.0 };
        if is_rigid {
            block.bias_rate.0[lane] *= (CORRECTION_ANGLE_MAX / angle).min(1.0);
        }
    }
}

/// The largest errors of the locked translations and rotations (rad; at least a small angle).
fn largest_errors(joint: &ImpulseJoint, separation: Vector, between: &Rotation) -> [Real; 2] {
    let is_locked = |axis: JointAxis| joint.data.locked_axes.contains(mask_of(axis));
    let distances = JointAxis::ALL[..DIM].iter().zip(separation.to_array());
    let distances = distances.filter(|(axis, _)| is_locked(**axis)).map(|(_, error)| error.abs());
    let angles = JointAxis::ALL[DIM..].iter().zip(locked_angles(*between));
    let angles = angles.filter(|(axis, _)| is_locked(**axis)).map(|(_, (angle, _))| angle.abs());
    [distances.fold(0.0, Real::max), angles.fold(Real::EPSILON, Real::max)]
}

/// The largest excess over a limit (length units or radians).
fn largest_excess(joint: &ImpulseJoint, separation: Vector) -> Real {
    let (data, distances) = (&joint.data, separation.to_array());
    let mut excess: Real = 0.0;
    for axis in data.driven_axes() {
        let Some(limits) = data.limits(axis) else { continue };
        let together = data.coupled_axes & !data.locked_axes & JointAxesMask::LIN_AXES;
        let position = match (axis as usize).checked_sub(DIM) {
            Some(k) => joint.angles.map_or(0.0, |angles| angles[k]),
            None if together.contains(mask_of(axis)) => {
                let coupled = JointAxis::ALL[..DIM].iter().zip(distances);
                let coupled = coupled.filter(|(axis, _)| together.contains(mask_of(**axis)));
                coupled.map(|(_, distance)| distance * distance).sum::<Real>().sqrt()
            }
            None => distances[axis as usize],
        };
        excess = excess.max(position - limits.max).max(limits.min - position);
    }
    excess
}

fn load_locked(block: &mut JointBlock, lane: usize, joint: &ImpulseJoint, pass: &JointPass) {
    let softness = match joint.data.spring() {
        None => pass.softness,
        Some(spring) => spring.in_steps_of(pass.substep),
    };
    let is_spring = joint.data.spring().is_some();
    let compliance = softness.compliance().min(LIMIT_NONE);
    block.bias_rate.0[lane] = softness.bias_rate;
    block.is_spring.0[lane] = if is_spring { 1.0 } else { 0.0 };
    let is_rigid = is_spring || block.is_exact;
    block.compliance.0[lane] =
        if is_rigid { compliance } else { compliance.max(ITERATED_COMPLIANCE) };
    block.has_distances |= joint.data.driven_axes().any(|axis| (axis as usize) < DIM);
    block.has_springs |= is_spring;
    block.locks_rotations |= joint.data.locked_axes.intersects(JointAxesMask::ANG_AXES);
    for axis in JointAxis::ALL {
        let locked = joint.data.locked_axes.contains(mask_of(axis));
        block.locked[axis as usize].0[lane] = if locked { 1.0 } else { 0.0 };
        let starts = locked && (axis as usize) < DIM;
        let impulse = if starts { joint.impulses[axis as usize] } else { 0.0 };
        block.impulses[axis as usize].0[lane] = impulse;
    }
    set_ang_lane(&mut block.couple, lane, couple_of(&joint.impulses));
}

/// Fills one lane of the rows.
fn load_rows(
    rows: &mut [AxisRow],
    lane: usize,
    joint: &mut ImpulseJoint,
    between: &Rotation,
    pass: &JointPass,
) {
    let mut angles = [0.0; ANG_DIM];
    for (row, axis) in rows.iter_mut().zip(joint.data.driven_axes()) {
        match (axis as usize).checked_sub(DIM) {
            None => load_translation(row, lane, &joint.data, axis),
            Some(k) => {
                let last = joint.angles.map(|angles| angles[k]);
                angles[k] = load_rotation(row, lane, &joint.data, axis, between, last);
            }
        }
        load_motor_and_limits(row, lane, &joint.data, axis, pass);
    }
    joint.angles = Some(angles);
}

fn load_translation(row: &mut AxisRow, lane: usize, joint: &GenericJoint, axis: JointAxis) {
    let mut direction = Vector::ZERO;
    direction[axis as usize] = 1.0;
    row.linear.set_lane(lane, direction);
    let coupled = joint.coupled_axes & !joint.locked_axes & JointAxesMask::LIN_AXES;
    for other in &JointAxis::ALL[..DIM] {
        let together = coupled.contains(mask_of(axis)) && coupled.contains(mask_of(*other));
        row.coupled[*other as usize].0[lane] = if together { 1.0 } else { 0.0 };
    }
}

/// Loads the row of a rotation. Returns the angle, with all turns since the joint was first measured.
fn load_rotation(
    row: &mut AxisRow,
    lane: usize,
    joint: &GenericJoint,
    axis: JointAxis,
    between: &Rotation,
    last: Option<Real>,
) -> Real {
    let rotations = FreeRotations::new(!joint.locked_axes, joint.coupled_axes);
    let (angle, _) = angle_about(axis, rotations, between);
    let angle = match last {
        _ if !rotations.is_single() => angle,
        Some(last) => nearest_turn(angle, last),
        None => joint.limits(axis).map_or(angle, |limits| limits.first_reading(angle)),
    };
    row.angle_tracker.set_lane(lane, axis, rotations, angle);
    angle
}

pub(super) fn load_motor_and_limits(
    row: &mut AxisRow,
    lane: usize,
    joint: &GenericJoint,
    axis: JointAxis,
    pass: &JointPass,
) {
    let set =
        |target: &mut Lane, value: Real| target.0[lane] = value.clamp(-LIMIT_NONE, LIMIT_NONE);
    if let Some(motor) = joint.motor(axis) {
        let per_mass = motor.model == MotorModel::AccelerationBased;
        set(&mut row.motor.stiffness, motor.stiffness);
        set(&mut row.motor.damping, motor.damping);
        set(&mut row.motor.per_mass, if per_mass { 1.0 } else { 0.0 });
        set(&mut row.motor.target_pos, motor.target_pos);
        set(&mut row.motor.target_vel, motor.target_vel);
        set(&mut row.motor.max_impulse, (motor.max_force * pass.substep).min(LIMIT_NONE));
        set(&mut row.motor.impulse, motor.impulse);
    }
    if let Some(JointLimits { min, max, impulse }) = joint.limits(axis).copied() {
        // A distance and the angle of a swing are never negative. A limit there would only stop bodies that
        // pass through zero.
        let has_sign = !joint.is_measured_together(axis);
        let min = if has_sign || min > 0.0 { min } else { -LIMIT_NONE };
        set(&mut row.min, min);
        set(&mut row.max, max);
        set(&mut row.lower, impulse.max(0.0));
        set(&mut row.upper, (-impulse).max(0.0));
    }
}
