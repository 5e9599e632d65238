//! Data that one stage leaves for later stages of the same step.

use crate::dim::math::{ANG_ZERO, AngVector, Pose, Real, Vector, ang_length_squared};
use crate::model::body::{RigidBody, RigidBodyHandle, RigidBodyVelocity};
use crate::model::collider::ColliderHandle;
use crate::model::contact::PairId;
use crate::model::event::{CollisionEvent, JointBreakEvent, QuarantineEvent};
use crate::model::multibody::LinkTrajectory;
use crate::model::params::IntegrationParameters;

/// Change of a contact pair in the narrow phase.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(crate) enum PairChange {
    /// Its manifolds were recomputed. Their number may differ from before, and so may the set of solved ones.
    Computed,
    /// The fat AABBs no longer overlap.
    Apart,
}

/// A body is fast if it moves farther than this fraction of its thickness in one step. A separated body might
/// otherwise end with its middle behind a thin collider.
const MOTION_FRACTION_MAX: Real = 0.5;

/// Motion of a body that moved far enough to pass through something.
#[derive(Copy, Clone, Debug)]
pub(crate) struct FastMotion {
    pub body: RigidBodyHandle,
    /// Pose at the start.
    pub start: Pose,
    /// Centre of mass at the start, and its displacement.
    pub center: Vector,
    pub shift: Vector,
    /// Rotation vector (rad).
    pub rotvec: AngVector,
    /// Acceleration by forces.
    pub acceleration: Vector,
    /// For a link: index of the multibody in `trajectories`, and of the link in it.
    pub link: Option<(usize, usize)>,
    /// The part of the motion that is executed.
    pub part: MotionPart,
}

/// The part of a motion that a body executes.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(crate) enum MotionPart {
    Whole,
    /// About the centre of mass. The centre stays.
    Rotation,
    Translation,
}

impl FastMotion {
    /// Displacement of the centre of mass on the path that CCD searches.
    pub fn path_shift(&self) -> Vector {
        if self.part == MotionPart::Rotation { Vector::ZERO } else { self.shift }
    }

    /// Rotation vector (rad) on the path that CCD searches.
    pub fn path_rotvec(&self) -> AngVector {
        if self.part == MotionPart::Translation { ANG_ZERO } else { self.rotvec }
    }

    /// A bound of the way of all points on that path, of a body of this extent.
    pub fn path_length(&self, extent: Real) -> Real {
        let angle = ang_length_squared(self.path_rotvec()).sqrt();
        self.path_shift().length() + angle * extent
    }

    /// Returns whether a body is fast that moved by at most `bound`. A body without interior (thickness 0) is
    /// fast if it moved farther than the prediction distance. A deeply penetrating body is fast if it moved
    /// at all. No body is fast if CCD is off.
    pub fn is_fast(body: &RigidBody, bound: Real, params: &IntegrationParameters) -> bool {
        let is_deep = body.deeply_penetrating && bound > 0.0;
        params.max_ccd_substeps > 0 && (is_deep || Self::moves_far(body, bound, params))
    }

    /// Returns whether a body that moved by at most `bound` may have passed through something.
    pub fn moves_far(body: &RigidBody, bound: Real, params: &IntegrationParameters) -> bool {
        let is_solid = body.thickness > 0.0;
        let little = if is_solid {
            MOTION_FRACTION_MAX * body.thickness
        } else {
            params.prediction_distance()
        };
        bound > little
    }

    /// Velocity when a fraction of the motion was left, for a velocity of `end` at the end. It excludes the
    /// work of forces on the remaining path.
    pub fn velocity_before(&self, left: Real, end: Vector) -> Vector {
        let square = end.length_squared();
        let earlier = square - 2.0 * left * self.acceleration.dot(self.shift);
        // The direction of a nearly stopped body is unknown.
        let faster = (earlier.max(0.0) / square).sqrt();
        if faster.is_finite() { end * faster } else { end }
    }
}

/// A kinematic body moves towards a dynamic one.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(crate) struct Approach {
    pub body: RigidBodyHandle,
    pub kinematic: RigidBodyHandle,
}

/// A body whose state after the solver is not storable.
#[derive(Copy, Clone, Debug)]
pub(crate) struct Diverged {
    pub body: RigidBodyHandle,
    /// The velocity that was found.
    pub velocity: RigidBodyVelocity,
    /// Whether it is a link that its multibody moves.
    pub is_link: bool,
}

/// Buffers that live from stage to stage within one step.
#[derive(Default)]
pub(crate) struct StepNotes {
    /// In the order of the colliders.
    pub contacts: Vec<(PairId, PairChange)>,
    /// The same for pairs with a sensor.
    pub intersections: Vec<(PairId, PairChange)>,
    /// Bodies that were found deep in something that is not dynamic, in any order.
    pub deeply_penetrating: Vec<RigidBodyHandle>,
    /// In a divided step: position-based kinematic bodies, and their targets at the end of the whole step.
    pub targets: Vec<(RigidBodyHandle, Pose)>,
    /// Touch events in the order of discovery; see [`Self::order_events`].
    pub events: Vec<CollisionEvent>,
    /// Bodies that moved far, in the order in which the solver has them.
    pub fast: Vec<FastMotion>,
    /// Dynamic bodies near the paths of kinematic ones, in the order of their handles.
    pub approaches: Vec<Approach>,
    /// Multibodies with a link that moved far. All their links are in the list of fast bodies.
    pub trajectories: Vec<LinkTrajectory>,
    /// In the order of the awake bodies: whether each has been at rest for long enough to sleep. Empty until
    /// all of them have moved.
    pub sleepy: Vec<bool>,
    /// Joints that broke, in the order of the constraint graph.
    pub broken: Vec<JointBreakEvent>,
    /// Bodies that the solver could not store. If there are any, it has stored nothing.
    pub diverged: Vec<Diverged>,
    /// Contacts with impossible numbers, in the order of their colliders; then, at the end of the step,
    /// bodies.
    pub quarantined: Vec<QuarantineEvent>,
}

impl StepNotes {
    /// Clears all notes.
    pub fn clear(&mut self) {
        self.clear_attempt();
        self.targets.clear();
        self.events.clear();
        self.broken.clear();
    }

    /// Restarts the step in a world that already contains the touch and break events so far.
    pub fn clear_attempt(&mut self) {
        self.contacts.clear();
        self.deeply_penetrating.clear();
        self.intersections.clear();
        self.fast.clear();
        self.approaches.clear();
        self.sleepy.clear();
        self.trajectories.clear();
        self.diverged.clear();
        self.quarantined.clear();
    }

    /// Sorts the touch events in the order of the colliders. The order of discovery depends on the cause: an
    /// object that is removed during a failed step parts later than one that was removed before. The events
    /// of one pair stay in order.
    pub fn order_events(&mut self) {
        let rank = |handle: ColliderHandle| handle.into_raw_parts();
        self.events.sort_by_key(|event| (rank(event.collider1()), rank(event.collider2())));
    }
}

#[cfg(test)]
mod tests {
    use super::{FastMotion, MotionPart};
    use crate::dim::math::{ANG_ZERO, Pose, Real, Vector};
    use crate::model::body::RigidBodyHandle;

    fn braked(shift: Real, acceleration: Real) -> FastMotion {
        FastMotion {
            body: RigidBodyHandle::invalid(),
            start: Pose::IDENTITY,
            center: Vector::ZERO,
            shift: Vector::X * shift,
            rotvec: ANG_ZERO,
            acceleration: Vector::X * acceleration,
            link: None,
            part: MotionPart::Whole,
        }
    }

    /// Halfway, braking has not yet taken all speed: `v² = 3² + 2 · 2 · 4`, while 4 of the 8 m are left.
    #[test]
    fn braked_bodies_were_faster_before() {
        let before = braked(8.0, -2.0).velocity_before(0.5, Vector::X * 3.0);
        assert!((before - Vector::X * 5.0).length() < 1.0e-5, "{before}");
    }

    /// A velocity that forces reduced to almost zero has a direction, but no multiple of it is the earlier
    /// speed.
    #[test]
    fn almost_zero_speeds_stay_finite() {
        for end in [0.0, Real::MIN_POSITIVE, Real::MIN_POSITIVE.sqrt()] {
            let before = braked(1.0e4, -1.0e8).velocity_before(1.0, Vector::X * end);
            assert!(before.is_finite(), "{end} became {before}");
        }
    }
}
