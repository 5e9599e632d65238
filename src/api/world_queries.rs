//! Queries of a world as of its last step. [`QueryView`] documents each in detail.

use super::world::PhysicsWorld;
use crate::controllers::QueryPipelineMut;
use crate::dim::math::{Pose, Real, Vector};
use crate::model::collider::{Collider, ColliderHandle};
use crate::query::{QueryFilter, QueryView};
use parry::bounding_volume::Aabb;
use parry::query::{
    NonlinearRigidMotion, PointProjection, Ray, RayIntersection, ShapeCastHit, ShapeCastOptions,
};
use parry::shape::{FeatureId, Shape};

/// Queries. Boxes are those of the last step: see [`Self::query_pipeline`].
///
/// ```
/// # use rapier3d::prelude::*;
/// let mut world = PhysicsWorld::new();
/// let (_, ball) = world.insert(RigidBodyBuilder::fixed(), ColliderBuilder::ball(1.0));
/// world.step();
/// let ray = Ray::new(Vector::new(0.0, 5.0, 0.0), -Vector::Y);
/// let hit = world.cast_ray(&ray, 100.0, true, QueryFilter::default());
/// assert_eq!(hit, Some((ball, 4.0)));
/// ```
impl PhysicsWorld {
    /// Queries of all colliders.
    ///
    /// The queries use the boxes of the last step. A collider that was inserted since is not found, and a
    /// moved collider is found only within its old box. A separate
    /// [`QueryPipeline`](crate::query::QueryPipeline) takes such changes into account at once.
    pub fn query_pipeline(&self) -> QueryView<'_> {
        self.query_pipeline_with_filter(QueryFilter::default())
    }

    /// Queries of the colliders that pass a filter.
    pub fn query_pipeline_with_filter<'a>(&'a self, filter: QueryFilter<'a>) -> QueryView<'a> {
        let dispatcher = self.narrow_phase.query_dispatcher();
        self.broad_phase.as_query_pipeline(dispatcher, &self.bodies, &self.colliders, filter)
    }

    /// Queries of the colliders that pass a filter, with mutable bodies: the input of controllers.
    pub fn query_pipeline_mut<'a>(&'a mut self, filter: QueryFilter<'a>) -> QueryPipelineMut<'a> {
        let Self { broad_phase, narrow_phase, bodies, colliders, .. } = self;
        let dispatcher = narrow_phase.query_dispatcher();
        broad_phase.as_query_pipeline_mut(dispatcher, bodies, colliders, filter)
    }

    /// The first collider that a ray hits, and the time of the hit: see [`QueryView::cast_ray`].
    pub fn cast_ray(
        &self,
        ray: &Ray,
        max_toi: Real,
        solid: bool,
        filter: QueryFilter<'_>,
    ) -> Option<(ColliderHandle, Real)> {
        self.query_pipeline_with_filter(filter).cast_ray(ray, max_toi, solid)
    }

    /// The first collider that a ray hits, with the time of the hit and the normal there: see
    /// [`QueryView::cast_ray_and_get_normal`].
    pub fn cast_ray_and_get_normal(
        &self,
        ray: &Ray,
        max_toi: Real,
        solid: bool,
        filter: QueryFilter<'_>,
    ) -> Option<(ColliderHandle, RayIntersection)> {
        self.query_pipeline_with_filter(filter).cast_ray_and_get_normal(ray, max_toi, solid)
    }

    /// All colliders that a ray hits: see [`QueryView::intersect_ray`].
    pub fn intersect_ray<'a>(
        &'a self,
        ray: Ray,
        max_toi: Real,
        solid: bool,
        filter: QueryFilter<'a>,
    ) -> impl Iterator<Item = (ColliderHandle, &'a Collider, RayIntersection)> {
        self.query_pipeline_with_filter(filter).intersect_ray(ray, max_toi, solid)
    }

    /// The first collider in the path of a shape: see [`QueryView::cast_shape`].
    pub fn cast_shape(
        &self,
        shape_pos: &Pose,
        shape_vel: Vector,
        shape: &dyn Shape,
        options: ShapeCastOptions,
        filter: QueryFilter<'_>,
    ) -> Option<(ColliderHandle, ShapeCastHit)> {
        self.query_pipeline_with_filter(filter).cast_shape(shape_pos, shape_vel, shape, options)
    }

    /// The first collider in the path of a rotating shape: see [`QueryView::cast_shape_nonlinear`].
    pub fn cast_shape_nonlinear(
        &self,
        shape_motion: &NonlinearRigidMotion,
        shape: &dyn Shape,
        start_time: Real,
        end_time: Real,
        stop_at_penetration: bool,
        filter: QueryFilter<'_>,
    ) -> Option<(ColliderHandle, ShapeCastHit)> {
        let queries = self.query_pipeline_with_filter(filter);
        queries.cast_shape_nonlinear(shape_motion, shape, start_time, end_time, stop_at_penetration)
    }

    /// The collider that is nearest to a point, and the nearest point on it: see
    /// [`QueryView::project_point`].
    pub fn project_point(
        &self,
        point: Vector,
        max_distance: Real,
        solid: bool,
        filter: QueryFilter<'_>,
    ) -> Option<(ColliderHandle, PointProjection)> {
        self.query_pipeline_with_filter(filter).project_point(point, max_distance, solid)
    }

    /// The collider whose surface is nearest to a point, the nearest point on it and the feature there: see
    /// [`QueryView::project_point_and_get_feature`].
    pub fn project_point_and_get_feature(
        &self,
        point: Vector,
        filter: QueryFilter<'_>,
        max_distance: Real,
    ) -> Option<(ColliderHandle, PointProjection, FeatureId)> {
        self.query_pipeline_with_filter(filter).project_point_and_get_feature(point, max_distance)
    }

    /// All colliders that contain a point: see [`QueryView::intersect_point`].
    pub fn intersect_point<'a>(
        &'a self,
        point: Vector,
        filter: QueryFilter<'a>,
    ) -> impl Iterator<Item = (ColliderHandle, &'a Collider)> {
        self.query_pipeline_with_filter(filter).intersect_point(point)
    }

    /// All colliders that a shape touches: see [`QueryView::intersect_shape`].
    pub fn intersect_shape<'a>(
        &'a self,
        shape_pos: Pose,
        shape: &'a dyn Shape,
        filter: QueryFilter<'a>,
    ) -> impl Iterator<Item = (ColliderHandle, &'a Collider)> {
        self.query_pipeline_with_filter(filter).intersect_shape(shape_pos, shape)
    }

    /// All colliders whose boxes overlap a box: see [`QueryView::intersect_aabb_conservative`].
    pub fn intersect_aabb_conservative<'a>(
        &'a self,
        aabb: Aabb,
        filter: QueryFilter<'a>,
    ) -> impl Iterator<Item = (ColliderHandle, &'a Collider)> {
        self.query_pipeline_with_filter(filter).intersect_aabb_conservative(aabb)
    }
}
