//! From the solver's states back to the bodies: once per step, on several threads.

use super::motion::Motion;
use super::{BODIES_PER_TASK, SolverBodies, TURNS_AHEAD};
use crate::base::disjoint::DisjointMut;
use crate::base::tasks::Tasks;
use crate::dim::math::{ANG_ZERO, Pose, Real, Vector, ang_length_squared, integrate_rotation};
use crate::dim::state::BodyState;
use crate::model::body::{RigidBody, RigidBodySet, RigidBodyType, RigidBodyVelocity};
use crate::model::check::checked_pose;
use crate::model::island::IslandManager;
use crate::model::params::IntegrationParameters;
use crate::step::solver::groups::Groups;
use crate::step::solver::multibodies::SolverMultibodies;

impl SolverBodies {
    /// Writes velocities and poses back to the bodies, and notes how far each one moved.
    pub fn store(
        &self,
        groups: &Groups,
        islands: &mut IslandManager,
        bodies: &mut RigidBodySet,
        multibodies: &SolverMultibodies,
        params: &IntegrationParameters,
        tasks: Tasks<'_>,
    ) {
        let order = groups.order();
        let bounds = DisjointMut::new(islands.motions_mut(bodies.slot_count()));
        let bodies = bodies.share();
        tasks.par_for(order.len(), BODIES_PER_TASK, |range| {
            for position in range {
                if let Some(later) = order.get(position + TURNS_AHEAD) {
                    bodies.prefetch(later.into_raw_parts().0);
                }
                let handle = order[position];
                let slot = handle.into_raw_parts().0;
                // SAFETY: the order names each body once.
                let Some(body) = (unsafe { bodies.get_mut(handle.0) }) else { continue };
                if multibodies.moves(slot) {
                    continue;
                }
                let (state, motion) = (&self.states[position + 1], &self.motions[position + 1]);
                let bound = match body.body_type {
                    RigidBodyType::KinematicPositionBased => {
                        move_to(body, body.next_pose, params.dt)
                    }
                    _ => commit(body, state, motion),
                };
                // SAFETY: every slot of a body has a bound, and it is this body's.
                unsafe { *bounds.get_mut(slot as usize) = bound };
            }
        });
    }
}

/// Gives a body the pose and velocity that the solver found. Returns a bound of how far any point of
/// it moved.
///
/// A body whose numbers overflowed stays where it was and comes to rest: one lost body is better than
/// a world of NaN.
fn commit(body: &mut RigidBody, state: &BodyState, motion: &Motion) -> Real {
    let (linvel, angvel) = state.velocity();
    let (shift, turn) = state.displacement();
    let rotation = match motion.gyroscope {
        Some(_) => motion.rotation.normalize(),
        None => integrate_rotation(motion.rotation, turn),
    };
    let center = body.mprops.world_com + shift;
    let pose = Pose::from_parts(center - rotation * body.mprops.local.local_com, rotation);
    let velocity = RigidBodyVelocity::new(linvel, angvel);
    // Neither an infinite turn nor one whose square is infinite leaves a rotation of unit length.
    let Some(pose) = checked_pose(pose).filter(|_| velocity.is_usable()) else {
        log::error!("a rigid body left the range of numbers at {:?} and was stopped", body.pose);
        (body.linvel, body.angvel) = (Vector::ZERO, ANG_ZERO);
        return 0.0;
    };
    (body.linvel, body.angvel) = (linvel, angvel);
    body.pose = pose;
    let old_center = body.mprops.world_com;
    body.update_world_mass_properties();
    // Far from the origin a position has few digits, and it moves by whole steps of these or not at all.
    let rounded = body.mprops.world_com - old_center;
    let shift = if rounded.length_squared() > shift.length_squared() { rounded } else { shift };
    motion_bound(shift, ang_length_squared(turn), body.extent)
}

/// Puts a position-based kinematic body where the user wants it.
fn move_to(body: &mut RigidBody, pose: Pose, dt: Real) -> Real {
    let old_center = body.mprops.world_com;
    body.pose = pose;
    body.update_world_mass_properties();
    let turn = body.angvel * dt;
    motion_bound(body.mprops.world_com - old_center, ang_length_squared(turn), body.extent)
}

/// The centre moved by `shift`; a point at the distance `extent` from it moved by no more than the
/// angle times that distance besides.
fn motion_bound(shift: Vector, turn_squared: Real, extent: Real) -> Real {
    shift.length() + if turn_squared > 0.0 { turn_squared.sqrt() * extent } else { 0.0 }
}
