//! Trees of boxes and their colliders.

use super::filter::QueryFilter;
use crate::base::bvh::Probe;
use crate::base::guard::guarded;
use crate::collide::Dispatcher;
use crate::dim::math::Real;
use crate::model::body::RigidBodySet;
use crate::model::collider::{Collider, ColliderHandle, ColliderSet};
use crate::model::tree::{AllBoxes, BroadPhaseBvh};
use parry::query::{QueryDispatcher, Unsupported};

/// Colliders for queries: borrowed trees of boxes, the colliders in them, and a filter.
///
/// [`BroadPhaseBvh::as_query_pipeline`] and [`QueryPipeline::view`](super::QueryPipeline::view) return it. A
/// view only borrows, so it is cheap to create.
#[derive(Copy, Clone)]
pub struct QueryView<'a> {
    trees: AllBoxes<'a>,
    /// Algorithms for pairs of shapes.
    pub dispatcher: &'a dyn QueryDispatcher,
    /// The colliders.
    pub colliders: &'a ColliderSet,
    /// Filter of the colliders.
    pub filter: QueryFilter<'a>,
}

impl core::fmt::Debug for QueryView<'_> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("QueryView").field("filter", &self.filter).finish_non_exhaustive()
    }
}

impl BroadPhaseBvh {
    /// Query access to its colliders, without a separate tree.
    ///
    /// Boxes are those of the last step. A collider that was inserted or moved since is found only within the
    /// box that its slot had then. [`QueryPipeline`](super::QueryPipeline) takes such changes into account
    /// with its next update.
    ///
    /// ```
    /// # use rapier3d::prelude::*;
    /// # let mut world = PhysicsWorld::new();
    /// # world.insert(RigidBodyBuilder::fixed(), ColliderBuilder::ball(1.0));
    /// # world.step();
    /// let dispatcher = world.narrow_phase.query_dispatcher();
    /// let queries = world.broad_phase.as_query_pipeline(
    ///     dispatcher,
    ///     &world.bodies,
    ///     &world.colliders,
    ///     QueryFilter::default(),
    /// );
    /// let ray = Ray::new(Vector::new(0.0, 5.0, 0.0), -Vector::Y);
    /// assert_eq!(queries.cast_ray(&ray, 100.0, true).map(|(_, time)| time), Some(4.0));
    /// ```
    pub fn as_query_pipeline<'a>(
        &'a self,
        dispatcher: &'a dyn QueryDispatcher,
        _bodies: &'a RigidBodySet,
        colliders: &'a ColliderSet,
        filter: QueryFilter<'a>,
    ) -> QueryView<'a> {
        QueryView::new(self.all_boxes(), dispatcher, colliders, filter)
    }
}

impl<'a> QueryView<'a> {
    /// Leaves of the trees are slots of the colliders.
    pub(super) fn new(
        trees: AllBoxes<'a>,
        dispatcher: &'a dyn QueryDispatcher,
        colliders: &'a ColliderSet,
        filter: QueryFilter<'a>,
    ) -> Self {
        Self { trees, dispatcher, colliders, filter }
    }

    /// The same colliders with another filter.
    #[must_use]
    pub fn with_filter(self, filter: QueryFilter<'a>) -> Self {
        Self { filter, ..self }
    }

    /// The result of a query of two shapes. The engine's own dispatcher replaces one that does not support
    /// the two shapes, or panics: no pair is silently apart.
    pub(super) fn ask<T>(
        &self,
        query: impl Fn(&dyn QueryDispatcher) -> Result<T, Unsupported>,
    ) -> Option<T> {
        let ask = |dispatcher: &dyn QueryDispatcher| guarded(|| query(dispatcher))?.ok();
        ask(self.dispatcher).or_else(|| ask(&Dispatcher))
    }

    pub(super) fn trees(&self) -> AllBoxes<'a> {
        self.trees
    }

    /// The collider at a slot; `None` if the filter excludes the collider.
    pub(super) fn candidate(&self, slot: u32) -> Option<(ColliderHandle, &'a Collider)> {
        let (handle, collider) = self.colliders.at_slot(slot)?;
        (collider.is_enabled() && self.filter.test(handle, collider)).then_some((handle, collider))
    }

    /// All colliders that pass the filter and whose boxes a probe finds within `reach`.
    pub(super) fn candidates<P: Probe + 'a>(
        self,
        probe: P,
        reach: Real,
    ) -> impl Iterator<Item = (ColliderHandle, &'a Collider)> {
        let slots = self.trees.into_iter().flat_map(move |tree| tree.leaves(probe, reach));
        slots.filter_map(move |slot| self.candidate(slot))
    }
}
