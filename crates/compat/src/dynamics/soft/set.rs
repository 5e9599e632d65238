//! The set of soft bodies: always empty.

use super::{Blade, SoftBody, SoftBodyBuilder, SoftBodyTearEvent, SoftClusterRemoval};
use crate::dynamics::{
    ImpulseJointSet, IntegrationParameters, IslandManager, MultibodyJointSet, RigidBodySet,
};
use crate::geometry::ColliderSet;
use core::ops::{Index, IndexMut};
use engine::dynamics::SoftBodyHandle;

/// The soft bodies of a world: none.
#[derive(Clone, Debug, Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct SoftBodySet;

impl SoftBodySet {
    /// The empty set.
    pub fn new() -> Self {
        Self
    }

    /// Number of soft bodies: 0.
    pub fn len(&self) -> usize {
        0
    }

    /// Returns whether the set is empty: yes.
    pub fn is_empty(&self) -> bool {
        true
    }

    /// Returns whether a soft body exists: no.
    pub fn contains(&self, _handle: SoftBodyHandle) -> bool {
        false
    }

    /// Logs an error, because the engine has no soft bodies, and returns an invalid handle.
    pub fn insert(
        &mut self,
        soft_body_builder: impl Into<SoftBodyBuilder>,
        _bodies: &mut RigidBodySet,
        _colliders: &mut ColliderSet,
    ) -> SoftBodyHandle {
        let particles = soft_body_builder.into().positions.len();
        log::error!("a soft body of {particles} particles is ignored: the engine has none");
        SoftBodyHandle::invalid()
    }

    /// Removes nothing.
    pub fn remove(
        &mut self,
        _handle: SoftBodyHandle,
        _islands: &mut IslandManager,
        _bodies: &mut RigidBodySet,
        _colliders: &mut ColliderSet,
        _impulse_joints: &mut ImpulseJointSet,
        _multibody_joints: &mut MultibodyJointSet,
    ) -> Option<SoftBody> {
        None
    }

    /// A soft body: none.
    pub fn get(&self, _handle: SoftBodyHandle) -> Option<&SoftBody> {
        None
    }

    /// Mutable access to a soft body: none.
    pub fn get_mut(&mut self, _handle: SoftBodyHandle) -> Option<&mut SoftBody> {
        None
    }

    /// All soft bodies: none.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = (SoftBodyHandle, &SoftBody)> {
        core::iter::empty()
    }

    /// All soft bodies, mutably: none.
    pub fn iter_mut(&mut self) -> impl ExactSizeIterator<Item = (SoftBodyHandle, &mut SoftBody)> {
        core::iter::empty()
    }

    /// Adds no cluster.
    pub fn add_cluster(
        &mut self,
        _handle: SoftBodyHandle,
        _particles: &[u32],
        _bodies: &mut RigidBodySet,
        _colliders: &mut ColliderSet,
    ) -> Option<u32> {
        None
    }

    /// Removes no cluster.
    #[expect(clippy::too_many_arguments, reason = "the signature of Rapier 0.36")]
    pub fn remove_cluster(
        &mut self,
        _handle: SoftBodyHandle,
        _cluster: u32,
        _islands: &mut IslandManager,
        _bodies: &mut RigidBodySet,
        _colliders: &mut ColliderSet,
        _impulse_joints: &mut ImpulseJointSet,
        _multibody_joints: &mut MultibodyJointSet,
    ) -> Option<SoftClusterRemoval> {
        None
    }

    /// Tears nothing.
    #[expect(clippy::too_many_arguments, reason = "the signature of Rapier 0.36")]
    pub fn tear(
        &mut self,
        _handle: SoftBodyHandle,
        _edges: &[u32],
        _cells: &[u32],
        _islands: &mut IslandManager,
        _bodies: &mut RigidBodySet,
        _colliders: &mut ColliderSet,
        _impulse_joints: &mut ImpulseJointSet,
        _multibody_joints: &mut MultibodyJointSet,
    ) -> Option<SoftBodyTearEvent> {
        None
    }

    /// Cuts nothing.
    #[expect(clippy::too_many_arguments, reason = "the signature of Rapier 0.36")]
    pub fn cut(
        &mut self,
        _handle: SoftBodyHandle,
        _blade: &Blade,
        _islands: &mut IslandManager,
        _bodies: &mut RigidBodySet,
        _colliders: &mut ColliderSet,
        _impulse_joints: &mut ImpulseJointSet,
        _multibody_joints: &mut MultibodyJointSet,
    ) -> Option<SoftBodyTearEvent> {
        None
    }

    /// Wakes nothing.
    pub fn wake_up(&mut self, _handle: SoftBodyHandle, _bodies: &mut RigidBodySet, _strong: bool) {}

    /// Moves nothing.
    pub fn sync_particle_positions(
        &mut self,
        _bodies: &mut RigidBodySet,
        _colliders: &mut ColliderSet,
        _params: &IntegrationParameters,
        _quarantined: &mut Vec<SoftBodyHandle>,
    ) {
    }
}

impl Index<SoftBodyHandle> for SoftBodySet {
    type Output = SoftBody;

    fn index(&self, handle: SoftBodyHandle) -> &SoftBody {
        panic!("no soft body has the handle {handle:?}: the engine has none")
    }
}

impl IndexMut<SoftBodyHandle> for SoftBodySet {
    fn index_mut(&mut self, handle: SoftBodyHandle) -> &mut SoftBody {
        panic!("no soft body has the handle {handle:?}: the engine has none")
    }
}
