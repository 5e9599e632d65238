//! Hooks: user-defined filters of pairs.

use super::modification::{ContactModificationContext, modify};
use crate::dynamics::{RigidBodyHandle, RigidBodySet};
use crate::geometry::{ColliderHandle, ColliderSet, SolverFlags, wrap_colliders};

/// The pair of a filter call.
pub struct PairFilterContext<'a> {
    /// All bodies.
    pub bodies: &'a RigidBodySet,
    /// All colliders.
    pub colliders: &'a ColliderSet,
    /// The first collider.
    pub collider1: ColliderHandle,
    /// The second collider.
    pub collider2: ColliderHandle,
    /// Body of the first collider.
    pub rigid_body1: Option<RigidBodyHandle>,
    /// Body of the second collider.
    pub rigid_body2: Option<RigidBodyHandle>,
}

/// User-defined decisions about pairs and contacts.
pub trait PhysicsHooks: Send + Sync {
    /// The solver flags of a pair; `None` refuses it.
    fn filter_contact_pair(&self, _context: &PairFilterContext) -> Option<SolverFlags> {
        Some(SolverFlags::default())
    }

    /// Returns whether the intersection of a pair is computed.
    fn filter_intersection_pair(&self, _context: &PairFilterContext) -> bool {
        true
    }

    /// Changes the contacts of a manifold.
    fn modify_solver_contacts(&self, _context: &mut ContactModificationContext) {}
}

/// Admits all pairs unchanged.
impl PhysicsHooks for () {}

/// Hooks for the engine.
pub(super) struct Hooks<'a>(pub &'a dyn PhysicsHooks);

fn to_context<'a>(context: &engine::pipeline::PairFilterContext<'a>) -> PairFilterContext<'a> {
    PairFilterContext {
        bodies: RigidBodySet::wrap(context.bodies),
        colliders: wrap_colliders(context.colliders),
        collider1: context.collider1,
        collider2: context.collider2,
        rigid_body1: context.rigid_body1,
        rigid_body2: context.rigid_body2,
    }
}

impl engine::pipeline::PhysicsHooks for Hooks<'_> {
    fn contact_pair_flags(
        &self,
        context: &engine::pipeline::PairFilterContext<'_>,
    ) -> Option<engine::geometry::SolverFlags> {
        let flags = self.0.filter_contact_pair(&to_context(context))?;
        Some(engine::geometry::SolverFlags::from_bits_truncate(flags.bits()))
    }

    fn filter_intersection_pair(&self, context: &engine::pipeline::PairFilterContext<'_>) -> bool {
        self.0.filter_intersection_pair(&to_context(context))
    }

    fn modify_solver_contact(
        &self,
        context: &mut engine::pipeline::ContactModificationContext<'_>,
    ) {
        modify(context, |context| self.0.modify_solver_contacts(context));
    }
}
