//! The broad phase.

use super::ColliderSet;
use crate::dynamics::RigidBodySet;
use crate::parry::query::QueryDispatcher;
use crate::pipeline::{QueryFilter, QueryPipeline, QueryPipelineMut};
use crate::wrapper::forward;

/// The trees of the colliders' boxes.
#[derive(Clone, Debug, Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct BroadPhaseBvh {
    engine: engine::geometry::BroadPhaseBvh,
    /// The boxes of all colliders as one tree, from the first access after a step on.
    #[cfg(rapier036)]
    #[cfg_attr(feature = "serde-serialize", serde(skip))]
    tree: std::sync::OnceLock<crate::parry::partitioning::Bvh>,
    /// No effect: the engine finds the changes itself.
    #[cfg(rapier036)]
    pub adaptive_change_detection_margin: bool,
}

forward!(BroadPhaseBvh, engine, engine::geometry::BroadPhaseBvh);

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
    /// Empty trees.
    pub fn new() -> Self {
        Self::default()
    }

    /// Mutable access for a step.
    pub(crate) fn begin_step(&mut self) -> &mut engine::geometry::BroadPhaseBvh {
        #[cfg(rapier036)]
        self.tree.take();
        &mut self.engine
    }

    /// The boxes of all colliders as one tree. The number of a leaf is the slot of its collider.
    #[cfg(rapier036)]
    fn tree(&self, colliders: &ColliderSet) -> &crate::parry::partitioning::Bvh {
        use crate::parry::partitioning::{Bvh, BvhBuildStrategy};
        self.tree.get_or_init(|| {
            let slot = |handle: crate::geometry::ColliderHandle| handle.into_raw_parts().0;
            let enabled = colliders.iter_enabled();
            let boxes: Vec<_> = enabled.map(|(at, it)| (slot(at), it.compute_aabb())).collect();
            // The construction from a list numbers the leaves of the smallest trees itself.
            if boxes.len() > 2 {
                let leaves = boxes.into_iter().map(|(slot, aabb)| (slot as usize, aabb));
                return Bvh::from_iter(BvhBuildStrategy::Binned, leaves);
            }
            let mut tree = Bvh::new();
            boxes.into_iter().for_each(|(slot, aabb)| tree.insert(aabb, slot));
            tree
        })
    }

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
        QueryPipeline {
            tree: &self.engine,
            #[cfg(rapier036)]
            bvh: self.tree(colliders),
            dispatcher,
            bodies,
            colliders,
            filter,
        }
    }

    /// Query access to the colliders, with mutable bodies and colliders.
    pub fn as_query_pipeline_mut<'a>(
        &'a self,
        dispatcher: &'a dyn QueryDispatcher,
        bodies: &'a mut RigidBodySet,
        colliders: &'a mut ColliderSet,
        filter: QueryFilter<'a>,
    ) -> QueryPipelineMut<'a> {
        QueryPipelineMut {
            tree: &self.engine,
            #[cfg(rapier036)]
            bvh: self.tree(colliders),
            dispatcher,
            bodies,
            colliders,
            filter,
        }
    }
}
