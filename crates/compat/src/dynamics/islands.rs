//! Islands of connected bodies.

use crate::wrapper::wrapper;
use engine::dynamics::RigidBodyHandle;

wrapper! {
    /// Islands of connected bodies, and their sleep.
    IslandManager, engine::dynamics::IslandManager
}

impl IslandManager {
    /// The bodies that are awake and not fixed.
    pub fn active_bodies(&self) -> impl Iterator<Item = RigidBodyHandle> + '_ {
        self.0.active_bodies().iter().copied()
    }
}
