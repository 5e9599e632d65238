//! Steps that end at an impact.
//!
//! A stopped body loses the rest of its step. With `max_ccd_substeps = n`, the first impact of a fast body
//! ends the step instead, at most `n - 1` times, and a shorter step solves the contact and takes the time
//! that is left. The impact is predicted before the solver runs, from the velocities:
//!
//! ```text
//! Δx = (v + a dt / 2) dt        θ = ω dt
//! ```
//!
//! The prediction needs no accuracy: a body that arrives earlier is stopped as in any other step, and a body
//! that arrives later has its contact in the next part. It excludes links of multibodies, and it regards
//! kinematic bodies as being at rest.
//!
//! A body that touches the collider already hits it in this step, and leaves with a velocity that is not
//! known before the solver runs. The part then takes `min_ccd_dt`.
//!
//! Rejected alternative: the solver runs first, and all bodies return to the time of the first impact. Bodies
//! in free fall would keep the velocity of the whole step, and each impact would add energy to the world.

use super::approach::KinematicMotion;
use super::{CcdContext, CcdScratch, Search, find_first_stops};
use crate::base::tasks::Tasks;
use crate::collide::Sweep;
use crate::dim::math::{Pose, Real, Vector};
use crate::model::body::{RigidBody, RigidBodyHandle, RigidBodySet, RigidBodyType};
use crate::model::frozen::Frozen;
use crate::model::island::{BodyMotion, IslandManager};
use crate::model::params::IntegrationParameters;
use crate::step::notes::{FastMotion, MotionPart};

/// The time until the first impact of a fast body, if the impact divides the step.
pub(crate) fn first_impact_time(
    tasks: Tasks<'_>,
    context: CcdContext<'_>,
    gravity: Vector,
    scratch: &mut CcdScratch,
) -> Option<Real> {
    let &IntegrationParameters { dt, min_ccd_dt, .. } = context.params;
    let mut predicted = core::mem::take(&mut scratch.predicted);
    predicted.clear();
    let awake = context.islands.awake.dynamic().iter();
    predicted.extend(awake.filter_map(|&handle| predict(context, handle, gravity)));
    let fraction = first_fraction(tasks, CcdContext { fast: &predicted, ..context }, scratch);
    scratch.predicted = predicted;
    let time = (fraction? * dt).max(min_ccd_dt);
    (time > 0.0 && dt - time >= min_ccd_dt && time < dt).then_some(time)
}

/// The fraction of the step until the first stop.
fn first_fraction(
    tasks: Tasks<'_>,
    context: CcdContext<'_>,
    scratch: &mut CcdScratch,
) -> Option<Real> {
    if context.fast.is_empty() {
        return None;
    }
    scratch.clear();
    find_first_stops(tasks, context, scratch);
    let CcdScratch {
        movers,
        first,
        toi_fractions,
        link_trajectories,
        groups,
        bullets,
        searched,
        ..
    } = scratch;
    let search = Search { context, movers, link_trajectories, groups, searched };
    toi_fractions.extend(first.iter().map(|stop| stop.fraction));
    bullets.find(search, toi_fractions);
    let first = toi_fractions.iter().copied().fold(1.0, Real::min);
    (first < 1.0).then_some(first)
}

/// The motion of a body if it is fast.
fn predict(
    context: CcdContext<'_>,
    handle: RigidBodyHandle,
    gravity: Vector,
) -> Option<FastMotion> {
    let body = context.bodies.get(handle)?;
    let (dt, (force, _)) = (context.params.dt, body.forces());
    let acceleration = gravity * body.gravity_scale + body.mprops.effective_inv_mass() * force;
    let shift = (body.vels.linvel + acceleration * (0.5 * dt)) * dt;
    let rotvec = body.vels.angvel * dt;
    let bound = BodyMotion::of(shift, rotvec, body.extent).bound();
    let is_link = || context.multibodies.rigid_body_link(handle).is_some();
    let predicted = FastMotion {
        body: handle,
        start: body.pose,
        center: body.mprops.world_com,
        shift,
        rotvec,
        acceleration,
        link: None,
        part: MotionPart::Whole,
    };
    (FastMotion::moves_far(body, bound, context.params) && !is_link()).then_some(predicted)
}

/// Moves the targets of position-based kinematic bodies to where they are after a fraction of the step. Adds
/// the targets so far to `targets`.
pub(crate) fn share_targets(
    mut bodies: Frozen<'_, RigidBodySet>,
    islands: &IslandManager,
    params: &IntegrationParameters,
    fraction: Real,
    targets: &mut Vec<(RigidBodyHandle, Pose)>,
) {
    for &handle in islands.awake.kinematic() {
        let body = bodies.get_unnoted_mut(handle);
        let is_driven = |body: &&mut RigidBody| {
            body.body_type == RigidBodyType::KinematicPositionBased && body.next_pose != body.pose
        };
        let Some(body) = body.filter(is_driven) else { continue };
        targets.push((handle, body.next_pose));
        let KinematicMotion { center, shift, rotvec } = KinematicMotion::ahead(body, params);
        body.next_pose = Sweep::new(body.pose, center, shift, rotvec).at(fraction);
    }
}
