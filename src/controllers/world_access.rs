//! The world for a controller that applies impulses: colliders for queries, mutable bodies.

use crate::model::body::RigidBodySet;
use crate::model::collider::ColliderSet;
use crate::model::tree::BroadPhaseBvh;
use crate::query::{QueryFilter, QueryPipeline, QueryView};
use parry::query::QueryDispatcher;

/// Colliders for queries, and mutable bodies.
///
/// Returned by [`BroadPhaseBvh::as_query_pipeline_mut`] (as of the last step), [`QueryPipeline::view_mut`]
/// (as of its last `update`) or
/// [`PhysicsWorld::query_pipeline_mut`](crate::pipeline::PhysicsWorld::query_pipeline_mut). The value only
/// borrows, so it is cheap to create.
pub struct QueryPipelineMut<'a> {
    trees: Trees<'a>,
    /// The bodies.
    pub bodies: &'a mut RigidBodySet,
    /// The colliders.
    pub colliders: &'a ColliderSet,
    /// Filter of the colliders.
    pub filter: QueryFilter<'a>,
}

/// The owner of the trees of boxes.
#[derive(Copy, Clone)]
enum Trees<'a> {
    OfStep(&'a BroadPhaseBvh, &'a dyn QueryDispatcher),
    OfQueries(&'a QueryPipeline),
}

impl core::fmt::Debug for QueryPipelineMut<'_> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("QueryPipelineMut").field("filter", &self.filter).finish_non_exhaustive()
    }
}

impl QueryPipelineMut<'_> {
    /// The same colliders for queries only.
    pub fn as_ref(&self) -> QueryView<'_> {
        match self.trees {
            Trees::OfStep(tree, dispatcher) => {
                tree.as_query_pipeline(dispatcher, self.bodies, self.colliders, self.filter)
            }
            Trees::OfQueries(queries) => queries.view(self.colliders, self.filter),
        }
    }
}

impl BroadPhaseBvh {
    /// [`Self::as_query_pipeline`] for controllers that push bodies.
    ///
    /// ```
    /// # use rapier3d::prelude::*;
    /// # let mut world = PhysicsWorld::new();
    /// let PhysicsWorld { broad_phase, narrow_phase, bodies, colliders, .. } = &mut world;
    /// let dispatcher = narrow_phase.query_dispatcher();
    /// let filter = QueryFilter::default();
    /// let queries = broad_phase.as_query_pipeline_mut(dispatcher, bodies, colliders, filter);
    /// # assert!(queries.bodies.is_empty());
    /// ```
    pub fn as_query_pipeline_mut<'a>(
        &'a self,
        dispatcher: &'a dyn QueryDispatcher,
        bodies: &'a mut RigidBodySet,
        colliders: &'a ColliderSet,
        filter: QueryFilter<'a>,
    ) -> QueryPipelineMut<'a> {
        QueryPipelineMut { trees: Trees::OfStep(self, dispatcher), bodies, colliders, filter }
    }
}

impl QueryPipeline {
    /// [`Self::view`] for controllers that push bodies.
    pub fn view_mut<'a>(
        &'a self,
        bodies: &'a mut RigidBodySet,
        colliders: &'a ColliderSet,
        filter: QueryFilter<'a>,
    ) -> QueryPipelineMut<'a> {
        QueryPipelineMut { trees: Trees::OfQueries(self), bodies, colliders, filter }
    }
}
