//! Modification of contacts by a hook of Rapier 0.32.

use super::one_way::OneWay;
use crate::dynamics::{RigidBodyHandle, RigidBodySet};
use crate::geometry::{
    ColliderHandle, ColliderSet, ContactManifold, SolverContact, to_manifold, wrap_colliders,
    write_back,
};
use crate::math::{Real, Vector};

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

impl ContactModificationContext<'_> {
    /// Makes the contact solid from one side only.
    ///
    /// The contact is solid while the normal in the frame of the first collider is within `allowed_angle`
    /// (rad) of `allowed_local_n1`. A body from another side passes until it no longer overlaps.
    pub fn update_as_oneway_platform(&mut self, allowed_local_n1: Vector, allowed_angle: Real) {
        let normal = self.manifold.local_n1;
        let state = OneWay { normal, contacts: self.solver_contacts, user_data: self.user_data };
        state.update(allowed_local_n1, allowed_angle);
    }
}

/// Calls a hook with the contacts of a manifold, and writes its edits back.
pub(super) fn modify(
    context: &mut engine::pipeline::ContactModificationContext<'_>,
    hook: impl FnOnce(&mut ContactModificationContext<'_>),
) {
    let mut manifold = to_manifold(context.manifold());
    let mut solver_contacts = core::mem::take(&mut manifold.data.solver_contacts);
    let mut normal = manifold.data.normal;
    let mut user_data = manifold.data.user_data;
    hook(&mut ContactModificationContext {
        bodies: RigidBodySet::wrap(context.bodies),
        colliders: wrap_colliders(context.colliders),
        collider1: context.collider1,
        collider2: context.collider2,
        rigid_body1: context.rigid_body1,
        rigid_body2: context.rigid_body2,
        manifold: &manifold,
        solver_contacts: &mut solver_contacts,
        normal: &mut normal,
        user_data: &mut user_data,
    });
    let material = solver_contacts.first().map(|first| (first.friction, first.restitution));
    write_back(context, &solver_contacts, material, user_data);
}
