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
use crate::collide::Leg;
use crate::dim::math::{Pose, Real, ang_length_squared, rotation_to_angle};
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

impl Ride {
    /// The ride of the fast body at a position on the collider that stopped it after a share of the step.
    pub fn of(
        search: Search<'_>,
        position: usize,
        share: Real,
        on: ColliderHandle,
    ) -> Option<Self> {
        let motion = &search.world.fast[position];
        let body = search.world.bodies.get(motion.body).filter(|_| motion.link.is_none())?;
        let collider = search.world.colliders.get(on)?;
        let carrier = Mover::not_fast(search, on, collider)?;
        let there = sweep_of(motion, motion.start, share).at(share);
        let relative = carrier.sweep.at(share).inv_mul(&there);
        let rotation = (carrier.sweep.at(1.0).rotation * relative.rotation).normalize();
        let translation = carrier.sweep.at(1.0) * relative.translation;
        let end = Pose::from_parts(translation, rotation);
        let local_center = body.local_center_of_mass();
        let center = there * local_center;
        let pace = 1.0 / (1.0 - share);
        let first = Leg {
            from: 0.0,
            until: share,
            rotation: motion.start.rotation,
            center: motion.center,
            shift: motion.shift,
            turn: motion.turn,
        };
        let second = Leg {
            from: share,
            until: 1.0,
            rotation: there.rotation,
            center,
            shift: (end * local_center - center) * pace,
            turn: rotation_to_angle(&(end.rotation * there.rotation.inverse())) * pace,
        };
        let is_finite = second.shift.is_finite() && ang_length_squared(second.turn).is_finite();
        let mut ride =
            Self { legs: [first, second], end: 1.0, pose: end, motion: BodyMotion::NONE };
        if !is_finite {
            return None;
        }
        ride.end = ride.first_stop(search, position, collider.parent());
        if ride.end <= share {
            return None;
        }
        let stopped = ride.path(search, position)?.pose_at(ride.end);
        ride.pose = if ride.end < 1.0 { stopped? } else { end };
        let way = first.shift * share + second.shift * (ride.end - share);
        let angle = first.angle() * share + second.angle() * (ride.end - share);
        let rest = if angle > 0.0 { angle * body.extent } else { 0.0 };
        ride.motion = BodyMotion::within(way.length() + rest);
        Some(ride)
    }

    /// The path of the body as far as it rides.
    pub fn path<'a>(&'a self, search: Search<'a>, position: usize) -> Option<Path<'a>> {
        Path::along(search, position, (&self.legs, self.end))
    }

    /// When something else stops it than the body that carries it.
    fn first_stop(
        &self,
        search: Search<'_>,
        position: usize,
        carrier: Option<crate::model::body::RigidBodyHandle>,
    ) -> Real {
        let path = self.path(search, position);
        path.map_or(0.0, |path| path.first_stop(search, carrier).share)
    }
}
