//! Inverse kinematics by damped least squares: coordinates that bring a link to a pose.
//!
//! To first order a displacement `Δq` moves the link by `J Δq`. The method selects the smallest of all steps
//! that reduce the error `e`. The step is bounded even if the link cannot reach the target. (Buss,
//! "Introduction to Inverse Kinematics with Jacobian Transpose, Pseudoinverse and Damped Least Squares
//! methods", 2004.)
//!
//! ```text
//! Δq = Jᵀ (J Jᵀ + λ² 1)⁻¹ e        minimises  |J Δq - e|² + λ² |Δq|²
//! ```

use super::kinematics::Kinematics;
use super::spatial::{ZERO, carry, dot};
use crate::base::square::SquareMatrix;
use crate::dim::joint_axes::JointAxesMask;
use crate::dim::math::{
    DIM, Pose, Real, SPATIAL_DIM, SpatialVector, ang_length_squared, rotation_to_angle,
};
use crate::dim::spatial::{angular, join, linear};
use crate::model::body::RigidBodySet;
use crate::model::check::checked_pose;
use crate::model::multibody::{Multibody, MultibodyLink};

/// The largest rotation angle (rad) of a joint in one step of the search. The Jacobian is inaccurate beyond
/// it, and a target out of reach leads to larger angles in each step.
const STEP_ANGLE_MAX: Real = 0.3;

/// Search parameters and tolerances of [`Multibody::inverse_kinematics`].
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct InverseKinematicsOption {
    /// The damping `λ` (default 1). Large values make small, stable steps. Small values converge in fewer
    /// steps, but oscillate near unreachable targets.
    pub damping: Real,
    /// Largest number of steps of the search (default 10).
    pub max_iters: usize,
    /// World axes along and about which the link must reach the target (default: all).
    pub constrained_axes: JointAxesMask,
    /// Distance from the target at which the search has converged (length units, default 0.001).
    pub epsilon_linear: Real,
    /// Angle from the target at which the search has converged (radians, default 0.001).
    pub epsilon_angular: Real,
}

impl Default for InverseKinematicsOption {
    fn default() -> Self {
        Self {
            damping: 1.0,
            max_iters: 10,
            constrained_axes: JointAxesMask::all(),
            epsilon_linear: 1.0e-3,
            epsilon_angular: 1.0e-3,
        }
    }
}

impl Multibody {
    /// Searches displacements of the degrees of freedom that move a link's body to a pose in world space.
    ///
    /// The search starts at `displacements` (missing ones are 0) and writes the result back to them. It moves
    /// nothing: call [`Self::apply_displacements`]. Only links for which `joint_can_move` returns `true` are
    /// used, and coordinates stay within the limits of their joints. For an unreachable target, the result is
    /// the closest pose of the search. The call has no effect if the link or a body is missing, or if the
    /// target is not a valid pose.
    pub fn inverse_kinematics(
        &self,
        bodies: &RigidBodySet,
        link_id: usize,
        options: &InverseKinematicsOption,
        target_pose: &Pose,
        joint_can_move: impl Fn(&MultibodyLink) -> bool,
        displacements: &mut Vec<Real>,
    ) {
        let is_link = link_id < self.links.len() && self.is_whole();
        let Some(target) = checked_pose(*target_pose).filter(|_| is_link) else { return };
        let mut start = self.clone();
        start.forward_kinematics(bodies, false);
        let mut posed = start.clone();
        posed.apply_displacements(displacements);
        let movable: Vec<_> =
            start.dofs.iter().map(|dof| joint_can_move(&start.links[dof.link])).collect();
        let mut step = vec![0.0; start.ndofs()];
        for _ in 0..options.max_iters {
            let error = error_to(&target, &posed.links[link_id].pose, options.constrained_axes);
            if linear(&error).length() <= options.epsilon_linear
                && ang_length_squared(angular(&error)).sqrt() <= options.epsilon_angular
            {
                break;
            }
            let mut jacobian = posed.jacobian_at_origin(link_id);
            for (column, movable) in jacobian.iter_mut().zip(&movable) {
                mask(column, options.constrained_axes, *movable);
            }
            step.fill(0.0);
            Self::inverse_kinematics_delta_with_jacobian(
                &jacobian,
                &error,
                options.damping,
                &mut step,
            );
            start.shorten(&mut step);
            posed.apply_displacements(&step);
            posed.keep_limits();
        }
        *displacements = start.displacements_to(&posed);
    }

    /// Limits the rotation of each joint in a step to [`STEP_ANGLE_MAX`].
    fn shorten(&self, step: &mut [Real]) {
        let turns = self.dofs.iter().zip(step.iter()).filter(|(dof, _)| dof.axis as usize >= DIM);
        let largest = turns.map(|(_, turn)| turn.abs()).fold(0.0, Real::max);
        if largest > STEP_ANGLE_MAX {
            step.iter_mut().for_each(|number| *number *= STEP_ANGLE_MAX / largest);
        }
    }

    /// Adds to `displacements` (one per degree of freedom) a damped least-squares step that moves a link's
    /// body by `desired_movement`. The movement contains the translation of its origin (length units) and its
    /// rotation vector (rad), in world space. A missing link has no effect.
    pub fn inverse_kinematics_delta(
        &self,
        link_id: usize,
        desired_movement: &SpatialVector,
        damping: Real,
        displacements: &mut [Real],
    ) {
        if link_id < self.links.len() && self.is_whole() {
            let jacobian = self.jacobian_at_origin(link_id);
            Self::inverse_kinematics_delta_with_jacobian(
                &jacobian,
                desired_movement,
                damping,
                displacements,
            );
        }
    }

    /// The same with any Jacobian: by degree of freedom, the velocity of the moved point or frame.
    pub fn inverse_kinematics_delta_with_jacobian(
        jacobian: &[SpatialVector],
        desired_movement: &SpatialVector,
        damping: Real,
        displacements: &mut [Real],
    ) {
        let mut square = SquareMatrix::zeros(SPATIAL_DIM);
        for row in 0..SPATIAL_DIM {
            for column in 0..SPATIAL_DIM {
                square[(row, column)] = jacobian.iter().map(|j| j[row] * j[column]).sum();
            }
            square[(row, row)] += damping * damping;
        }
        let mut push = ZERO;
        push.copy_from_slice(&square.solve_symmetric(desired_movement));
        for (displacement, column) in displacements.iter_mut().zip(jacobian) {
            *displacement += dot(column, &push);
        }
    }

    /// The Jacobian of a link at the origin of its body.
    fn jacobian_at_origin(&self, link_id: usize) -> Vec<SpatialVector> {
        let link = &self.links[link_id];
        let from_center = -(link.pose.rotation * link.mass.local_com);
        let columns = Kinematics::of(self).jacobian(link_id);
        columns.iter().map(|column| carry(column, from_center)).collect()
    }

    /// Brings coordinates that are beyond the limits of their joints back.
    fn keep_limits(&mut self) {
        self.links.iter_mut().skip(1).for_each(|link| link.joint.keep_limits());
        self.place_links();
    }

    /// The displacements that lead from this configuration to another configuration.
    fn displacements_to(&self, other: &Self) -> Vec<Real> {
        self.dofs
            .iter()
            .map(|dof| {
                let [from, to] = [self, other].map(|multibody| &multibody.links[dof.link]);
                if from.parent.is_some() {
                    return from.joint.displacement_to(&to.joint, dof.axis);
                }
                let rotation = to.pose.rotation * from.pose.rotation.inverse();
                let shift = to.pose * to.mass.local_com - from.pose * from.mass.local_com;
                join(shift, rotation_to_angle(&rotation))[dof.axis as usize]
            })
            .collect()
    }
}

/// The difference of a pose from the target, along and about some axes of the world.
fn error_to(target: &Pose, pose: &Pose, axes: JointAxesMask) -> SpatialVector {
    let rotation = target.rotation * pose.rotation.inverse();
    let mut error = join(target.translation - pose.translation, rotation_to_angle(&rotation));
    mask(&mut error, axes, true);
    error
}

/// Clears the components of other axes, or all components.
fn mask(vector: &mut SpatialVector, axes: JointAxesMask, any: bool) {
    for (axis, number) in vector.iter_mut().enumerate() {
        if !any || axes.bits() & (1 << axis) == 0 {
            *number = 0.0;
        }
    }
}
