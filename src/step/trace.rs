//! Hashes of the world between the stages of a step, to find the stage in which two runs begin to differ.

use crate::model::state_hash::{WorldSets, world_hash};

/// A part of a step after which
/// [`PhysicsPipeline::stage_hashes`](crate::pipeline::PhysicsPipeline::stage_hashes) contains a hash of the
/// world.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum StepStage {
    /// The user's edits are applied.
    UserChanges,
    /// Pairs, contacts and islands are those of the present poses.
    CollisionDetection,
    /// The bodies have new velocities and poses.
    Solver,
    /// Fast bodies are stopped at their first impact, and colliders follow their bodies.
    Finalize,
    /// Bodies at rest sleep.
    Sleep,
}

/// The hashes of the last step.
#[derive(Default)]
pub(super) struct StageTrace {
    enabled: bool,
    hashes: Vec<(StepStage, u64)>,
}

impl StageTrace {
    pub fn enable(&mut self, enabled: bool) {
        self.enabled = enabled;
        self.clear();
    }

    pub fn clear(&mut self) {
        self.hashes.clear();
    }

    /// Adds the hash of a world if the trace is enabled.
    pub fn add(&mut self, stage: StepStage, world: &WorldSets<'_>) {
        if self.enabled {
            self.hashes.push((stage, world_hash(world)));
        }
    }

    pub fn hashes(&self) -> &[(StepStage, u64)] {
        &self.hashes
    }
}
