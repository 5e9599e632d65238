//! Rides: bodies that a moving collider carries after a stop.
//!
//! A body that a wall stops stays where it touches the wall for the rest of the step. If the wall is
//! kinematic and moves, that place moves with it. Let `O(s)` be the pose of the kinematic body after a
//! fraction `s` of the step, and `X(s)` that of the body, stopped at `s`:
//!
//! ```text
//! X(1) = O(1) O(s)⁻¹ X(s)
//! ```
//!
//! A door thus pushes a ball along and does not rotate through it. The velocity stays the body's own, as
//! after every stop. The next step finds the contact, and the solver accelerates the body to the speed of the
//! door.
//!
//! The ride is searched as every path. A fixed collider on the path ends the ride; the body stops there.
//! While a body is stopped, moving kinematic colliders are searched for, and the first one carries it on. A
//! blade thus takes along a ball that landed on the floor earlier in the same step. At most [`SEGMENTS_MAX`]
//! rides and stops follow each other.
//!
//! A body between a fixed collider and a kinematic one stops at the fraction of the step at which it is
//! caught. No position is outside both rigid bodies. The body never passes the fixed one, and the kinematic
//! body, which nothing stops, overlaps it.
//!
//! Joined bodies end their rides together, at the earliest end. Links of multibodies, and bodies joined to
//! links, do not ride.

use super::Search;
use super::path::{Mover, NonDynamicFilter, Path, sweep_of};
use crate::base::tasks::Tasks;
use crate::collide::{PathSegment, Sweep};
use crate::dim::math::{ANG_ZERO, Pose, Real, Vector, ang_length_squared, rotation_to_angle};
use crate::model::body::RigidBody;
use crate::model::collider::ColliderHandle;
use crate::model::island::BodyMotion;
use smallvec::{SmallVec, smallvec};

/// Rides and rests that follow the first stop of a body in one step. Each costs a search.
const SEGMENTS_MAX: usize = 4;

/// Cause and time of a stop.
#[derive(Copy, Clone, Debug)]
pub(super) struct Stop {
    /// The executed fraction of the motion.
    pub fraction: Real,
    /// The collider that it meets then, if that moves.
    pub by: Option<ColliderHandle>,
    /// Whether nothing that is not dynamic is near the whole path.
    pub is_open: bool,
}

impl Stop {
    /// The motion happens as a whole.
    pub const NONE: Self = Self { fraction: 1.0, by: None, is_open: false };
    /// It does not happen at all.
    pub const AT_ONCE: Self = Self { fraction: 0.0, by: None, is_open: false };
    /// Nothing is near that could stop the motion.
    pub const OPEN: Self = Self { is_open: true, ..Self::NONE };
}

/// The rest of a step on kinematic bodies.
#[derive(Clone, Debug)]
pub(super) struct Ride {
    /// The path until the first stop, and the path after it.
    pub segments: SmallVec<[PathSegment; 4]>,
    /// The fraction of the step at which the last segment ends.
    pub end: Real,
    /// The pose of the body then.
    pub pose: Pose,
    /// Displacement of the body in the step.
    pub motion: BodyMotion,
}

/// The rides of a step.
#[derive(Default)]
pub(super) struct Rides {
    /// The positions of stopped fast bodies that may ride, in rising order, with the moving collider that
    /// stopped each, if one did.
    stopped: Vec<(u32, Option<ColliderHandle>)>,
    /// Their rides; nothing if they stay where they were stopped.
    rides: Vec<Option<Ride>>,
    /// By the first position of a group: the moving collider that stopped it.
    carriers: Vec<Option<ColliderHandle>>,
    /// By the first position of a group: the earliest end of its rides.
    ends: Vec<Real>,
}

impl Rides {
    pub fn clear(&mut self) {
        self.stopped.clear();
        self.rides.clear();
    }

    /// Finds the rides from the first stop of each body and the final stops. Final stops are earlier for
    /// joined bodies and bullets.
    pub fn find(
        &mut self,
        tasks: Tasks<'_>,
        search: Search<'_>,
        first: &[Stop],
        toi_fractions: &[Real],
    ) {
        if search.movers.is_empty() {
            return;
        }
        self.list_stopped(search, first, toi_fractions);
        let Self { stopped, rides, .. } = self;
        rides.resize(stopped.len(), None);
        tasks.par_fill(rides, 1, |at| {
            let (position, by) = stopped[at];
            Ride::of(search, position as usize, toi_fractions[position as usize], by)
        });
        self.end_together(search, toi_fractions.len());
    }

    /// Lists the bodies that a moving collider stopped, alone or with their groups, and single bodies that
    /// anything else stopped. Linear in the number of fast bodies: a chain is one group.
    fn list_stopped(&mut self, search: Search<'_>, first: &[Stop], toi_fractions: &[Real]) {
        self.carriers.clear();
        self.carriers.resize(toi_fractions.len(), None);
        for (position, (stop, &fraction)) in first.iter().zip(toi_fractions).enumerate() {
            let by = stop.by.filter(|_| stop.fraction == fraction && fraction < 1.0);
            let carrier = &mut self.carriers[search.groups.first(position)];
            *carrier = carrier.or(by);
        }
        for (position, &fraction) in toi_fractions.iter().enumerate() {
            let by = self.carriers[search.groups.first(position)];
            if by.is_some() || fraction < 1.0 && search.groups.is_alone(position) {
                self.stopped.push((position as u32, by));
            }
        }
    }

    /// Ends the rides of each group at the earliest end among them.
    fn end_together(&mut self, search: Search<'_>, count: usize) {
        self.ends.clear();
        self.ends.resize(count, 1.0);
        for (&(position, _), ride) in self.stopped.iter().zip(&self.rides) {
            let end = &mut self.ends[search.groups.first(position as usize)];
            *end = end.min(ride.as_ref().map_or(0.0, |ride| ride.end));
        }
        for (&(position, _), ride) in self.stopped.iter().zip(&mut self.rides) {
            let end = self.ends[search.groups.first(position as usize)];
            if ride.as_ref().is_some_and(|ride| ride.end > end) {
                *ride = ride.take().and_then(|ride| ride.until(search, position as usize, end));
            }
        }
    }

    /// The ride of the fast body at a position.
    pub fn of(&self, position: usize) -> Option<&Ride> {
        let at = self.stopped.binary_search_by_key(&(position as u32), |stopped| stopped.0).ok()?;
        self.rides[at].as_ref()
    }

    /// All rides, with the positions of the bodies.
    pub fn iter(&self) -> impl Iterator<Item = (usize, &Ride)> {
        let rides = self.stopped.iter().zip(&self.rides);
        rides.filter_map(|(stopped, ride)| Some((stopped.0 as usize, ride.as_ref()?)))
    }
}

impl Ride {
    /// The ride of the fast body at a position that a moving or resting collider stopped after a
    /// fraction of the step. `None` if nothing carries it on.
    fn of(
        search: Search<'_>,
        position: usize,
        fraction: Real,
        by: Option<ColliderHandle>,
    ) -> Option<Self> {
        let motion = &search.context.fast[position];
        let body = search.context.bodies.get(motion.body).filter(|_| motion.link.is_none())?;
        let first = PathSegment {
            from: 0.0,
            until: fraction,
            rotation: motion.start.rotation,
            center: motion.center,
            shift: motion.path_shift(),
            rotvec: motion.path_rotvec(),
        };
        let pose = sweep_of(motion, motion.start, fraction).at(fraction);
        let mut ride =
            Self { segments: smallvec![first], end: fraction, pose, motion: BodyMotion::NONE };
        // Joined bodies would stop and ride at different times.
        let segments_max = if search.groups.is_alone(position) { SEGMENTS_MAX } else { 1 };
        let (mut on, mut has_moved) = (by, false);
        for _ in 0..segments_max {
            let Some(stop) = ride.go_on(search, position, body, on) else { break };
            has_moved |= on.is_some();
            on = stop.by;
            if stop.fraction >= 1.0 {
                break;
            }
        }
        ride.motion = ride.motion_of(body);
        has_moved.then_some(ride)
    }

    /// Adds the segment on a moving collider, or the segment of a stopped body. Returns its end; `None`
    /// if a ride ends as it begins.
    fn go_on(
        &mut self,
        search: Search<'_>,
        position: usize,
        body: &RigidBody,
        on: Option<ColliderHandle>,
    ) -> Option<Stop> {
        let (from, local_center) = (self.end, body.local_center_of_mass());
        let (end, filter) = match on {
            Some(on) => {
                let collider = search.context.colliders.get(on)?;
                let carrier = Mover::not_fast(search, on, collider)?.sweep;
                (carried(&carrier, from, &self.pose), NonDynamicFilter::NotOn(collider.parent()))
            }
            None => (self.pose, NonDynamicFilter::Moving),
        };
        let segment = match on {
            Some(_) => straight_segment(from, [&self.pose, &end], local_center)?,
            None => resting_segment(from, &self.pose, local_center),
        };
        let mut next = self.clone();
        (next.end, next.pose) = (1.0, end);
        next.segments.push(segment);
        let (stop, pose) = {
            let path = next.path(search, position)?;
            let stop = path.first_stop(search, filter);
            (stop, if stop.fraction < 1.0 { path.pose_at(stop.fraction)? } else { end })
        };
        if stop.fraction <= from {
            // A mover whose surface has touched a standing body before, and whose middle comes now, carries
            // it from here on.
            return on.is_none().then_some(stop);
        }
        next.segments.last_mut()?.until = stop.fraction;
        (next.end, next.pose) = (stop.fraction, pose);
        *self = next;
        Some(stop)
    }

    /// The same ride, up to a fraction of the step. `None` if nothing of it is left.
    fn until(mut self, search: Search<'_>, position: usize, end: Real) -> Option<Self> {
        let body = search.context.bodies.get(search.context.fast[position].body)?;
        let last = self.segments.last_mut().filter(|segment| segment.from < end)?;
        last.until = end;
        self.end = end;
        let pose = self.path(search, position)?.pose_at(end)?;
        self.pose = pose;
        self.motion = self.motion_of(body);
        Some(self)
    }

    fn motion_of(&self, body: &RigidBody) -> BodyMotion {
        let lasts = |segment: &PathSegment| segment.until - segment.from;
        let displacement: Vector =
            self.segments.iter().map(|segment| segment.shift * lasts(segment)).sum();
        let angle: Real =
            self.segments.iter().map(|segment| segment.angle() * lasts(segment)).sum();
        let rest = if angle > 0.0 { angle * body.extent } else { 0.0 };
        BodyMotion::within(displacement.length() + rest)
    }

    /// The path of all colliders of the body as far as it rides.
    pub fn path_of_all<'a>(&'a self, search: Search<'a>, position: usize) -> Option<Path<'a>> {
        Path::along(search, position, &self.segments, self.end)
    }

    /// The path of the solid ones.
    pub fn path<'a>(&'a self, search: Search<'a>, position: usize) -> Option<Path<'a>> {
        self.path_of_all(search, position).map(Path::of_solids)
    }
}

/// Pose at the end of the step of an object at `start` after a fraction of the step. From then on it moves
/// with a carrier.
fn carried(carrier: &Sweep<'_>, fraction: Real, start: &Pose) -> Pose {
    let relative = carrier.at(fraction).inv_mul(start);
    let end = carrier.at(1.0) * relative;
    Pose::from_parts(end.translation, end.rotation.normalize())
}

/// The straight segment from one pose to another in the rest of the step. `None` if it has no finite
/// velocity.
fn straight_segment(
    from: Real,
    [start, end]: [&Pose; 2],
    local_center: Vector,
) -> Option<PathSegment> {
    let pace = 1.0 / (1.0 - from);
    let center = *start * local_center;
    let shift = (*end * local_center - center) * pace;
    let rotvec = rotation_to_angle(&(end.rotation * start.rotation.inverse())) * pace;
    let is_finite = shift.is_finite() && ang_length_squared(rotvec).is_finite();
    let segment = PathSegment { from, until: 1.0, rotation: start.rotation, center, shift, rotvec };
    is_finite.then_some(segment)
}

/// The segment of a body that is stopped for the rest of the step.
fn resting_segment(from: Real, pose: &Pose, local_center: Vector) -> PathSegment {
    let (rotation, center) = (pose.rotation, *pose * local_center);
    PathSegment { from, until: 1.0, rotation, center, shift: Vector::ZERO, rotvec: ANG_ZERO }
}
