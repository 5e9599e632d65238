//! Invariants between stages, and of a loaded world.
//!
//! Debug builds check it twice a step. A loaded world is checked before the first step applies edits. Until
//! then the lists refer to the state after the last step, and edits are separate notes. A reference is
//! therefore compared with the state *at that time* ([`LastStep`]). A removed body keeps its place in the
//! lists, a new one has none yet, and edited data may differ.

mod bodies;
mod colors;
mod joints;
mod last_step;
mod pairs;
mod trees;

use super::Structure;
use crate::base::fault::Fault;
use crate::base::loading::Loaded;
use crate::base::measure::is_point;
use crate::model::joint::ImpulseJointSet;
use crate::model::multibody::MultibodyJointSet;
use crate::model::tree::BroadPhaseBvh;
use last_step::LastStep;

type Verdict = Result<(), Fault>;

/// Extent of the check.
#[derive(Copy, Clone, PartialEq, Eq)]
enum Depth {
    /// Invariants that an error of the engine would violate. Allocates no memory, as the step does not.
    Quick,
    /// Invariants that forged data could violate besides.
    Full,
}

impl Structure<'_> {
    /// Checks every sentence of the module's documentation, and the trees of multibodies.
    ///
    /// # Panics
    /// If one does not hold.
    pub fn validate(&self, multibodies: &MultibodyJointSet) {
        let fault = self.check().and_then(|()| multibodies.check_trees()).err();
        assert!(fault.is_none(), "{}", fault.map_or(String::new(), |fault| fault.to_string()));
    }

    /// Returns whether positions and velocities of all awake bodies are finite and within their limits.
    pub fn has_usable_bodies(&self) -> bool {
        let mut awake = self.islands.awake.iter().filter_map(|&handle| self.bodies.get(handle));
        awake.all(|body| body.vels().is_usable() && is_point(body.pose.translation))
    }

    fn check(&self) -> Verdict {
        self.narrow_phase.contacts.check_views()?;
        self.narrow_phase.intersections.check_views()?;
        self.check_lists(&LastStep::of(self)?, Depth::Quick)
    }

    fn check_lists(&self, then: &LastStep<'_>, depth: Depth) -> Verdict {
        self.check_awake(then, depth)?;
        self.check_islands(then)?;
        self.check_contacts(then, depth)?;
        self.check_intersections(then)?;
        self.check_joints(then, depth)
    }

    /// Checks all references between the sets of a world that was loaded, and the numbers in its lists. A
    /// collision detection uses no multibodies.
    ///
    /// # Errors
    /// If a reference is wrong, or a number is not finite.
    pub fn check_world(
        &self,
        tree: &BroadPhaseBvh,
        joints: &ImpulseJointSet,
        multibodies: Option<&MultibodyJointSet>,
    ) -> Verdict {
        self.narrow_phase.contacts.check_loaded()?;
        self.narrow_phase.intersections.check_loaded()?;
        let then = LastStep::of(self)?;
        self.check_lists(&then, Depth::Full)?;
        self.islands.check_free()?;
        self.check_body_types()?;
        self.check_attachments(&then)?;
        self.check_partners()?;
        self.check_contact_data()?;
        self.check_known_joints(joints)?;
        self.check_groups(&then, multibodies)?;
        self.check_trees(tree)
    }
}
