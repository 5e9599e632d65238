//! Ray casts, shape casts, projections and overlap tests.

use super::QueryFilterFlags;
use crate::dynamics::{RigidBodyHandle, RigidBodySet};
use crate::geometry::{
    Aabb, Collider, ColliderHandle, ColliderSet, InteractionGroups, PointProjection, Ray,
    RayIntersection, Shape, ShapeCastHit,
};
use crate::math::{Pose, Real, Vector};
use crate::parry::query::{NonlinearRigidMotion, QueryDispatcher, ShapeCastOptions};
use crate::parry::shape::FeatureId;
use engine::geometry::BroadPhaseBvh;
use engine::pipeline::QueryView;

/// A condition of a query: returns whether a collider may be found.
type Predicate<'a> = &'a dyn Fn(ColliderHandle, &Collider) -> bool;

/// Filter of a query: the conjunction of its conditions.
#[derive(Copy, Clone, Default)]
pub struct QueryFilter<'a> {
    /// Excluded kinds of colliders.
    pub flags: QueryFilterFlags,
    /// Groups that a collider must interact with.
    pub groups: Option<InteractionGroups>,
    /// One excluded collider.
    pub exclude_collider: Option<ColliderHandle>,
    /// A body whose colliders are excluded.
    pub exclude_rigid_body: Option<RigidBodyHandle>,
    /// User-defined condition.
    pub predicate: Option<Predicate<'a>>,
}

impl From<QueryFilterFlags> for QueryFilter<'_> {
    fn from(flags: QueryFilterFlags) -> Self {
        Self { flags, ..Self::default() }
    }
}

impl From<InteractionGroups> for QueryFilter<'_> {
    fn from(groups: InteractionGroups) -> Self {
        Self { groups: Some(groups), ..Self::default() }
    }
}

impl<'a> From<QueryFilter<'a>> for engine::pipeline::QueryFilter<'a> {
    fn from(filter: QueryFilter<'a>) -> Self {
        let QueryFilter { flags, groups, exclude_collider, exclude_rigid_body, predicate } = filter;
        let flags = flags.into();
        Self { flags, groups, exclude_collider, exclude_rigid_body, predicate }
    }
}

impl<'a> QueryFilter<'a> {
    /// A filter that excludes nothing.
    pub fn new() -> Self {
        Self::default()
    }

    /// A filter that excludes colliders of fixed bodies, and colliders without a body.
    pub fn exclude_fixed() -> Self {
        QueryFilterFlags::EXCLUDE_FIXED.into()
    }

    /// A filter that excludes colliders of kinematic bodies.
    pub fn exclude_kinematic() -> Self {
        QueryFilterFlags::EXCLUDE_KINEMATIC.into()
    }

    /// A filter that excludes colliders of dynamic bodies.
    pub fn exclude_dynamic() -> Self {
        QueryFilterFlags::EXCLUDE_DYNAMIC.into()
    }

    /// A filter that admits colliders of dynamic bodies only.
    pub fn only_dynamic() -> Self {
        QueryFilterFlags::ONLY_DYNAMIC.into()
    }

    /// A filter that admits colliders of kinematic bodies only.
    pub fn only_kinematic() -> Self {
        QueryFilterFlags::ONLY_KINEMATIC.into()
    }

    /// A filter that admits colliders of fixed bodies, and colliders without a body, only.
    pub fn only_fixed() -> Self {
        QueryFilterFlags::ONLY_FIXED.into()
    }

    /// Excludes sensors too.
    #[must_use]
    pub fn exclude_sensors(mut self) -> Self {
        self.flags |= QueryFilterFlags::EXCLUDE_SENSORS;
        self
    }

    /// Excludes all colliders that are not sensors too.
    #[must_use]
    pub fn exclude_solids(mut self) -> Self {
        self.flags |= QueryFilterFlags::EXCLUDE_SOLIDS;
        self
    }

    /// Excludes colliders that do not interact with these groups.
    #[must_use]
    pub fn groups(mut self, groups: InteractionGroups) -> Self {
        self.groups = Some(groups);
        self
    }

    /// Excludes one collider.
    #[must_use]
    pub fn exclude_collider(mut self, collider: ColliderHandle) -> Self {
        self.exclude_collider = Some(collider);
        self
    }

    /// Excludes the colliders of a body.
    #[must_use]
    pub fn exclude_rigid_body(mut self, rigid_body: RigidBodyHandle) -> Self {
        self.exclude_rigid_body = Some(rigid_body);
        self
    }

    /// Excludes colliders for which the predicate returns `false`.
    #[must_use]
    pub fn predicate(mut self, predicate: &'a impl Fn(ColliderHandle, &Collider) -> bool) -> Self {
        self.predicate = Some(predicate);
        self
    }

    /// Returns whether a collider passes the filter. The type of its body is that of the body in `bodies`.
    pub fn test(&self, bodies: &RigidBodySet, handle: ColliderHandle, collider: &Collider) -> bool {
        let conditions = Self { flags: QueryFilterFlags::empty(), ..*self };
        self.flags.test(bodies, collider)
            && engine::pipeline::QueryFilter::from(conditions).test(handle, collider)
    }
}

/// The colliders of a world for queries, as of the last step.
#[derive(Copy, Clone)]
pub struct QueryPipeline<'a> {
    pub(crate) tree: &'a BroadPhaseBvh,
    /// The boxes of all colliders. The number of a leaf is the slot of its collider.
    #[cfg(rapier036)]
    pub bvh: &'a crate::parry::partitioning::Bvh,
    /// Algorithms for pairs of shapes.
    pub dispatcher: &'a dyn QueryDispatcher,
    /// The bodies.
    pub bodies: &'a RigidBodySet,
    /// The colliders.
    pub colliders: &'a ColliderSet,
    /// Filter of the colliders.
    pub filter: QueryFilter<'a>,
}

impl<'a> QueryPipeline<'a> {
    /// The engine's view of the same colliders.
    pub(crate) fn view(&self) -> QueryView<'a> {
        let Self { tree, dispatcher, bodies, colliders, filter, .. } = *self;
        tree.as_query_pipeline(dispatcher, bodies, colliders, filter.into())
    }

    /// The same colliders with another filter.
    #[must_use]
    pub fn with_filter(self, filter: QueryFilter<'a>) -> Self {
        Self { filter, ..self }
    }

    /// The first collider that a ray hits, and the time of the hit.
    pub fn cast_ray(
        &self,
        ray: &Ray,
        max_toi: Real,
        solid: bool,
    ) -> Option<(ColliderHandle, Real)> {
        self.view().cast_ray(ray, max_toi, solid)
    }

    /// The first collider that a ray hits, with the normal.
    pub fn cast_ray_and_get_normal(
        &self,
        ray: &Ray,
        max_toi: Real,
        solid: bool,
    ) -> Option<(ColliderHandle, RayIntersection)> {
        self.view().cast_ray_and_get_normal(ray, max_toi, solid)
    }

    /// All colliders that a ray hits.
    pub fn intersect_ray(
        &'a self,
        ray: Ray,
        max_toi: Real,
        solid: bool,
    ) -> impl Iterator<Item = (ColliderHandle, &'a Collider, RayIntersection)> + 'a {
        self.view().intersect_ray(ray, max_toi, solid)
    }

    /// The projection of a point onto the nearest collider. In Rapier 0.32 the distance is unlimited.
    pub fn project_point(
        &self,
        point: Vector,
        max_dist: Real,
        solid: bool,
    ) -> Option<(ColliderHandle, PointProjection)> {
        let limit = if cfg!(rapier036) { max_dist } else { Real::MAX };
        self.view().project_point(point, limit, solid)
    }

    /// All colliders that contain a point.
    pub fn intersect_point(
        &'a self,
        point: Vector,
    ) -> impl Iterator<Item = (ColliderHandle, &'a Collider)> + 'a {
        self.view().intersect_point(point)
    }

    /// The projection of a point onto the nearest collider, and the feature that it lies on.
    pub fn project_point_and_get_feature(
        &self,
        point: Vector,
        #[cfg(rapier036)] max_dist: Real,
    ) -> Option<(ColliderHandle, PointProjection, FeatureId)> {
        #[cfg(not(rapier036))]
        let max_dist = Real::MAX;
        self.view().project_point_and_get_feature(point, max_dist)
    }

    /// All colliders whose stored boxes intersect a box.
    pub fn intersect_aabb_conservative(
        &'a self,
        aabb: Aabb,
    ) -> impl Iterator<Item = (ColliderHandle, &'a Collider)> + 'a {
        self.view().intersect_aabb_conservative(aabb)
    }

    /// The first collider that a moving shape hits.
    pub fn cast_shape(
        &self,
        shape_pos: &Pose,
        shape_vel: Vector,
        shape: &dyn Shape,
        options: ShapeCastOptions,
    ) -> Option<(ColliderHandle, ShapeCastHit)> {
        self.view().cast_shape(shape_pos, shape_vel, shape, options)
    }

    /// The first collider that a moving and rotating shape hits.
    pub fn cast_shape_nonlinear(
        &self,
        shape_motion: &NonlinearRigidMotion,
        shape: &dyn Shape,
        start_time: Real,
        end_time: Real,
        stop_at_penetration: bool,
    ) -> Option<(ColliderHandle, ShapeCastHit)> {
        self.view().cast_shape_nonlinear(
            shape_motion,
            shape,
            start_time,
            end_time,
            stop_at_penetration,
        )
    }

    /// All colliders that a shape intersects.
    pub fn intersect_shape(
        &'a self,
        shape_pos: Pose,
        shape: &'a dyn Shape,
    ) -> impl Iterator<Item = (ColliderHandle, &'a Collider)> + 'a {
        self.view().intersect_shape(shape_pos, shape)
    }
}

/// The colliders of a world for queries, with mutable bodies and colliders.
pub struct QueryPipelineMut<'a> {
    pub(crate) tree: &'a BroadPhaseBvh,
    /// The boxes of all colliders. The number of a leaf is the slot of its collider.
    #[cfg(rapier036)]
    pub bvh: &'a crate::parry::partitioning::Bvh,
    /// Algorithms for pairs of shapes.
    pub dispatcher: &'a dyn QueryDispatcher,
    /// The bodies.
    pub bodies: &'a mut RigidBodySet,
    /// The colliders.
    pub colliders: &'a mut ColliderSet,
    /// Filter of the colliders.
    pub filter: QueryFilter<'a>,
}

impl QueryPipelineMut<'_> {
    /// The same colliders for queries only.
    pub fn as_ref(&self) -> QueryPipeline<'_> {
        QueryPipeline {
            tree: self.tree,
            #[cfg(rapier036)]
            bvh: self.bvh,
            dispatcher: self.dispatcher,
            bodies: self.bodies,
            colliders: self.colliders,
            filter: self.filter,
        }
    }

    /// The engine's form of the same borrow.
    pub(crate) fn as_engine(&mut self) -> engine::pipeline::QueryPipelineMut<'_> {
        let Self { tree, dispatcher, bodies, colliders, filter, .. } = self;
        tree.as_query_pipeline_mut(*dispatcher, bodies, colliders, (*filter).into())
    }
}

/// The colliders that pass the filter are the parts of a composite shape.
#[cfg(rapier036)]
mod composite {
    use super::QueryPipeline;
    use crate::math::Pose;
    use crate::parry::partitioning::Bvh;
    use crate::parry::query::details::NormalConstraints;
    use crate::parry::shape::{CompositeShape, Shape, TypedCompositeShape};

    type Part<'a> = (Option<&'a Pose>, &'a dyn Shape);

    impl QueryPipeline<'_> {
        fn part(&self, shape_id: u32) -> Option<Part<'_>> {
            let (collider, handle) = self.colliders.get_unknown_gen(shape_id)?;
            let passes = self.filter.test(self.bodies, handle, collider);
            passes.then(|| (Some(collider.position()), collider.shape()))
        }
    }

    impl CompositeShape for QueryPipeline<'_> {
        fn map_part_at(
            &self,
            shape_id: u32,
            f: &mut dyn FnMut(Option<&Pose>, &dyn Shape, Option<&dyn NormalConstraints>),
        ) {
            if let Some((pose, shape)) = self.part(shape_id) {
                f(pose, shape, None);
            }
        }

        fn bvh(&self) -> &Bvh {
            self.bvh
        }
    }

    impl TypedCompositeShape for QueryPipeline<'_> {
        type PartShape = dyn Shape;
        type PartNormalConstraints = ();

        fn map_typed_part_at<T>(
            &self,
            shape_id: u32,
            mut f: impl FnMut(Option<&Pose>, &dyn Shape, Option<&()>) -> T,
        ) -> Option<T> {
            self.part(shape_id).map(|(pose, shape)| f(pose, shape, None))
        }

        fn map_untyped_part_at<T>(
            &self,
            shape_id: u32,
            mut f: impl FnMut(Option<&Pose>, &dyn Shape, Option<&dyn NormalConstraints>) -> T,
        ) -> Option<T> {
            self.part(shape_id).map(|(pose, shape)| f(pose, shape, None))
        }
    }
}
