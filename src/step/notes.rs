//! What stages tell each other during a step.

use crate::collide::Sweep;
use crate::dim::math::{AngVector, Pose, Real, Vector};
use crate::model::body::RigidBodyHandle;
use crate::model::contact::PairId;
use crate::model::event::{CollisionEvent, JointBreakEvent};

/// How a contact pair changed in the narrow phase.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(crate) enum PairChange {
    /// Its manifolds were computed anew: how many there are, and whether they are to be solved, may
    /// differ from before.
    Computed,
    /// The enlarged boxes no longer overlap.
    Apart,
}

/// How a body moved in this step that moved so far that it could have passed through something.
#[derive(Copy, Clone, Debug)]
pub(crate) struct FastMotion {
    pub body: RigidBodyHandle,
    /// Where it was.
    pub start: Pose,
    /// Where its centre of mass was, and how far this moved.
    pub center: Vector,
    pub shift: Vector,
    /// The rotation vector of its turn (rad).
    pub turn: AngVector,
    /// What forces have added to its velocities.
    pub gain: (Vector, AngVector),
}

impl FastMotion {
    /// The same motion of something on the body that was at `start`, as far as `stop`.
    pub fn sweep(&self, start: Pose, stop: Real) -> Sweep {
        Sweep::new(start, self.center, self.shift, self.turn).until(stop)
    }
}

/// Buffers that live from stage to stage within one step.
#[derive(Default)]
pub(crate) struct StepNotes {
    /// In the order of the awake pairs.
    pub contacts: Vec<(PairId, PairChange)>,
    /// The same for pairs with a sensor.
    pub intersections: Vec<(PairId, PairChange)>,
    /// What began and stopped touching, in the order in which it is to be reported.
    pub events: Vec<CollisionEvent>,
    /// Bodies that moved far, in the order in which the solver has them.
    pub fast: Vec<FastMotion>,
    /// Joints that broke, in the order of the constraint graph.
    pub broken: Vec<JointBreakEvent>,
}

impl StepNotes {
    /// Nothing happened yet.
    pub fn clear(&mut self) {
        self.contacts.clear();
        self.intersections.clear();
        self.events.clear();
        self.fast.clear();
        self.broken.clear();
    }
}
