//! Bodies that ride on what stopped them.
//!
//! A body that a wall stops stays where it touches the wall for the rest of the step. If the wall is kinematic and moves, that place
//! moves with it. With `O(s)` the pose of the kinematic body after a share `s` of the step and `X(s)` that of the body, stopped at `s`:
//!
//! ```text
//! X(1) = O(1) O(s)⁻¹ X(s)
//! ```
//!
//! So a door sweeps a ball along and does not turn through it. The velocity is the body's own, as after every stop: the next step finds it in
//! contact, and the solver makes it as fast as the door.
//!
//! The ride is searched as every path. If something else is in the way, a wall behind the ball, the body stays there, at the share of the step at
//! which it is caught between the two. Nothing can be outside both of two rigid things that close on it: it
//! never passes the one behind it, and the kinematic body, which nothing stops, gets into it.

use super::Search;
use super::path::{Mover, Path, sweep_of};
use crate::base::tasks::Tasks;
use crate::collide::{Leg, Sweep};
use crate::dim::math::{Pose, Real, Vector, ang_length_squared, rotation_to_angle};
use crate::model::collider::ColliderHandle;
use crate::model::island::BodyMotion;

/// What stops a body, and when.
#[derive(Copy, Clone, Debug)]
pub(super) struct Stop {
    /// The share of the motion that happens.
    pub share: Real,
    /// The collider that it meets then, if that moves.
    pub by: Option<ColliderHandle>,
}

impl Stop {
    /// The motion happens as a whole.
    pub const NONE: Self = Self { share: 1.0, by: None };
    /// It does not happen at all.
    pub const AT_ONCE: Self = Self { share: 0.0, by: None };
}

/// The rest of a step on a kinematic body.
#[derive(Copy, Clone, Debug)]
pub(super) struct Ride {
    /// The way until the stop, and from there on.
    pub legs: [Leg; 2],
    /// The share of the step at which the ride ends.
    pub end: Real,
    /// Where the body is then.
    pub pose: Pose,
    /// How far it moved in the step.
    pub motion: BodyMotion,
}

/// The rides of a step.
#[derive(Default)]
pub(super) struct Rides {
    /// The positions of fast bodies that a moving collider stopped, in rising order.
    stopped: Vec<(u32, ColliderHandle)>,
    /// How these go on; nothing if they cannot.
    rides: Vec<Option<Ride>>,
    /// By the first position of a group: the moving collider that stopped it.
    carriers: Vec<Option<ColliderHandle>>,
}

impl Rides {
    pub fn clear(&mut self) {
        self.stopped.clear();
        self.rides.clear();
    }

    /// Finds the rides, given what stopped each body first, and where bodies have stopped in the end: earlier if they are joined to others or
    /// bullets.
    pub fn find(
        &mut self,
        tasks: Tasks<'_>,
        search: Search<'_>,
        (first, stops): (&[Stop], &[Real]),
    ) {
        if first.iter().all(|stop| stop.by.is_none()) {
            return;
        }
        self.list_stopped(search, first, stops);
        let Self { stopped, rides, .. } = self;
        rides.resize(stopped.len(), None);
        tasks.par_fill(rides, 1, |at| {
            let (position, by) = stopped[at];
            Ride::of(search, position as usize, stops[position as usize], by)
        });
    }

    /// Lists the bodies that a moving collider stopped, alone or with their groups. Linear in the number of fast bodies: a chain is one group.
    fn list_stopped(&mut self, search: Search<'_>, first: &[Stop], stops: &[Real]) {
        self.carriers.clear();
        self.carriers.resize(stops.len(), None);
        for (position, (stop, &share)) in first.iter().zip(stops).enumerate() {
            let by = stop.by.filter(|_| stop.share == share && share < 1.0);
            let carrier = &mut self.carriers[search.groups.first(position)];
            *carrier = carrier.or(by);
        }
        for position in 0..stops.len() {
            let by = self.carriers[search.groups.first(position)];
            self.stopped.extend(by.map(|by| (position as u32, by)));
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
    /// The ride of the fast body at a position on the collider that stopped it after a share of the step.
    fn of(search: Search<'_>, position: usize, share: Real, on: ColliderHandle) -> Option<Self> {
        let motion = &search.world.fast[position];
        let body = search.world.bodies.get(motion.body).filter(|_| motion.link.is_none())?;
        let collider = search.world.colliders.get(on)?;
        let carrier = Mover::not_fast(search, on, collider)?.sweep;
        let start = sweep_of(motion, motion.start, share).at(share);
        let end = carried(&carrier, share, &start);
        let local_center = body.local_center_of_mass();
        let first = Leg {
            from: 0.0,
            until: share,
            rotation: motion.start.rotation,
            center: motion.center,
            shift: motion.shift,
            turn: motion.turn,
        };
        let second = straight_leg(share, [&start, &end], local_center)?;
        let mut ride =
            Self { legs: [first, second], end: 1.0, pose: end, motion: BodyMotion::NONE };
        let stop = {
            let path = ride.path(search, position)?;
            let stop = path.first_stop(search, collider.parent()).share;
            if stop < 1.0 { (stop, path.pose_at(stop)?) } else { (stop, end) }
        };
        (ride.end, ride.pose) = stop;
        let stop = ride.end;
        let way = first.shift * share + second.shift * (stop - share);
        let angle = first.angle() * share + second.angle() * (stop - share);
        let rest = if angle > 0.0 { angle * body.extent } else { 0.0 };
        ride.motion = BodyMotion::within(way.length() + rest);
        (stop > share).then_some(ride)
    }

    /// The path of the body as far as it rides.
    pub fn path<'a>(&'a self, search: Search<'a>, position: usize) -> Option<Path<'a>> {
        Path::along(search, position, (&self.legs, self.end))
    }
}

/// Where something is at the end of the step that is at `start` after a share of it, and moves with a carrier from then on.
fn carried(carrier: &Sweep<'_>, share: Real, start: &Pose) -> Pose {
    let relative = carrier.at(share).inv_mul(start);
    let end = carrier.at(1.0) * relative;
    Pose::from_parts(end.translation, end.rotation.normalize())
}

/// The straight leg from one pose to another in the rest of the step. `None` if it has no finite velocity.
fn straight_leg(from: Real, [start, end]: [&Pose; 2], local_center: Vector) -> Option<Leg> {
    let pace = 1.0 / (1.0 - from);
    let center = *start * local_center;
    let shift = (*end * local_center - center) * pace;
    let turn = rotation_to_angle(&(end.rotation * start.rotation.inverse())) * pace;
    let is_finite = shift.is_finite() && ang_length_squared(turn).is_finite();
    let leg = Leg { from, until: 1.0, rotation: start.rotation, center, shift, turn };
    is_finite.then_some(leg)
}
