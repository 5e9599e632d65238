//! The broad phase.

use super::ColliderSet;
use crate::dynamics::RigidBodySet;
use crate::parry::query::QueryDispatcher;
use crate::pipeline::{QueryFilter, QueryPipeline, QueryPipelineMut};
use crate::wrapper::wrapper;

wrapper! {
    /// The trees of the colliders' boxes.
    BroadPhaseBvh, engine::geometry::BroadPhaseBvh
}

/// The broad phase of a world.
pub type DefaultBroadPhase = BroadPhaseBvh;

/// Maintenance of the tree. All values select the engine's own.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub enum BvhOptimizationStrategy {
    /// Repair of degraded subtrees.
    #[default]
    SubtreeOptimizer,
    /// No repair.
    None,
}

impl BroadPhaseBvh {
    /// Empty trees. The engine selects the maintenance.
    pub fn with_optimization_strategy(_: BvhOptimizationStrategy) -> Self {
        Self::default()
    }

    /// Query access to the colliders, as of the last step.
    pub fn as_query_pipeline<'a>(
        &'a self,
        dispatcher: &'a dyn QueryDispatcher,
        bodies: &'a RigidBodySet,
        colliders: &'a ColliderSet,
        filter: QueryFilter<'a>,
    ) -> QueryPipeline<'a> {
        QueryPipeline::new(&self.0, dispatcher, bodies, colliders, filter)
    }

    /// Query access to the colliders, with mutable bodies and colliders.
    pub fn as_query_pipeline_mut<'a>(
        &'a self,
        dispatcher: &'a dyn QueryDispatcher,
        bodies: &'a mut RigidBodySet,
        colliders: &'a mut ColliderSet,
        filter: QueryFilter<'a>,
    ) -> QueryPipelineMut<'a> {
        QueryPipelineMut { tree: &self.0, dispatcher, bodies, colliders, filter }
    }
}
