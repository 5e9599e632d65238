//! # CCD: continuous collision detection
//!
//! Reads:   motion of fast bodies, colliders, fat AABBs, bodies within sensors, joints, hooks
//! Writes:  poses and velocities of fast bodies at their first impact; bounds of motion; notes of crossed
//!     sensors; wakes bodies near moving kinematic bodies; the flags of deeply penetrating bodies
//! Runs:    parallel over fast bodies; bullets in the order of their impacts
//! Never:   applies impulses; searches bodies that are neither fast, nor deep in a wall, nor near the path of
//!     such a body or of a moving kinematic body
//!
//! The solver uses contacts at the poses when a step begins. A body that moves farther than half its
//! thickness in one step (`src/step/notes.rs`) could be on the other side before it ever touched. The stage
//! searches the path from the old collider poses to the solver's pose, and stops the body where it would pass
//! through something. The next step finds the body there, in contact, with its velocity at the impact. The
//! rest of its time is lost, including the work of forces. A ball that fell through its last step, and was
//! moved back up, would otherwise gain energy. A single body that is stopped at the beginning of its path
//! still rotates about its centre: see [`unblock`].
//!
//! Contacts are compliant: a heavy load can press a body into a wall slowly, so that the body is never fast.
//! The narrow phase therefore notes bodies that penetrate a non-dynamic collider by a quarter of their
//! thickness. Their path is searched, however short, until they are out.
//!
//! Motion is relative: a body that is slow itself is searched if a kinematic body moves past it fast enough
//! ([`approach`]). A body that a moving collider stops is carried by it for the rest of the step ([`ride`]).
//!
//! Fixed and kinematic colliders stop every body; a body with `ccd_enabled` (a *bullet*) stops at everything,
//! other bullets included: see [`bullets`]. Sensors stop no body, but report events: see [`sensors`].
//!
//! Bodies that joints hold together stop together, when the first of them does: see [`groups`]. A multibody
//! is such a group, and returns along the trajectory of its coordinates: see [`link_trajectories`].
//!
//! With `max_ccd_substeps` above 1, the step ends at the first impact and another one begins there: see
//! [`division`].
//!
//! The rejected alternative is *speculative contacts*, found by boxes as long as the path. They stop bodies
//! that would miss, and a fast body has half of the world nearby.

mod approach;
mod bullets;
mod division;
mod groups;
mod path;
mod ride;
mod sensors;
mod link_trajectories;

use crate::base::tasks::Tasks;
use crate::dim::math::{Real, ang_length_squared};
use crate::model::body::{RigidBody, RigidBodyHandle, RigidBodySet};
use crate::model::collider::ColliderSet;
use crate::model::contact::NarrowPhase;
use crate::model::counters::CCDCounters;
use crate::model::event::CollisionEvent;
use crate::model::frozen::Frozen;
use crate::model::hooks::PhysicsHooks;
use crate::model::island::{BodyMotion, IslandManager};
use crate::model::multibody::{LinkTrajectory, MultibodyJointSet};
use crate::model::params::IntegrationParameters;
use crate::model::tree::BroadPhaseBvh;
use crate::step::notes::{FastMotion, MotionPart};
pub(crate) use approach::{add_approached, find_approaches};
pub(crate) use division::{first_impact_time, share_targets};

use approach::Movers;
use bullets::Bullets;
use core::sync::atomic::{AtomicUsize, Ordering};
use groups::Groups;
use link_trajectories::LinkTrajectories;
use path::{NonDynamicFilter, Path, sweep_of};
use ride::{Rides, Stop};
use sensors::SensorCrossing;

/// A path that stops within this fraction of the motion is blocked.
const BLOCKED_FRACTION: Real = 0.01;

/// A body is thin if its thickness is less than this fraction of its extent.
const THIN_RATIO_MAX: Real = 0.25;

/// Number of fast bodies per parallel search task.
const BODIES_PER_TASK: usize = 2;

/// Buffers that are reused from step to step.
#[derive(Default)]
pub(crate) struct CcdScratch {
    movers: Movers,
    /// Motions that the velocities before the solver lead to.
    predicted: Vec<FastMotion>,
    /// By fast body: its stop by a non-dynamic collider.
    first: Vec<Stop>,
    /// By fast body: the executed fraction of its motion.
    toi_fractions: Vec<Real>,
    rides: Rides,
    link_trajectories: LinkTrajectories,
    groups: Groups,
    bullets: Bullets,
    /// By fast body: whether it is deeply penetrating when the step ends.
    deeply_penetrating: Vec<bool>,
    /// By fast body: the sensors that it passes.
    crossings: Vec<Vec<SensorCrossing>>,
    /// Pairs of colliders whose paths were searched.
    searched: AtomicUsize,
}

impl CcdScratch {
    fn clear(&mut self) {
        self.first.clear();
        self.toi_fractions.clear();
        self.rides.clear();
        self.deeply_penetrating.clear();
        self.crossings.clear();
        *self.searched.get_mut() = 0;
    }

    /// Returns whether bodies stop in the step, and ride after their stops.
    fn has_usable_stops(&self) -> bool {
        let is_fraction = |fraction: Real| (0.0..=1.0).contains(&fraction);
        let mut rides = self.rides.iter();
        self.toi_fractions.iter().all(|&stop| is_fraction(stop))
            && rides.all(|(at, ride)| is_fraction(ride.end) && ride.end >= self.toi_fractions[at])
    }

    /// Stops bodies where their own paths were stopped if a hook panicked before anything else was known.
    /// Bodies whose paths were not searched do not move.
    fn complete(&mut self) {
        if self.toi_fractions.len() < self.first.len() {
            self.toi_fractions.clear();
            self.toi_fractions.extend(self.first.iter().map(|stop| stop.fraction));
        }
    }
}

/// Context of the path search.
#[derive(Copy, Clone)]
pub(crate) struct CcdContext<'a> {
    pub bodies: &'a RigidBodySet,
    pub colliders: &'a ColliderSet,
    pub multibodies: &'a MultibodyJointSet,
    pub islands: &'a IslandManager,
    pub trees: &'a BroadPhaseBvh,
    pub narrow_phase: &'a NarrowPhase,
    pub params: &'a IntegrationParameters,
    pub hooks: &'a dyn PhysicsHooks,
    /// Motion of fast bodies, and of multibodies with a fast link.
    pub fast: &'a [FastMotion],
    pub trajectories: &'a [LinkTrajectory],
}

/// Input of one search: the world and its fast bodies.
#[derive(Copy, Clone)]
struct Search<'a> {
    context: CcdContext<'a>,
    movers: &'a Movers,
    link_trajectories: &'a LinkTrajectories,
    groups: &'a Groups,
    searched: &'a AtomicUsize,
}

/// Finds the times of impact of fast bodies, and the sensors that they cross. The results are in `scratch`.
/// Notes blocked bodies in `fast`.
pub(crate) fn find_impacts(
    tasks: Tasks<'_>,
    context: CcdContext<'_>,
    fast: &mut [FastMotion],
    scratch: &mut CcdScratch,
) {
    scratch.clear();
    if fast.is_empty() {
        return;
    }
    find_first_stops(tasks, CcdContext { fast, ..context }, scratch);
    unblock(context, fast, scratch);
    let context = CcdContext { fast, ..context };
    let CcdScratch {
        movers,
        first,
        toi_fractions,
        rides,
        link_trajectories,
        groups,
        bullets,
        deeply_penetrating,
        ..
    } = scratch;
    let (crossings, searched) = (&mut scratch.crossings, &scratch.searched);
    let count = context.fast.len();
    let search = Search { context, movers, link_trajectories, groups, searched };
    toi_fractions.extend(first.iter().map(|stop| stop.fraction));
    groups.stop_together(toi_fractions);
    bullets.find(search, toi_fractions);
    rides.find(tasks, search, first, toi_fractions);
    deeply_penetrating.resize(count, true);
    tasks.par_fill(deeply_penetrating, BODIES_PER_TASK, |position| {
        let path = match rides.of(position) {
            Some(ride) => ride.path(search, position),
            None if first[position].is_open => None,
            None => Path::of(search, position, toi_fractions[position]),
        };
        path.is_some_and(|path| path.ends_deep(search))
    });
    if context.trees.has_sensors() {
        crossings.resize_with(count, Vec::new);
        tasks.par_fill(crossings, BODIES_PER_TASK, |position| {
            let (path, end) = match rides.of(position) {
                Some(ride) => (ride.path_of_all(search, position), ride.end),
                None => (
                    Path::of_all(search, position, toi_fractions[position]),
                    toi_fractions[position],
                ),
            };
            path.map(|path| sensors::crossings(search, &path, end)).unwrap_or_default()
        });
    }
}

/// Finds where non-dynamic colliders stop each fast body.
fn find_first_stops(tasks: Tasks<'_>, context: CcdContext<'_>, scratch: &mut CcdScratch) {
    let CcdScratch { movers, first, link_trajectories, groups, searched, .. } = scratch;
    movers.find(context);
    link_trajectories.find(context);
    groups.find(context);
    // A body whose path could not be searched because a hook panicked does not move.
    first.resize(context.fast.len(), Stop::AT_ONCE);
    let search = Search { context, movers, link_trajectories, groups, searched };
    tasks.par_fill(first, BODIES_PER_TASK, |position| first_stop(search, position));
}

fn first_stop(search: Search<'_>, position: usize) -> Stop {
    if search.is_in_the_open(position) {
        return Stop::OPEN;
    }
    let path = Path::of(search, position, 1.0);
    path.map_or(Stop::NONE, |path| path.first_stop(search, NonDynamicFilter::All))
}

/// Lets single bodies whose paths are blocked at the beginning rotate in place, or move without rotation: the
/// part that leads farther. The near end of a spinning bar may leave the ground while its middle falls. No
/// contact force acts then, and the bar would hang in the air for ever.
///
/// Joined bodies would tear their joints, and hang until joints or other contacts move them. So do bullets
/// that a dynamic body blocks.
///
/// Bodies that are not thin rotate only if their paths are blocked at once: a ball that spins would
/// rotate for ever before a wall that is nearer than a hundredth of its way. The same holds for
/// surfaces. No middle of a surface is kept from passing, and each part is one more chance to pass.
///
/// Rejected alternatives:
///
/// * Cores of bodies that rotate in place are not stopped at once. No pose stays the same then, but more bars
///   hang over a box: 94 instead of 11 of 1,000.
/// * Rotation alone, for paths that are blocked at once: 398 of 3,640 thin bodies hang for more than four
///   steps. With both parts, 45 do (`tests/ccd/throws.rs`).
fn unblock(context: CcdContext<'_>, fast: &mut [FastMotion], scratch: &mut CcdScratch) {
    for position in 0..fast.len() {
        let (motion, stop) = (&fast[position], scratch.first[position].fraction);
        if stop > BLOCKED_FRACTION || !rotates_alone(context, motion) {
            continue;
        }
        let Some(body) = context.bodies.get(motion.body) else { continue };
        let is_thin = body.thickness > 0.0 && body.thickness < THIN_RATIO_MAX * body.extent;
        let parts: &[_] = match is_thin {
            true => &[MotionPart::Rotation, MotionPart::Translation],
            false if stop == 0.0 => &[MotionPart::Rotation],
            false => continue,
        };
        take_longest_part(parts, context, fast, position, scratch);
    }
}

/// Returns whether a body rotates that nothing is joined to.
fn rotates_alone(context: CcdContext<'_>, motion: &FastMotion) -> bool {
    let joints = &context.islands.joints;
    let is_attached = |&joint: &_| joints.get(joint).is_some_and(|joint| joint.attached);
    motion.link.is_none()
        && ang_length_squared(motion.rotvec) > 0.0
        && !joints.of_body(motion.body.into_raw_parts().0).iter().any(is_attached)
}

/// Selects the part of a motion, or the whole, on whose path the points of the body get farthest.
fn take_longest_part(
    parts: &[MotionPart],
    context: CcdContext<'_>,
    fast: &mut [FastMotion],
    position: usize,
    scratch: &mut CcdScratch,
) {
    let CcdScratch { movers, first, link_trajectories, groups, searched, .. } = scratch;
    let extent = context.bodies.get(fast[position].body).map_or(0.0, |body| body.extent);
    let way = |motion: &FastMotion, stop: Stop| stop.fraction * motion.path_length(extent);
    let mut best = (fast[position].part, first[position]);
    let mut longest = way(&fast[position], first[position]);
    for &part in parts {
        fast[position].part = part;
        let context = CcdContext { fast, ..context };
        let search = Search { context, movers, link_trajectories, groups, searched };
        let stop = first_stop(search, position);
        let way = way(&fast[position], stop);
        if way > longest {
            (best, longest) = ((part, stop), way);
        }
    }
    (fast[position].part, first[position]) = best;
}

/// Marks these bodies, so that their paths are searched if CCD is enabled.
pub(crate) fn set_deeply_penetrating(
    bodies: &mut RigidBodySet,
    deeply_penetrating: &[RigidBodyHandle],
    params: &IntegrationParameters,
) {
    if params.max_ccd_substeps == 0 {
        return;
    }
    for &body in deeply_penetrating {
        bodies.get_unnoted_mut(body).into_iter().for_each(|body| body.deeply_penetrating = true);
    }
}

/// Context of the stops.
pub(crate) struct StopContext<'a> {
    pub bodies: Frozen<'a, RigidBodySet>,
    pub islands: Frozen<'a, IslandManager>,
    pub multibodies: Frozen<'a, MultibodyJointSet>,
    pub fast: &'a [FastMotion],
    pub trajectories: &'a [LinkTrajectory],
    pub dt: Real,
}

/// Puts the bodies where they were stopped, and notes the sensors that were passed.
pub(crate) fn stop(
    mut context: StopContext<'_>,
    scratch: &mut CcdScratch,
    events: &mut Vec<CollisionEvent>,
    counters: &mut CCDCounters,
) {
    scratch.complete();
    debug_assert_eq!(scratch.toi_fractions.len(), context.fast.len(), "all paths were searched");
    debug_assert!(scratch.has_usable_stops());
    let StopContext { bodies, islands, fast, dt, .. } = &mut context;
    counters.num_fast_bodies += fast.len();
    counters.num_searches += scratch.searched.load(Ordering::Relaxed);
    let stops = fast.iter().zip(&scratch.toi_fractions);
    let is_stopped = |motion: &FastMotion, stop| stop < 1.0 || motion.part != MotionPart::Whole;
    for (motion, &stop) in stops.filter(|&(motion, &stop)| is_stopped(motion, stop)) {
        let Some(body) = bodies.get_unnoted_mut(motion.body) else { continue };
        counters.num_substeps += 1;
        if motion.link.is_none() {
            put_at_stop(body, motion, stop, *dt);
            if !body.ccd_active {
                // The bound of the whole motion of a fast body is noted already.
                let displacement = body.mprops.world_com - motion.center;
                let rotvec = motion.path_rotvec() * stop;
                let moved = BodyMotion::of(displacement, rotvec, body.extent);
                islands.set_motion(motion.body.into_raw_parts().0, moved);
            }
        }
    }
    for (position, ride) in scratch.rides.iter() {
        let motion = &fast[position];
        let Some(body) = bodies.get_unnoted_mut(motion.body) else { continue };
        body.pose = ride.pose;
        body.update_world_mass_properties();
        islands.set_motion(motion.body.into_raw_parts().0, ride.motion);
    }
    for (motion, &deeply_penetrating) in fast.iter().zip(&scratch.deeply_penetrating) {
        let body = bodies.get_unnoted_mut(motion.body);
        body.into_iter().for_each(|body| body.deeply_penetrating = deeply_penetrating);
    }
    scratch.link_trajectories.stop(&mut context, &scratch.toi_fractions);
    for crossing in scratch.crossings.iter().flatten() {
        counters.num_sensors_passed += 1;
        events.extend(crossing.events());
    }
}

/// Gives a body the pose and the velocity that it has after a fraction of its path.
fn put_at_stop(body: &mut RigidBody, motion: &FastMotion, stop: Real, dt: Real) {
    let executed = |left_out| if motion.part == left_out { 0.0 } else { stop };
    let translation = executed(MotionPart::Rotation);
    let rotation = executed(MotionPart::Translation);
    let there = sweep_of(motion, motion.start, stop).at(stop);
    body.vels.angvel = body.angvel_at(there.rotation, (rotation - 1.0) * dt);
    body.pose = there;
    body.vels.linvel = motion.velocity_before(1.0 - translation, body.vels.linvel);
    body.update_world_mass_properties();
}
