//! From the solver's states back to the bodies: once per step, on several threads.

use super::SolverBodies;
use crate::base::disjoint::DisjointMut;
use crate::collide::turned;
use crate::dim::math::{ANG_ZERO, AngVector, Pose, Real, Vector};
use crate::dim::motion::FreeMotion;
use crate::dim::state::BodyState;
use crate::model::body::{RigidBody, RigidBodyType, RigidBodyVelocity};
use crate::model::check::checked_pose;
use crate::model::island::BodyMotion;
use crate::step::notes::{FastMotion, MotionPart};
use crate::step::solver::context::MotionOutput;
use crate::step::solver::groups::Groups;
use crate::step::solver::links::Links;

impl SolverBodies {
    /// Writes velocities and poses back to the bodies. Stores the displacement bound of each body, and the
    /// motions of fast ones.
    pub fn store(&mut self, groups: &Groups, links: &Links, output: &mut MotionOutput<'_>) {
        let MotionOutput { settings, bodies, motions: moved, fast, .. } = output;
        let (params, order) = (settings.params, groups.order());
        debug_assert!(order.len() < self.states.len() && bodies.slot_count() <= moved.len());
        let moved = DisjointMut::new(moved);
        let (states, motions, energy_errors) = (&self.states, &self.motions, &self.energy_errors);
        let store = |position: usize, body: Option<&mut RigidBody>, fast: &mut Vec<_>| {
            let slot = order[position].into_raw_parts().0;
            let Some(body) = body.filter(|_| !links.moves(slot)) else { return };
            let (state, motion) = (&states[position + 1], &motions[position + 1]);
            body.energy_error = energy_errors[position + 1];
            let displacement = match body.body_type {
                RigidBodyType::KinematicPositionBased => move_to(body, body.next_pose, params.dt),
                _ => {
                    let (start, center) = (body.pose, body.mprops.world_com);
                    let (shift, rotvec) = commit(body, state, motion);
                    let displacement =
                        BodyMotion::of(body.mprops.world_com - center, rotvec, body.extent);
                    // Not less than that of the displacement: see `commit`.
                    let bound = shift.length() + displacement.rest;
                    body.ccd_active = body.is_dynamic() && FastMotion::is_fast(body, bound, params);
                    if body.ccd_active {
                        let (body, acceleration) = (order[position], motion.linear_acceleration());
                        let link = None;
                        fast.push(FastMotion {
                            body,
                            start,
                            center,
                            shift,
                            rotvec,
                            acceleration,
                            link,
                            part: MotionPart::Whole,
                        });
                        // CCD may stop it.
                        BodyMotion::within(bound)
                    } else {
                        displacement
                    }
                }
            };
            // SAFETY: every slot of a body has a motion, and it is this body's.
            unsafe { *moved.get_mut(slot as usize) = displacement };
        };
        // SAFETY: the order names each body once.
        unsafe { bodies.visit_gathering(order, settings.tasks, &mut self.fast, store, fast) };
    }
}

/// The solver's pose and velocity of a body, if they are usable.
pub(super) fn outcome(
    body: &RigidBody,
    state: &BodyState,
    motion: &FreeMotion,
) -> Option<(Pose, RigidBodyVelocity)> {
    let (linvel, angvel) = state.velocity();
    let (shift, rotvec) = state.displacement();
    let rotation = motion.rotation();
    let rotation =
        if motion.is_gyroscopic() { rotation.normalize() } else { turned(rotation, rotvec) };
    let center = body.mprops.world_com;
    let local_center = body.mprops.local_mprops.local_com;
    let pose = Pose::from_parts(center + shift - rotation * local_center, rotation);
    let velocity = RigidBodyVelocity::new(linvel, angvel);
    // Neither an infinite turn nor one whose square is infinite leaves a rotation of unit length.
    checked_pose(pose).filter(|_| velocity.is_usable()).map(|pose| (pose, velocity))
}

/// Gives a body the pose and velocity that the solver found. Returns the displacement of
/// its centre and its rotation vector.
fn commit(body: &mut RigidBody, state: &BodyState, motion: &FreeMotion) -> (Vector, AngVector) {
    body.use_up_push();
    let Some((pose, velocity)) = outcome(body, state, motion) else {
        // The divergence check finds fast and far bodies. The remaining case is a rotation about a very
        // distant centre of mass.
        log::error!("a rigid body left the range of numbers at {:?} and was stopped", body.pose);
        (body.vels.linvel, body.vels.angvel) = (Vector::ZERO, ANG_ZERO);
        return (Vector::ZERO, ANG_ZERO);
    };
    let (center, (shift, rotvec)) = (body.mprops.world_com, state.displacement());
    (body.vels.linvel, body.vels.angvel) = (velocity.linvel, velocity.angvel);
    body.pose = pose;
    body.update_world_mass_properties();
    // Far from the origin a position has few digits, and it moves by whole steps of these or not at all.
    let rounded = body.mprops.world_com - center;
    let shift = if rounded.length_squared() > shift.length_squared() { rounded } else { shift };
    (shift, rotvec)
}

/// Moves a position-based kinematic body to its target pose.
fn move_to(body: &mut RigidBody, pose: Pose, dt: Real) -> BodyMotion {
    let old_center = body.mprops.world_com;
    body.pose = pose;
    body.update_world_mass_properties();
    BodyMotion::of(body.mprops.world_com - old_center, body.vels.angvel * dt, body.extent)
}
