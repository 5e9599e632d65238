//! Hooks: user-defined filters of pairs, and modification of contacts.

use crate::dynamics::{RigidBodyHandle, RigidBodySet};
use crate::geometry::{
    ColliderHandle, ColliderSet, ContactManifold, SolverContact, SolverFlags, to_manifold,
    write_back,
};
use crate::math::{Real, Vector};

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

/// Mutable access to the contacts of a manifold before they are solved.
pub struct ContactModificationContext<'a> {
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
    /// The manifold before the hook, without its solver contacts: the next field has them.
    pub manifold: &'a ContactManifold,
    /// The contacts that are solved: a hook may remove contacts and change their material.
    pub solver_contacts: &'a mut Vec<SolverContact>,
    /// Unit normal in world space, from the first collider to the second. Writes have no effect.
    pub normal: &'a mut Vector,
    /// Number that persists from step to step.
    pub user_data: &'a mut u32,
}

/// User data of a one-way platform.
mod oneway {
    pub const UNDECIDED: u32 = 0;
    pub const SOLID: u32 = 1;
    pub const PASSING: u32 = 2;
}

impl ContactModificationContext<'_> {
    /// Makes the contact solid from one side only.
    ///
    /// The contact is solid while the normal in the frame of the first collider is within `allowed_angle`
    /// (rad) of `allowed_local_n1`. A body from another side passes until it no longer overlaps.
    pub fn update_as_oneway_platform(&mut self, allowed_local_n1: Vector, allowed_angle: Real) {
        let cos = self.manifold.local_n1.dot(allowed_local_n1);
        let from_solid_side = cos >= allowed_angle.cos();
        let apart = self.solver_contacts.iter().all(|contact| contact.dist > 0.0);
        let is_touching = !self.solver_contacts.is_empty();
        *self.user_data = match *self.user_data {
            oneway::SOLID if is_touching => oneway::SOLID,
            oneway::SOLID => oneway::UNDECIDED,
            oneway::PASSING if !(from_solid_side && apart) => oneway::PASSING,
            _ if from_solid_side => oneway::SOLID,
            _ => oneway::PASSING,
        };
        if *self.user_data == oneway::PASSING {
            self.solver_contacts.clear();
        }
    }
}

/// User-defined decisions about pairs and contacts.
pub trait PhysicsHooks: Send + Sync {
    /// The solver flags of a pair; `None` refuses it.
    fn filter_contact_pair(&self, _context: &PairFilterContext) -> Option<SolverFlags> {
        Some(SolverFlags::COMPUTE_IMPULSES)
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
        colliders: context.colliders,
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
        let mut manifold = to_manifold(context.manifold());
        let mut solver_contacts = core::mem::take(&mut manifold.data.solver_contacts);
        let mut normal = manifold.data.normal;
        let mut user_data = manifold.data.user_data;
        self.0.modify_solver_contacts(&mut ContactModificationContext {
            bodies: RigidBodySet::wrap(context.bodies),
            colliders: context.colliders,
            collider1: context.collider1,
            collider2: context.collider2,
            rigid_body1: context.rigid_body1,
            rigid_body2: context.rigid_body2,
            manifold: &manifold,
            solver_contacts: &mut solver_contacts,
            normal: &mut normal,
            user_data: &mut user_data,
        });
        write_back(context, &solver_contacts, user_data);
    }
}
