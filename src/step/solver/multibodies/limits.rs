//! Limits of joints, motors with a largest force, and dry friction: rows on the degrees of freedom of one
//! joint.
//!
//! ```text
//! limits     C = q - min ≥ 0 and C' = max - q ≥ 0, with the impulses λ ≥ 0 and λ' ≥ 0 along opposite directions
//! motor      λ = h (k (target - q - h q̇) + d (target velocity - q̇)),  |λ| ≤ h max_force
//! friction   q̇ = 0,  |λ| ≤ h friction
//! ```
//!
//! The motor's equation, solved for the velocity, is `q̇ - v + γ λ = 0`, with `v = (k (target - q) + d target
//! velocity)/(h k + d)` and `γ = 1/(h (h k + d))`. Motors without a largest force are no rows: see `load.rs`.
//! All rows of a multibody are solved together, with its gears: see `system.rs`.
//!
//! `q` is a coordinate. For a ball joint it is an angle as in `dim3/joint/mod.rs`, and the row is its
//! gradient. The row rotates with the ball, and a body that moves on a cone would leave it along a tangent.
//! Rows of angles within [`LIMIT_DISTANCE_MAX`] of a limit are therefore built in each substep. They include
//! the curvature, as rows of impulse joints do (`joints/substep_end.rs`).

use super::Moving;
use super::force_rows::ForceRow;
use super::rows::{ConstrainedStates, JacobianPool, Part, Row};
use super::system::{RowSystem, SystemRow};
use crate::dim::joint::{FreeRotations, angle_about};
use crate::dim::joint_axes::JointAxis;
use crate::dim::math::{ANG_DIM, DIM, Real, SpatialVector};
use crate::dim::spatial::{ang_components, angular, linear};
use crate::model::frozen::Frozen;
use crate::model::joint::{
    GenericJoint, ImpulseJointHandle, ImpulseJointSet, JointLimits, JointMotor, mask_of,
};
use crate::model::multibody::{MultibodyJoint, MultibodyLink};
use crate::model::params::JointPass;
use crate::step::solver::axis_law::AxisLaw;
use crate::step::solver::joint_rules::{CURVATURE_FRACTION_MAX, EXACT_LIMIT_ERROR_FRACTION};

/// Owner of the axis of a row: the joint of a link, or a joint that closes a loop.
#[derive(Copy, Clone, Debug)]
pub enum Owner {
    Link {
        multibody: usize,
        link: usize,
    },
    /// A joint that closes a loop, its position among these, and a multibody with whose rows it is solved.
    Loop {
        joint: ImpulseJointHandle,
        position: usize,
        solved_with: Option<usize>,
        /// Wrench of a unit impulse on the second body, at its anchor, in world space.
        wrench: SpatialVector,
    },
}

/// Distance (rad) from which a limit of a ball's angle is updated in each substep. Joints that must stay
/// within half a degree rotate by less in a substep.
const LIMIT_DISTANCE_MAX: Real = 0.25;

/// Both limits of an axis. They have a common row: one pushes along it, the other against it.
#[derive(Copy, Clone, Debug)]
struct Limit {
    owner: Owner,
    axis: JointAxis,
    row: Row,
    /// Distances of the coordinate from the lower and from the upper limit.
    distances: [Real; 2],
    impulses: [Real; 2],
    /// Sum of the impulses of the substeps, those of the upper end negative.
    total: Real,
    /// Whether it belongs to a ball joint near its limit. Then its row is made anew in each substep.
    is_followed: bool,
}

/// All rows on single joints.
#[derive(Debug, Default)]
pub struct JointRows {
    limits: Vec<Limit>,
    force_rows: Vec<ForceRow>,
}

impl JointRows {
    /// Makes the rows of all joints, for substeps of `h` seconds.
    pub fn prepare(&mut self, jacobians: &mut JacobianPool, multibodies: &mut [Moving], h: Real) {
        self.limits.clear();
        self.force_rows.clear();
        for multibody in 0..multibodies.len() {
            for link in 1..multibodies[multibody].multibody.links.len() {
                let link = multibodies[multibody].multibody.links[link].clone();
                if !link.joint.kinematic {
                    self.add_joint(jacobians, multibodies, multibody, &link, h);
                }
            }
        }
    }

    fn add_joint(
        &mut self,
        jacobians: &mut JacobianPool,
        multibodies: &mut [Moving],
        multibody: usize,
        link: &MultibodyLink,
        h: Real,
    ) {
        let data = &link.joint.data;
        let axes = JointAxis::ALL.into_iter().filter(|axis| link.free.contains(mask_of(*axis)));
        for (dof, axis) in link.dofs().zip(axes) {
            let owner = Owner::Link { multibody, link: link.id };
            if let Some(limits) = data.limits(axis)
                && let Some((q, gradient)) = limited_angle(&link.joint, axis)
            {
                let row = row_of(jacobians, multibodies, multibody, link, &gradient);
                self.add_limits(owner, axis, row, q, limits);
                if let Some(limit) = self.limits.last_mut().filter(|_| is_curved(&link.joint, axis))
                {
                    limit.is_followed = limit.is_near();
                }
            }
            let unit = unit(axis);
            if let Some(motor) = data.motor(axis).filter(|motor| motor.max_force < Real::MAX) {
                let row = row_of(jacobians, multibodies, multibody, link, &unit);
                self.add_motor(owner, axis, row, link.joint.coordinate(axis), motor, h);
            }
            let lists = &multibodies[multibody].multibody.lists;
            let (friction, impulse) = (lists.frictions[dof], lists.friction_impulses[dof]);
            if friction > 0.0 && friction.is_finite() {
                let row = row_of(jacobians, multibodies, multibody, link, &unit);
                self.force_rows.push(ForceRow::friction(owner, axis, row, friction * h, impulse));
            }
        }
    }

    /// Adds the limits of an axis whose coordinate is `q`.
    pub fn add_limits(
        &mut self,
        owner: Owner,
        axis: JointAxis,
        row: Row,
        q: Real,
        limits: &JointLimits,
    ) {
        let distances = [q - limits.min, limits.max - q];
        let impulses = [limits.impulse.max(0.0), (-limits.impulse).max(0.0)];
        self.limits.push(Limit {
            owner,
            axis,
            row,
            distances,
            impulses,
            total: 0.0,
            is_followed: false,
        });
    }

    /// Adds the motor of an axis whose coordinate is `q`, for substeps of `h` seconds.
    pub fn add_motor(
        &mut self,
        owner: Owner,
        axis: JointAxis,
        row: Row,
        q: Real,
        motor: &JointMotor,
        h: Real,
    ) {
        self.force_rows.push(ForceRow::motor(owner, axis, row, q, motor, h));
    }

    /// Makes the rows of balls near their limits anew, where the links are now.
    pub fn follow_balls(
        &mut self,
        jacobians: &mut JacobianPool,
        states: &mut ConstrainedStates<'_>,
    ) {
        for limit in &mut self.limits {
            let Owner::Link { multibody, link } = limit.owner else { continue };
            let link = &states.multibodies[multibody].multibody.links[link];
            if !is_curved(&link.joint, limit.axis) {
                continue;
            }
            let Some((q, gradient)) = limited_angle(&link.joint, limit.axis) else { continue };
            let Some(limits) = link.joint.data.limits(limit.axis) else { continue };
            limit.distances = [q - limits.min, limits.max - q];
            limit.is_followed = limit.is_near();
            if limit.is_followed {
                let link = link.clone();
                jacobians.push_early(&limit.row, -limit.impulse(), states);
                limit.row.rewrite(jacobians, |jacobians| {
                    row_of(jacobians, states.multibodies, multibody, &link, &gradient)
                });
                jacobians.push_early(&limit.row, limit.impulse(), states);
            }
            // The row's past displacement is reset.
            let moved = jacobians.displacement(&limit.row, states);
            limit.distances = [limit.distances[0] - moved, limit.distances[1] + moved];
        }
    }

    /// Starts the step with the last one's impulses.
    pub fn warm_start(&self, jacobians: &JacobianPool, states: &mut ConstrainedStates<'_>) {
        for limit in &self.limits {
            jacobians.push_early(&limit.row, limit.impulse(), states);
        }
        for force_row in &self.force_rows {
            jacobians.push_early(&force_row.row, force_row.impulse, states);
        }
    }

    /// Scales the impulses with which the next substep starts, by a factor for each row.
    pub fn scale_impulses(&mut self, factor: impl Fn(&Row) -> Real) {
        for limit in &mut self.limits {
            limit.impulses = limit.impulses.map(|impulse| impulse * factor(&limit.row));
        }
        self.force_rows
            .iter_mut()
            .for_each(|force_row| force_row.impulse *= factor(&force_row.row));
    }

    /// Adds the laws of all rows to a system; with `bias`, position errors are corrected.
    pub fn add_to(
        &self,
        system: &mut RowSystem,
        jacobians: &JacobianPool,
        states: &ConstrainedStates<'_>,
        pass: &JointPass,
        bias: bool,
    ) {
        for limit in &self.limits {
            let law = limit.law(jacobians, states, pass, bias);
            let [lower, upper] = limit.impulses;
            let group = limit.owner.group(system);
            system.rows.push(SystemRow::new(group, limit.row, law, [0.0, lower, upper]));
        }
        for force_row in &self.force_rows {
            let (row, impulses) = (force_row.row, [force_row.impulse, 0.0, 0.0]);
            let law = force_row.law(jacobians, states);
            let group = force_row.owner.group(system);
            system.rows.push(SystemRow::new(group, row, law, impulses));
        }
    }

    /// Takes the impulses of the rows, in the order of [`Self::add_to`].
    pub fn take_from<'a>(&mut self, solved: &mut impl Iterator<Item = &'a SystemRow>) {
        for (limit, solved) in self.limits.iter_mut().zip(&mut *solved) {
            let [_, lower, upper] = solved.parts();
            debug_assert!(![lower, upper].iter().any(|&impulse| impulse < 0.0), "limits push");
            limit.impulses = [lower, upper];
        }
        for (force_row, solved) in self.force_rows.iter_mut().zip(&mut *solved) {
            [force_row.impulse, ..] = solved.parts();
        }
    }

    /// The rows that may do work on multibodies, and their impulses of this substep: those of motors, and
    /// limits of joints to other bodies.
    pub fn working_rows(&self) -> impl Iterator<Item = (&Row, Real)> {
        let joins_bodies = |limit: &&Limit| matches!(limit.owner, Owner::Loop { .. });
        let limits = self.limits.iter().filter(joins_bodies);
        let limits = limits.map(|limit| (&limit.row, limit.impulse()));
        let motors = self.force_rows.iter().filter(|force_row| !force_row.is_friction);
        limits.chain(motors.map(|motor| (&motor.row, motor.impulse)))
    }

    /// Counts the impulses of the substep into those of the step.
    pub fn count(&mut self) {
        self.limits.iter_mut().for_each(|limit| limit.total += limit.impulse());
        self.force_rows.iter_mut().for_each(|force_row| force_row.total += force_row.impulse);
    }

    /// Adds the mean forces of limits and motors to those of joints that close loops.
    pub fn add_forces(&self, joints: &mut Frozen<'_, ImpulseJointSet>, inv_dt: Real) {
        let limits = self.limits.iter().map(|limit| (limit.owner, limit.total));
        let force_rows = self.force_rows.iter().map(|force_row| (force_row.owner, force_row.total));
        for (owner, total) in limits.chain(force_rows) {
            let Owner::Loop { joint, wrench, .. } = owner else { continue };
            let Some(joint) = joints.get_unnoted_mut(joint) else { continue };
            joint.force += linear(&wrench) * (total * inv_dt);
            joint.torque += angular(&wrench) * (total * inv_dt);
        }
    }

    /// Writes the impulses to the joints.
    pub fn store(&self, multibodies: &mut [Moving], joints: &mut Frozen<'_, ImpulseJointSet>) {
        for limit in &self.limits {
            if let Some(data) = limit.owner.data(multibodies, joints) {
                data.limits[limit.axis as usize].impulse = finite(limit.impulse());
            }
        }
        for ForceRow { owner, axis, is_friction, impulse, .. } in &self.force_rows {
            let impulse = finite(*impulse);
            match *owner {
                Owner::Link { multibody, link } if *is_friction => {
                    let target = &mut multibodies[multibody].multibody;
                    let link = &target.links[link];
                    let dof = link.first_dof + position(link, *axis);
                    target.lists.friction_impulses[dof] = impulse;
                }
                owner => {
                    if let Some(data) = owner.data(multibodies, joints) {
                        data.motors[*axis as usize].impulse = impulse;
                    }
                }
            }
        }
    }
}

impl Owner {
    /// The group of rows that are solved together.
    fn group(&self, system: &RowSystem) -> usize {
        match self {
            Self::Link { multibody, .. } => system.group(*multibody),
            Self::Loop { position, solved_with, .. } => {
                system.group_of_loop(*position, *solved_with)
            }
        }
    }

    /// The joint.
    fn data<'a>(
        self,
        multibodies: &'a mut [Moving],
        joints: &'a mut Frozen<'_, ImpulseJointSet>,
    ) -> Option<&'a mut GenericJoint> {
        match self {
            Self::Link { multibody, link } => {
                Some(&mut multibodies[multibody].multibody.links[link].joint.data)
            }
            Self::Loop { joint, .. } => Some(&mut joints.get_unnoted_mut(joint)?.data),
        }
    }
}

impl Limit {
    /// Along the row.
    fn impulse(&self) -> Real {
        self.impulses[0] - self.impulses[1]
    }

    /// The rates that the limits allow.
    fn law(
        &self,
        jacobians: &JacobianPool,
        states: &ConstrainedStates<'_>,
        pass: &JointPass,
        bias: bool,
    ) -> AxisLaw {
        if self.row.mass == 0.0 {
            return AxisLaw::FREE;
        }
        let moved = jacobians.displacement(&self.row, states);
        let curvature = if bias { self.curvature(states, pass.inv_substep) } else { 0.0 };
        let is_locked = self.distances[0] + self.distances[1] <= 0.0;
        let fraction = if bias { EXACT_LIMIT_ERROR_FRACTION } else { 0.0 };
        let correction = fraction * pass.inv_substep;
        let [below, above] =
            [self.distances[0] + moved, self.distances[1] - moved].map(|distance| {
                let is_apart = distance > 0.0 && !is_locked;
                f64::from(distance * if is_apart { pass.inv_substep } else { correction })
            });
        let curvature = f64::from(curvature);
        AxisLaw { low: -below - curvature, high: above - curvature, ..AxisLaw::FREE }
    }

    /// Returns whether the angle is near one of its limits, or a limit has an impulse.
    fn is_near(&self) -> bool {
        self.impulses != [0.0; 2] || self.distances[0].min(self.distances[1]) < LIMIT_DISTANCE_MAX
    }

    /// The curvature term of a ball joint's angle over the substep.
    fn curvature(&self, states: &ConstrainedStates<'_>, inv_substep: Real) -> Real {
        let Owner::Link { multibody, link } = self.owner else { return 0.0 };
        if !self.is_followed || inv_substep <= 0.0 {
            return 0.0;
        }
        let moving = &states.multibodies[multibody];
        let link = &moving.multibody.links[link];
        let rates = &moving.motion.rates[link.dofs()];
        let mut then = link.joint.clone();
        then.integrate(1.0 / inv_substep, rates);
        let angles = [&link.joint, &then].map(|joint| limited_angle(joint, self.axis));
        let [Some((now, gradient)), Some((then, _))] = angles else { return 0.0 };
        let turn = &rates[rates.len() - ANG_DIM..];
        let straight = (0..ANG_DIM).map(|k| gradient[DIM + k] * turn[k]).sum::<Real>();
        let bound =
            CURVATURE_FRACTION_MAX * turn.iter().map(|rate| rate * rate).sum::<Real>().sqrt();
        let curvature = (then - now) * inv_substep - straight;
        curvature.min(bound).max(-bound)
    }
}

/// The angle or length of an axis's limits, and its derivatives by each axis of the joint; `None` if another
/// axis represents it.
fn limited_angle(
    joint: &MultibodyJoint,
    axis: JointAxis,
) -> Option<(Real, [Real; JointAxis::ALL.len()])> {
    if (axis as usize) < DIM || !joint.is_ball() {
        return Some((joint.coordinate(axis), unit(axis)));
    }
    if !joint.data.driven_axes().any(|own| own == axis) {
        return None;
    }
    let rotations = FreeRotations::new(joint.free_axes(), joint.data.coupled_axes);
    let (angle, gradient) = angle_about(axis, rotations, &joint.joint_rot());
    let mut all = [0.0; JointAxis::ALL.len()];
    all[DIM..].copy_from_slice(&ang_components(gradient));
    Some((angle, all))
}

/// Returns whether the row of an axis rotates with the link.
fn is_curved(joint: &MultibodyJoint, axis: JointAxis) -> bool {
    joint.is_ball() && axis as usize >= DIM
}

fn unit(axis: JointAxis) -> [Real; JointAxis::ALL.len()] {
    let mut all = [0.0; JointAxis::ALL.len()];
    all[axis as usize] = 1.0;
    all
}

/// The degree of freedom of an axis of a link.
fn position(link: &MultibodyLink, axis: JointAxis) -> usize {
    (link.free.bits() & (mask_of(axis).bits() - 1)).count_ones() as usize
}

/// A row on the degrees of freedom of a link, given a number per axis.
fn row_of(
    jacobians: &mut JacobianPool,
    multibodies: &mut [Moving],
    multibody: usize,
    link: &MultibodyLink,
    by_axis: &[Real; JointAxis::ALL.len()],
) -> Row {
    let part = jacobians.add_links(multibodies, multibody, true, |_, jacobian, _| {
        let axes = JointAxis::ALL.into_iter().filter(|axis| link.free.contains(mask_of(*axis)));
        for (dof, axis) in link.dofs().zip(axes) {
            jacobian[dof] = by_axis[axis as usize];
        }
    });
    jacobians.row([part, Part::Nothing])
}

fn finite(impulse: Real) -> Real {
    if impulse.is_finite() { impulse } else { 0.0 }
}
