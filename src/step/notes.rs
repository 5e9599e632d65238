//! What stages tell each other during a step.

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

/// Buffers that live from stage to stage within one step.
#[derive(Default)]
pub(crate) struct StepNotes {
    /// In the order of the awake pairs.
    pub contacts: Vec<(PairId, PairChange)>,
    /// The same for pairs with a sensor.
    pub intersections: Vec<(PairId, PairChange)>,
    /// What began and stopped touching, in the order in which it is to be reported.
    pub events: Vec<CollisionEvent>,
    /// Joints that broke, in the order of the constraint graph.
    pub broken: Vec<JointBreakEvent>,
}

impl StepNotes {
    /// Nothing happened yet.
    pub fn clear(&mut self) {
        self.contacts.clear();
        self.intersections.clear();
        self.events.clear();
        self.broken.clear();
    }
}
