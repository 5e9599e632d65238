//! The set of colliders, with the soft bodies in the signatures of Rapier 0.36.

use super::{Collider, ColliderHandle};
use crate::dynamics::{
    IslandManager, RigidBodyHandle, RigidBodySet, SoftBindingError, SoftBodySet, SoftMeshBinding,
};
use crate::wrapper::wrapper;

wrapper! {
    /// All colliders of a world.
    ColliderSet, engine::geometry::ColliderSet
}

impl ColliderSet {
    /// A borrowed set of the engine as this type.
    pub(crate) fn wrap(colliders: &engine::geometry::ColliderSet) -> &Self {
        // SAFETY: the wrapper is transparent, so both types have the same layout and validity.
        unsafe { &*core::ptr::from_ref(colliders).cast() }
    }

    /// An empty set with space for `capacity` colliders.
    pub fn with_capacity(capacity: usize) -> Self {
        Self(engine::geometry::ColliderSet::with_capacity(capacity))
    }

    /// Removes a collider. `None` if the handle is stale. Its body wakes if `wake_up` is `true`.
    pub fn remove(
        &mut self,
        handle: ColliderHandle,
        islands: &mut IslandManager,
        bodies: &mut RigidBodySet,
        _soft_bodies: &mut SoftBodySet,
        wake_up: bool,
    ) -> Option<Collider> {
        self.0.remove(handle, islands, bodies, wake_up)
    }

    /// Inserts nothing: the engine has no soft bodies.
    ///
    /// # Errors
    /// Always, because no body is a part of a soft body.
    pub fn insert_deformable(
        &mut self,
        _coll: impl Into<Collider>,
        _binding: SoftMeshBinding,
        _parent_handle: RigidBodyHandle,
        _bodies: &mut RigidBodySet,
        _soft_bodies: &mut SoftBodySet,
    ) -> Result<ColliderHandle, SoftBindingError> {
        Err(SoftBindingError::NotAClusterProxy)
    }
}

impl core::ops::Index<ColliderHandle> for ColliderSet {
    type Output = Collider;

    fn index(&self, handle: ColliderHandle) -> &Collider {
        &self.0[handle]
    }
}

impl core::ops::IndexMut<ColliderHandle> for ColliderSet {
    fn index_mut(&mut self, handle: ColliderHandle) -> &mut Collider {
        &mut self.0[handle]
    }
}
