//! One transmission: its ends, and the effect of its impulses on both bodies.

use super::super::JointLoadContext;
use super::super::block::{AxisRow, JointBlock};
use super::super::direct::CORRECTED_APART_RATE_MIN;
use super::super::load::{End as JointEnd, load_motor_and_limits};
use crate::dim::joint_axes::JointAxis;
use crate::dim::math::{
    ANG_ZERO, AngVector, Pose, Real, SPATIAL_DIM, SpatialVector, Vector, mul_inertia,
};
use crate::dim::spatial::{angular, join, linear};
use crate::dim::state::{BodyState, READ_ONLY};
use crate::model::joint::ImpulseJoint;
use crate::model::params::JointPass;
use crate::step::solver::transmission_end::{End, EndNow, Moved};

/// One transmission.
#[derive(Clone, Debug)]
pub(super) struct Constraint {
    pub slot: u32,
    pub bodies: [u32; 2],
    ends: [End; 2],
    /// Sum of the angles and shifts when the step began.
    pub counted: Real,
    /// The ends in this pass.
    pub now: [EndNow; 2],
    /// Whether the ends are at the points of their ropes: see [`End::is_blocked`].
    is_blocked: [bool; 2],
    /// The velocity changes by its impulses in this substep.
    pub applied: [SpatialVector; 2],
    /// Sums over all substeps: impulse and couple on the second body.
    pub total: (Vector, AngVector),
}

/// Fills one lane of a block and its row.
pub(super) fn load_lane(
    (block, row, lane): (&mut JointBlock, &mut AxisRow, usize),
    slot: u32,
    joint: &mut ImpulseJoint,
    context: JointLoadContext<'_>,
    pass: &JointPass,
) -> Option<Constraint> {
    let transmission = joint.data.transmission?;
    let [first, second] = JointEnd::both(joint, context, pass)?;
    let bodies = [first.index, second.index];
    joint.scale_impulses(context.bodies.impulse_fractions(bodies).of_joints);
    let ends = [(0, &first), (1, &second)].map(|(side, end)| {
        end.write(block, side, lane);
        End::new(&transmission, side, end.center, end.arm, end.frame)
    });
    let frames = [&first, &second].map(|end| Pose::from_parts(end.center + end.arm, end.frame));
    let count = transmission.count(joint.count, frames);
    joint.count = Some(count);
    let (counted, now) = (count.sum, ends.map(|end| end.after(&Moved::NONE)));
    load_motor_and_limits(row, lane, &joint.data, JointAxis::LinX, pass);
    let is_angle = ends[0].is_angle() && ends[1].is_angle();
    row.linear.set_lane(lane, if is_angle { Vector::ZERO } else { Vector::X });
    let position = counted + sum(&now);
    let excess = (position - row.max.0[lane]).max(row.min.0[lane] - position);
    let is_far = excess * pass.inv_substep > CORRECTED_APART_RATE_MIN;
    block.exceeds_limit.0[lane] = if is_far { 1.0 } else { 0.0 };
    let distances = ends.iter().zip(&now).filter(|(end, _)| end.is_distance());
    let shortest = distances.map(|(_, now)| now.coordinate.abs()).fold(Real::INFINITY, Real::min);
    if shortest.is_finite() {
        block.separation.set_lane(lane, Vector::X * shortest);
    }
    let (applied, total) = ([[0.0; SPATIAL_DIM]; 2], (Vector::ZERO, ANG_ZERO));
    let is_blocked = [false; 2];
    let constraint = Constraint { slot, bodies, ends, counted, now, is_blocked, applied, total };
    constraint.note_pull(block, lane, impulse(row, lane));
    Some(constraint)
}

impl Constraint {
    /// Moves the ends to the current poses.
    pub fn move_ends(&mut self, states: &[BodyState]) {
        for side in 0..2 {
            let displacement = states[(self.bodies[side] & !READ_ONLY) as usize].displacement();
            self.now[side] = self.ends[side].after(&Moved::by(displacement));
            if self.is_blocked[side] {
                self.now[side].force = Vector::ZERO;
            }
        }
    }

    /// Adds an impulse along the present row to the sums over all substeps.
    pub fn count_impulse(&mut self, impulse: Real) {
        let [_, second] = self.now;
        self.total.0 += second.force * impulse;
        self.total.1 += second.couple * impulse;
    }

    /// Blocks the ends that can reach their points within a time `h` with the velocities at the end of a
    /// substep. (While its joints have not been solved, a light body may have any velocity.)
    pub fn block_ends(&mut self, states: &[BodyState], h: Real) {
        let velocities = self.velocities(states);
        for side in 0..2 {
            let displacement = states[(self.bodies[side] & !READ_ONLY) as usize].displacement();
            let (end, moved) = (&self.ends[side], Moved::by(displacement));
            self.is_blocked[side] = end.is_blocked(&end.after(&moved), &velocities[side], h);
        }
    }

    /// Notes the force of an impulse for the test of geometric stiffness. It reads the size alone.
    pub fn note_pull(&self, block: &mut JointBlock, lane: usize, impulse: Real) {
        let [first, second] = self.now.map(|end| end.force.length());
        block.applied.linear.set_lane(lane, Vector::X * (impulse.abs() * first.max(second)));
    }

    /// The angles by which the ends have rotated since the step began.
    pub fn rotated(&self, states: &[BodyState]) -> [Real; 2] {
        core::array::from_fn(|side| {
            let displacement = states[(self.bodies[side] & !READ_ONLY) as usize].displacement();
            self.ends[side].angle_after(displacement)
        })
    }

    /// The ends after the time `h` with the current velocities. Blocked ends stay blocked.
    pub fn predicted_ends(&self, states: &[BodyState], h: Real) -> [EndNow; 2] {
        core::array::from_fn(|side| {
            let state = &states[(self.bodies[side] & !READ_ONLY) as usize];
            let moved = Moved::by(state.displacement()).further(state.velocity(), h);
            if self.is_blocked[side] { self.now[side] } else { self.ends[side].after(&moved) }
        })
    }

    pub fn velocities(&self, states: &[BodyState]) -> [SpatialVector; 2] {
        self.bodies.map(|body| {
            let (v, w) = states[(body & !READ_ONLY) as usize].velocity();
            join(v, w)
        })
    }

    /// `J M⁻¹ Jᵀ`.
    pub fn response(&self, block: &JointBlock, lane: usize) -> Real {
        let sides = self.now.iter().enumerate();
        sides.map(|(side, end)| dot(&end.row(), &response_of(block, side, lane, &end.row()))).sum()
    }

    /// Replaces the impulse in the velocities by this one along the current rows.
    pub fn apply(
        &mut self,
        impulse: Real,
        block: &JointBlock,
        lane: usize,
        states: &mut [BodyState],
    ) {
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
pub(super) fn response_of(
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
pub(super) fn impulse(row: &AxisRow, lane: usize) -> Real {
    row.motor.impulse.0[lane] + row.lower.0[lane] - row.upper.0[lane]
}

/// The coordinates of both ends together.
pub(super) fn sum(ends: &[EndNow; 2]) -> Real {
    ends[0].coordinate + ends[1].coordinate
}

/// `J v`.
pub(super) fn rate(ends: &[EndNow; 2], velocities: [SpatialVector; 2]) -> Real {
    dot(&ends[0].row(), &velocities[0]) + dot(&ends[1].row(), &velocities[1])
}

/// The largest rate that these speeds of the anchors could give.
pub(super) fn speed(ends: &[EndNow; 2], velocities: [SpatialVector; 2]) -> Real {
    let sides = ends.iter().zip(velocities).map(|(end, velocity)| end.speed(&velocity));
    sides.sum()
}

fn dot(a: &SpatialVector, b: &SpatialVector) -> Real {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

pub(super) fn plus(a: SpatialVector, b: SpatialVector) -> SpatialVector {
    core::array::from_fn(|k| a[k] + b[k])
}
