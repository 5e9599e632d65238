//! The memory of joint constraints.

use crate::base::wide::{LANES, Lane};
use crate::dim::joint::{AngleTracker, JointedInertias};
use crate::dim::math::{ANG_DIM, DIM, Real, SPATIAL_DIM};
use crate::dim::state::READ_ONLY;
use crate::dim::wide::{
    ANG_ZERO_LANES, WideAngVector, WideRotation, WideVector, ang_lane, set_ang_lane,
};

/// Value for "no limit": far beyond every length, and finite.
pub(super) const LIMIT_NONE: Real = 1.0e30;

/// An impulse on the second body at `p`, and the moments that it and the couples give each body about
/// its centre of mass. The first body gets the opposites.
#[derive(Copy, Clone, Debug, Default)]
pub(super) struct Wrench<W> {
    pub linear: WideVector<W>,
    pub angular: [WideAngVector<W>; 2],
}

/// [`LANES`] joints of one colour: where they are, and their locked axes.
#[derive(Clone, Debug)]
pub(super) struct JointBlock {
    pub bodies: [[u32; LANES]; 2],
    pub inv_mass: [WideVector<Lane>; 2],
    pub inertias: JointedInertias,
    /// From the centres of mass to the anchors when the step began.
    pub arms: [WideVector<Lane>; 2],
    /// From the first anchor to the second when the step began.
    pub separation: WideVector<Lane>,
    /// The joint's frames when the step began, in world space.
    pub frames: [WideRotation<Lane>; 2],
    /// One for locked axes, zero for free ones.
    pub locked: [Lane; SPATIAL_DIM],
    /// Velocity per unit of error (1/s).
    pub bias_rate: Lane,
    /// One for joints with a softness of their own: springs, which the relax pass must not make rigid.
    pub is_spring: Lane,
    /// Compliance of the rows (see [`Softness`](crate::model::params::Softness)).
    pub compliance: Lane,
    /// One for joints of stiff components (see `geometric_stiffness.rs`), zero for others.
    pub is_stiff: Lane,
    /// One for joints with large errors of locked axes by a program's edit when the step began.
    pub is_displaced: Lane,
    /// One for joints with a large excess over a limit when the step began.
    pub exceeds_limit: Lane,
    /// The bias of the errors when the substep began.
    pub held_bias: [Lane; SPATIAL_DIM],
    /// Impulses of this substep on the locked axes.
    pub impulses: [Lane; SPATIAL_DIM],
    /// The couple of the angular impulses, in the first frame: in when the step starts, out when it ends.
    pub couple: WideAngVector<Lane>,
    /// Total impulse of all rows on the bodies in this substep.
    pub applied: Wrench<Lane>,
    /// Changes of the angular velocities by it. (The inertias rotate.)
    pub angvel_change: [WideAngVector<Lane>; 2],
    /// Sums over all substeps: the impulse, and its moment about `p`.
    pub total_impulse: WideVector<Lane>,
    pub total_moment: WideAngVector<Lane>,
    /// The moment of this substep, which is part of the sum.
    pub substep_moment: WideAngVector<Lane>,
    /// Range of the block's rows of free axes.
    pub first_row: usize,
    pub row_count: usize,
    /// Whether the joints are solved directly; otherwise iteratively.
    pub is_exact: bool,
    /// Whether any lane is a spring, and whether any locks a rotation.
    pub has_springs: bool,
    pub locks_rotations: bool,
    /// Whether any free axis is a translation.
    pub has_distances: bool,
}

impl JointBlock {
    /// No joint in any lane.
    pub const EMPTY: Self = {
        let (zero, vector) = (Lane::ZERO, WideVector::ZERO);
        Self {
            bodies: [[READ_ONLY; LANES]; 2],
            inv_mass: [vector; 2],
            inertias: JointedInertias::NONE,
            arms: [vector; 2],
            separation: vector,
            frames: [WideRotation::IDENTITY; 2],
            locked: [zero; SPATIAL_DIM],
            bias_rate: zero,
            is_spring: zero,
            compliance: zero,
            is_stiff: zero,
            is_displaced: zero,
            exceeds_limit: zero,
            held_bias: [zero; SPATIAL_DIM],
            impulses: [zero; SPATIAL_DIM],
            couple: ANG_ZERO_LANES,
            applied: Wrench { linear: vector, angular: [ANG_ZERO_LANES; 2] },
            angvel_change: [ANG_ZERO_LANES; 2],
            total_impulse: vector,
            total_moment: ANG_ZERO_LANES,
            substep_moment: ANG_ZERO_LANES,
            first_row: 0,
            row_count: 0,
            is_exact: false,
            has_springs: false,
            locks_rotations: false,
            has_distances: false,
        }
    };

    /// The places of the block's rows of free axes.
    pub fn axis_rows(&self) -> core::ops::Range<usize> {
        self.first_row..self.first_row + self.row_count
    }

    /// A body of the joint in a lane that can move, by its index: if both can, the first one.
    pub fn movable(&self, lane: usize) -> u32 {
        let [first, second] = self.bodies.map(|bodies| bodies[lane]);
        if first & READ_ONLY == 0 { first } else { second & !READ_ONLY }
    }

    /// Scales the impulses of this substep, and their part of the sums over all substeps if that is counted.
    pub fn scale_impulses(&mut self, factors: &Lane, are_counted: bool) {
        if are_counted {
            self.take_off_totals(factors);
        }
        self.impulses.iter_mut().for_each(|impulse| scale(impulse, factors));
        let Wrench { linear, angular } = &mut self.applied;
        for (lane, factor) in factors.0.into_iter().enumerate() {
            linear.set_lane(lane, linear.lane(lane) * factor);
            for value in angular.iter_mut().chain(&mut self.angvel_change) {
                set_ang_lane(value, lane, ang_lane(value, lane) * factor);
            }
        }
    }

    /// Takes the rest of this substep's impulses off the sums, if these fractions are kept.
    fn take_off_totals(&mut self, kept: &Lane) {
        for (lane, kept) in kept.0.into_iter().enumerate() {
            let impulse = self.applied.linear.lane(lane) * (1.0 - kept);
            self.total_impulse.set_lane(lane, self.total_impulse.lane(lane) - impulse);
            let moment = ang_lane(&self.substep_moment, lane) * (1.0 - kept);
            let rest = ang_lane(&self.total_moment, lane) - moment;
            set_ang_lane(&mut self.total_moment, lane, rest);
        }
    }
}

/// One free axis of each lane's joint, with its motor and its limits.
///
/// An axis of translation has a direction in the first frame, or (`coupled`) is the distance within some of
/// the frame's axes. An axis of rotation has an angle.
#[derive(Clone, Debug)]
pub(super) struct AxisRow {
    pub linear: WideVector<Lane>,
    pub coupled: [Lane; DIM],
    pub angle_tracker: AngleTracker,
    /// Joint position along or about the axis, at the last iteration with the bodies' current poses.
    pub position: Lane,
    /// The change of its rate by an impulse of 1, with the reactions of its joint's locked axes: when the
    /// step began, and from then on in each relax pass. (Directly solved joints alone.)
    pub response: Lane,
    pub motor: MotorRow,
    pub min: Lane,
    pub max: Lane,
    /// Impulses of this substep at the lower and at the upper limit: both positive.
    pub lower: Lane,
    pub upper: Lane,
}

/// The motor of an [`AxisRow`].
#[derive(Clone, Debug)]
pub(super) struct MotorRow {
    pub stiffness: Lane,
    pub damping: Lane,
    /// One if these are accelerations, zero if they are forces.
    pub per_mass: Lane,
    pub target_pos: Lane,
    pub target_vel: Lane,
    /// Largest impulse of a substep.
    pub max_impulse: Lane,
    pub impulse: Lane,
    /// Distance of the spring from its target when the substep began.
    pub stretch: Lane,
    /// Rate of the axis when the substep began, before any force.
    pub rate: Lane,
    /// One for joints that are connected with no other one, and drive a single axis.
    pub is_alone: Lane,
    /// The most energy that its spring can give in this substep.
    pub spring_capacity: Lane,
}

impl MotorRow {
    /// The most energy that it can give in this substep. What a damper does not take of `λ v`, with the
    /// target velocity `v`, drives the axis.
    pub fn capacity(&self, lane: usize) -> Real {
        self.spring_capacity.0[lane] + (self.impulse.0[lane] * self.target_vel.0[lane]).abs()
    }
}

impl AxisRow {
    /// No axis in any lane.
    pub const EMPTY: Self = {
        let zero = Lane::ZERO;
        Self {
            linear: WideVector::ZERO,
            coupled: [zero; DIM],
            angle_tracker: AngleTracker::NONE,
            position: zero,
            response: zero,
            motor: MotorRow {
                stiffness: zero,
                damping: zero,
                per_mass: zero,
                target_pos: zero,
                target_vel: zero,
                max_impulse: zero,
                impulse: zero,
                stretch: zero,
                rate: zero,
                is_alone: zero,
                spring_capacity: zero,
            },
            min: Lane::splat(-LIMIT_NONE),
            max: Lane::splat(LIMIT_NONE),
            lower: zero,
            upper: zero,
        }
    };

    /// Scales the impulses with which the next substep starts.
    pub fn scale_impulses(&mut self, factors: &Lane) {
        for impulse in [&mut self.motor.impulse, &mut self.lower, &mut self.upper] {
            scale(impulse, factors);
        }
    }
}

fn scale(lane: &mut Lane, factors: &Lane) {
    lane.0.iter_mut().zip(factors.0).for_each(|(value, factor)| *value *= factor);
}

const _: () = assert!(ANG_DIM + DIM == SPATIAL_DIM);
