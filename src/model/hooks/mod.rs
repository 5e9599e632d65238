//! Hooks: user-defined filters of pairs, and modification of contacts.
//!
//! A hook is called for pairs with at least one collider that requests it by its
//! [`ActiveHooks`](crate::model::collider::ActiveHooks); all others have no cost.

mod modification;

#[cfg(test)]
mod tests;

pub use modification::ContactModificationContext;

use crate::model::body::{RigidBodyHandle, RigidBodySet};
use crate::model::collider::{ColliderHandle, ColliderSet};
use crate::model::contact::SolverFlags;

/// The pair of a filter call.
#[derive(Copy, Clone)]
pub struct PairFilterContext<'a> {
    /// All bodies.
    pub bodies: &'a RigidBodySet,
    /// All colliders.
    pub colliders: &'a ColliderSet,
    /// The first collider.
    pub collider1: ColliderHandle,
    /// The second collider.
    pub collider2: ColliderHandle,
    /// Body of the first collider; `None` without a body.
    pub rigid_body1: Option<RigidBodyHandle>,
    /// Body of the second collider; `None` without a body.
    pub rigid_body2: Option<RigidBodyHandle>,
}

/// User-defined decisions about single pairs and contacts.
///
/// Hooks may be called from several threads at once and in any order, and again if a step is
/// [repeated](crate::model::event::EventHandler::handle_quarantine_event). The result of a hook should be a
/// function of the context alone, so that results repeat.
///
/// A panic of a hook propagates to the caller of the step, after the events found so far are sent. The world
/// stays valid: the next step does the work that this one has not done.
///
/// ```
/// # use rapier3d::prelude::*;
///
/// /// Everything is as slippery as ice.
/// struct Ice;
///
/// impl PhysicsHooks for Ice {
///     fn modify_solver_contact(&self, context: &mut ContactModificationContext) {
///         context.set_friction(0.02);
///     }
/// }
/// ```
pub trait PhysicsHooks: Send + Sync {
    /// Returns whether contacts are computed for this pair. Called for pairs with
    /// [`FILTER_CONTACT_PAIRS`](crate::model::collider::ActiveHooks::FILTER_CONTACT_PAIRS) whose boxes
    /// overlap and that nothing else filters out. A refused pair neither collides nor sends events. The
    /// default implementation returns `true`.
    fn filter_contact_pair(&self, context: &PairFilterContext) -> bool {
        let _ = context;
        true
    }

    /// Returns the solver flags of the pair; `None` refuses it. The engine calls this method only. The
    /// default implementation returns the default flags if [`Self::filter_contact_pair`] returns `true`.
    /// Without [`COMPUTE_RIGID_IMPULSES`](SolverFlags::COMPUTE_RIGID_IMPULSES), contacts are computed and
    /// reported, and the bodies pass through each other.
    fn contact_pair_flags(&self, context: &PairFilterContext) -> Option<SolverFlags> {
        self.filter_contact_pair(context).then(SolverFlags::default)
    }

    /// Returns whether the intersection is computed for this pair, one collider of which is a sensor. Called
    /// for pairs with
    /// [`FILTER_INTERSECTION_PAIR`](crate::model::collider::ActiveHooks::FILTER_INTERSECTION_PAIR) whose
    /// boxes overlap and that nothing else filters out. The default implementation returns `true`.
    fn filter_intersection_pair(&self, context: &PairFilterContext) -> bool {
        let _ = context;
        true
    }

    /// Changes the contacts of one manifold before they are solved. Called in every step for touching pairs
    /// with [`MODIFY_SOLVER_CONTACTS`](crate::model::collider::ActiveHooks::MODIFY_SOLVER_CONTACTS). The
    /// default implementation changes nothing.
    fn modify_solver_contact(&self, context: &mut ContactModificationContext) {
        let _ = context;
    }
}

/// Returns whether the filter lets the solver push the pair.
pub(crate) fn lets_solver_push(hooks: &dyn PhysicsHooks, pair: &PairFilterContext<'_>) -> bool {
    let flags = hooks.contact_pair_flags(pair);
    flags.is_some_and(|flags| flags.contains(SolverFlags::COMPUTE_RIGID_IMPULSES))
}

/// Admits all pairs unchanged.
impl PhysicsHooks for () {}

/// Admits all pairs unchanged.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct DefaultHooks;

impl PhysicsHooks for DefaultHooks {}
