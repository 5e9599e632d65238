//! # Continuous — nothing passes through
//!
//! Reads:   how fast bodies moved, colliders, enlarged boxes, joints, hooks
//! Writes:  poses of fast bodies that hit something on their way, and the velocities that they had there
//! Runs:    parallel over fast bodies; bullets among each other in the order of their impacts
//! Never:   pushes anything, or looks at a body that is not fast, but for those in its way
//!
//! The solver looks at contacts where bodies are when a step begins. A body that moves farther than half its
//! thickness in one step (`src/step/solver/bodies/store.rs`) could be on the other side before it ever touched. So its path is searched, from
//! where its colliders still are to where the solver has put it, and it is stopped where it would get through
//! something: the next step finds it there, in contact, and with the velocity that it had then. The rest of its time is
//! lost, and so is what forces did in that time: a ball that fell through its last step, and was put back up, would
//! have more energy than it fell from.
//!
//! Fixed and kinematic colliders stop every body; a body with `ccd_enabled` (a *bullet*) stops at everything, other
//! bullets included: see [`bullets`]. Links of multibodies are not stopped: where a link is, the coordinates of its
//! joints say.
//!
//! The alternative that lost is to find such contacts in advance, by boxes as long as the path (*speculative contacts*):
//! they stop bodies that would have flown past, and a fast body finds half of the world near it.

mod bullets;
mod path;

use crate::base::tasks::Tasks;
use crate::dim::math::Real;
use crate::model::body::RigidBodySet;
use crate::model::collider::ColliderSet;
use crate::model::counters::CCDCounters;
use crate::model::hooks::PhysicsHooks;
use crate::model::island::IslandManager;
use crate::model::params::IntegrationParameters;
use crate::model::tree::BroadPhaseBvh;
use crate::step::notes::FastMotion;
use bullets::Bullets;
use path::{Path, sweep_of};

/// Fast bodies that are worth being searched for by another thread.
const BODIES_PER_TASK: usize = 2;

/// Buffers that are reused from step to step.
#[derive(Default)]
pub(crate) struct ContinuousScratch {
    /// By fast body: what share of its motion happens.
    stops: Vec<Real>,
    bullets: Bullets,
}

/// What paths are searched in.
#[derive(Copy, Clone)]
pub(crate) struct Surroundings<'a> {
    pub bodies: &'a RigidBodySet,
    pub colliders: &'a ColliderSet,
    pub islands: &'a IslandManager,
    pub trees: &'a BroadPhaseBvh,
    pub params: &'a IntegrationParameters,
    pub hooks: &'a dyn PhysicsHooks,
}

/// Finds out where bodies are stopped that moved fast. The shares of their motions that happen are in `scratch`.
pub(crate) fn find_impacts(
    tasks: Tasks<'_>,
    around: Surroundings<'_>,
    fast: &[FastMotion],
    ContinuousScratch { stops, bullets }: &mut ContinuousScratch,
) {
    stops.clear();
    if fast.is_empty() || around.params.max_ccd_substeps == 0 {
        return;
    }
    // Whose path could not be searched because a hook panicked is not moved.
    stops.resize(fast.len(), 0.0);
    tasks.par_fill(stops, BODIES_PER_TASK, |index| {
        let path = Path::of(around, &fast[index], 1.0);
        path.map_or(1.0, |path| path.first_stop(around))
    });
    bullets.find(around, fast, stops);
}

/// Puts the bodies where they were stopped.
pub(crate) fn stop(
    bodies: &mut RigidBodySet,
    fast: &[FastMotion],
    scratch: &ContinuousScratch,
    counters: &mut CCDCounters,
) {
    counters.num_substeps = 0;
    for (motion, &share) in fast.iter().zip(&scratch.stops).filter(|(_, share)| **share < 1.0) {
        let Some(body) = bodies.get_unnoted_mut(motion.body) else { continue };
        body.pose = sweep_of(motion, motion.start, share).at(share);
        body.linvel = motion.velocity_before(1.0 - share, body.linvel);
        body.update_world_mass_properties();
        counters.num_substeps += 1;
    }
}
