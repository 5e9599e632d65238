//! The set of bodies.

use super::{ImpulseJointSet, IslandManager, MultibodyJointSet};
use crate::geometry::ColliderSet;
use crate::wrapper::wrapper;
use engine::dynamics::{RigidBody, RigidBodyHandle};

wrapper! {
    /// All bodies of a world.
    RigidBodySet, engine::dynamics::RigidBodySet
}

impl RigidBodySet {
    /// A borrowed set of the engine as this type.
    pub(crate) fn wrap(bodies: &engine::dynamics::RigidBodySet) -> &Self {
        // SAFETY: the wrapper is transparent, so both types have the same layout and validity.
        unsafe { &*core::ptr::from_ref(bodies).cast() }
    }

    /// An empty set with space for `capacity` bodies.
    pub fn with_capacity(capacity: usize) -> Self {
        Self(engine::dynamics::RigidBodySet::with_capacity(capacity))
    }

    /// Removes a body and its joints at once. `None` if the handle is stale.
    ///
    /// Its colliders are removed too, or they are detached and stay where they are.
    #[cfg_attr(
        rapier036,
        expect(clippy::too_many_arguments, reason = "the signature of Rapier 0.36")
    )]
    pub fn remove(
        &mut self,
        handle: RigidBodyHandle,
        islands: &mut IslandManager,
        colliders: &mut ColliderSet,
        impulse_joints: &mut ImpulseJointSet,
        multibody_joints: &mut MultibodyJointSet,
        #[cfg(rapier036)] _soft_bodies: &mut super::SoftBodySet,
        remove_attached_colliders: bool,
    ) -> Option<RigidBody> {
        let attached = self.0.get(handle)?.colliders().to_vec();
        impulse_joints.remove_joints_attached_to_rigid_body(handle);
        multibody_joints.remove_joints_attached_to_rigid_body(handle);
        let colliders: &mut engine::geometry::ColliderSet = colliders;
        for collider in attached {
            if remove_attached_colliders {
                colliders.remove(collider, islands, &mut self.0, true);
            } else {
                colliders.set_parent(collider, None, &mut self.0);
            }
        }
        self.0.remove(handle)
    }
}
