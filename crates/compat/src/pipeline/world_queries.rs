//! Queries and contacts of a world.

use super::{PhysicsWorld, QueryFilter, QueryPipeline};
use crate::geometry::{
    Aabb, Collider, ColliderHandle, ContactPair, PointProjection, Ray, RayIntersection, Shape,
    ShapeCastHit,
};
use crate::math::{Pose, Real, Vector};
use crate::parry::query::{NonlinearRigidMotion, ShapeCastOptions};
use crate::parry::shape::FeatureId;

/// Queries and contacts, as of the last step.
impl PhysicsWorld {
    /// Query access to all colliders.
    pub fn query_pipeline(&self) -> QueryPipeline<'_> {
        self.query_pipeline_with_filter(QueryFilter::default())
    }

    /// Query access to the colliders that pass a filter.
    pub fn query_pipeline_with_filter<'a>(&'a self, filter: QueryFilter<'a>) -> QueryPipeline<'a> {
        let Self { broad_phase, narrow_phase, bodies, colliders, .. } = self;
        broad_phase.as_query_pipeline(narrow_phase.query_dispatcher(), bodies, colliders, filter)
    }

    /// The first collider that a ray hits, and the time of the hit.
    pub fn cast_ray<'a>(
        &'a self,
        ray: &Ray,
        max_toi: Real,
        solid: bool,
        filter: QueryFilter<'a>,
    ) -> Option<(ColliderHandle, Real)> {
        self.query_pipeline_with_filter(filter).cast_ray(ray, max_toi, solid)
    }

    /// The first collider that a ray hits, with the normal.
    pub fn cast_ray_and_get_normal<'a>(
        &'a self,
        ray: &Ray,
        max_toi: Real,
        solid: bool,
        filter: QueryFilter<'a>,
    ) -> Option<(ColliderHandle, RayIntersection)> {
        self.query_pipeline_with_filter(filter).cast_ray_and_get_normal(ray, max_toi, solid)
    }

    /// The first collider that a moving shape hits.
    pub fn cast_shape<'a>(
        &'a self,
        shape_pos: &Pose,
        shape_vel: Vector,
        shape: &dyn Shape,
        options: ShapeCastOptions,
        filter: QueryFilter<'a>,
    ) -> Option<(ColliderHandle, ShapeCastHit)> {
        let queries = self.query_pipeline_with_filter(filter);
        queries.cast_shape(shape_pos, shape_vel, shape, options)
    }

    /// The first collider that a moving and rotating shape hits.
    pub fn cast_shape_nonlinear<'a>(
        &'a self,
        shape_motion: &NonlinearRigidMotion,
        shape: &dyn Shape,
        start_time: Real,
        end_time: Real,
        stop_at_penetration: bool,
        filter: QueryFilter<'a>,
    ) -> Option<(ColliderHandle, ShapeCastHit)> {
        let queries = self.query_pipeline_with_filter(filter);
        queries.cast_shape_nonlinear(shape_motion, shape, start_time, end_time, stop_at_penetration)
    }

    /// The projection of a point onto the nearest collider.
    pub fn project_point<'a>(
        &'a self,
        point: Vector,
        max_dist: Real,
        solid: bool,
        filter: QueryFilter<'a>,
    ) -> Option<(ColliderHandle, PointProjection)> {
        self.query_pipeline_with_filter(filter).project_point(point, max_dist, solid)
    }

    /// The projection of a point onto the nearest collider, and the feature that it lies on.
    pub fn project_point_and_get_feature<'a>(
        &'a self,
        point: Vector,
        filter: QueryFilter<'a>,
        max_dist: Real,
    ) -> Option<(ColliderHandle, PointProjection, FeatureId)> {
        self.query_pipeline_with_filter(filter).project_point_and_get_feature(point, max_dist)
    }

    /// All colliders that a ray hits.
    pub fn intersect_ray<'a>(
        &'a self,
        ray: Ray,
        max_toi: Real,
        solid: bool,
        filter: QueryFilter<'a>,
    ) -> impl Iterator<Item = (ColliderHandle, &'a Collider, RayIntersection)> + 'a {
        self.query_pipeline_with_filter(filter).view().intersect_ray(ray, max_toi, solid)
    }

    /// All colliders that contain a point.
    pub fn intersect_point<'a>(
        &'a self,
        point: Vector,
        filter: QueryFilter<'a>,
    ) -> impl Iterator<Item = (ColliderHandle, &'a Collider)> + 'a {
        self.query_pipeline_with_filter(filter).view().intersect_point(point)
    }

    /// All colliders that a shape intersects.
    pub fn intersect_shape<'a>(
        &'a self,
        shape_pos: Pose,
        shape: &'a dyn Shape,
        filter: QueryFilter<'a>,
    ) -> impl Iterator<Item = (ColliderHandle, &'a Collider)> + 'a {
        self.query_pipeline_with_filter(filter).view().intersect_shape(shape_pos, shape)
    }

    /// All colliders whose stored boxes intersect a box.
    pub fn intersect_aabb_conservative<'a>(
        &'a self,
        aabb: Aabb,
        filter: QueryFilter<'a>,
    ) -> impl Iterator<Item = (ColliderHandle, &'a Collider)> + 'a {
        self.query_pipeline_with_filter(filter).view().intersect_aabb_conservative(aabb)
    }

    /// The contact pair of two colliders, in either order.
    pub fn contact_pair(
        &self,
        collider1: ColliderHandle,
        collider2: ColliderHandle,
    ) -> Option<&ContactPair> {
        self.narrow_phase.contact_pair(collider1, collider2)
    }

    /// All contact pairs of a collider.
    pub fn contact_pairs_with(
        &self,
        collider: ColliderHandle,
    ) -> impl Iterator<Item = &ContactPair> {
        self.narrow_phase.contact_pairs_with(collider)
    }

    /// All contact pairs.
    pub fn contact_pairs(&self) -> impl Iterator<Item = &ContactPair> {
        self.narrow_phase.contact_pairs()
    }

    /// Returns whether two colliders intersect, if one of them is a sensor.
    pub fn intersection_pair(
        &self,
        collider1: ColliderHandle,
        collider2: ColliderHandle,
    ) -> Option<bool> {
        self.narrow_phase.intersection_pair(collider1, collider2)
    }

    /// All intersection pairs of a collider.
    pub fn intersection_pairs_with(
        &self,
        collider: ColliderHandle,
    ) -> impl Iterator<Item = (ColliderHandle, &Collider, ColliderHandle, &Collider, bool)> + '_
    {
        let pairs = self.narrow_phase.intersection_pairs_with(collider);
        pairs.filter_map(|(one, other, intersecting)| {
            let [first, second] = [one, other].map(|handle| self.colliders.get(handle));
            Some((one, first?, other, second?, intersecting))
        })
    }

    /// All intersection pairs.
    pub fn intersection_pairs(
        &self,
    ) -> impl Iterator<Item = (ColliderHandle, &Collider, ColliderHandle, &Collider, bool)> + '_
    {
        self.narrow_phase.intersection_pairs().filter_map(|(one, other, intersecting)| {
            let [first, second] = [one, other].map(|handle| self.colliders.get(handle));
            Some((one, first?, other, second?, intersecting))
        })
    }
}
