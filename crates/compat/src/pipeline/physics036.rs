//! Threads and disabled bodies in Rapier 0.36.

use crate::dynamics::{RigidBodyHandle, SoftBodyHandle};
use crate::geometry::ColliderHandle;

/// The bodies that the last step disabled because of an unusable number.
#[derive(Clone, Debug, Default)]
pub struct Quarantine {
    pub(super) bodies: Vec<RigidBodyHandle>,
}

impl Quarantine {
    /// The bodies.
    pub fn bodies(&self) -> &[RigidBodyHandle] {
        &self.bodies
    }

    /// Returns whether the step disabled nothing.
    pub fn is_empty(&self) -> bool {
        self.bodies.is_empty()
    }

    /// Colliders without a body: none, the engine refuses such values when they are set.
    pub fn colliders(&self) -> &[ColliderHandle] {
        &[]
    }

    /// Soft bodies: none.
    pub fn soft_bodies(&self) -> &[SoftBodyHandle] {
        &[]
    }
}
