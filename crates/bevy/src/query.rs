//! Queries of the simulation: rays, points and shapes.

use crate::collider::Collider;
use crate::dim::{Vector, pose_of, to_bevy, to_engine};
use crate::precision::Scalar;
use crate::world::{PhysicsWorld, entity_of};
use bevy::ecs::entity::{Entity, EntityHashSet};
use bevy::ecs::system::{Res, SystemParam};
use bevy::transform::components::Transform;
use rapier::prelude::{
    Collider as EngineCollider, ColliderHandle, InteractionGroups, QueryFilter, QueryFilterFlags,
    QueryView, Ray, ShapeCastHit, ShapeCastOptions,
};

/// System parameter for queries of the colliders as of the last step. Colliders that were inserted through
/// the engine have no entity, and queries ignore them.
///
/// ```
/// # use bevy::prelude::*;
#[doc = concat!("# use ", env!("CARGO_CRATE_NAME"), "::prelude::*;")]
/// fn look_down(query: SpatialQuery) {
///     let hit = query.cast_ray(Vector::Y * 5.0, -Vector::Y, 100.0, &SpatialFilter::default());
///     if let Some(hit) = hit {
///         println!("{} is {} below", hit.entity, hit.distance);
///     }
/// }
/// # bevy::ecs::system::assert_is_system(look_down);
/// ```
#[derive(SystemParam)]
pub struct SpatialQuery<'w> {
    world: Res<'w, PhysicsWorld>,
}

/// Colliders that a query finds. All by default.
#[derive(Clone, Debug, Default)]
pub struct SpatialFilter {
    /// Excluded kinds of colliders.
    pub flags: QueryFilterFlags,
    /// Memberships and filter of the query, tested against the groups of the colliders.
    pub groups: Option<InteractionGroups>,
    /// Excluded entities of colliders or bodies.
    pub excluded: EntityHashSet,
}

impl SpatialFilter {
    /// Excludes a collider, or all colliders of a body.
    #[must_use]
    pub fn excluding(mut self, entity: Entity) -> Self {
        self.excluded.insert(entity);
        self
    }

    /// Excludes sensors.
    #[must_use]
    pub fn without_sensors(mut self) -> Self {
        self.flags |= QueryFilterFlags::EXCLUDE_SENSORS;
        self
    }

    /// Sets memberships and filter of the query.
    #[must_use]
    pub fn with_groups(self, groups: InteractionGroups) -> Self {
        Self { groups: Some(groups), ..self }
    }
}

/// The first hit of a ray.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct RayHit {
    /// The entity of the collider.
    pub entity: Entity,
    /// Length of the ray until the hit, in lengths of its direction.
    pub distance: Scalar,
    /// The point.
    pub point: Vector,
    /// The normal of the surface.
    pub normal: Vector,
}

/// The point of a collider that is nearest to another point.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct PointHit {
    /// The entity of the collider.
    pub entity: Entity,
    /// The nearest point.
    pub point: Vector,
    /// Whether the collider contains the queried point.
    pub is_inside: bool,
}

/// The first hit of a moving shape.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct ShapeHit {
    /// The entity of the collider.
    pub entity: Entity,
    /// Length of the way until the hit, in lengths of the displacement.
    pub distance: Scalar,
    /// The point on the collider.
    pub point: Vector,
    /// The normal of the collider at the point.
    pub normal: Vector,
}

impl SpatialQuery<'_> {
    /// The first collider that a ray hits. A ray that begins inside a collider hits it at once.
    pub fn cast_ray(
        &self,
        origin: Vector,
        direction: Vector,
        max_distance: Scalar,
        filter: &SpatialFilter,
    ) -> Option<RayHit> {
        let ray = Ray::new(to_engine(origin), to_engine(direction));
        self.run(filter, |view| {
            let (handle, hit) = view.cast_ray_and_get_normal(&ray, max_distance, true)?;
            Some(RayHit {
                entity: self.world.entity_of_collider(handle)?,
                distance: hit.time_of_impact,
                point: to_bevy(ray.point_at(hit.time_of_impact)),
                normal: to_bevy(hit.normal),
            })
        })
    }

    /// All colliders that a ray hits, in no particular order.
    pub fn intersections_with_ray(
        &self,
        origin: Vector,
        direction: Vector,
        max_distance: Scalar,
        filter: &SpatialFilter,
    ) -> Vec<Entity> {
        let ray = Ray::new(to_engine(origin), to_engine(direction));
        self.run(filter, |view| {
            let hits = view.intersect_ray(ray, max_distance, true);
            self.entities(hits.map(|(handle, ..)| handle))
        })
    }

    /// The first collider in the path of a shape that moves by `displacement` without rotation. The
    /// transform places the shape; its scale has no effect. `None` also if the shape is invalid.
    pub fn cast_shape(
        &self,
        shape: &Collider,
        transform: &Transform,
        displacement: Vector,
        filter: &SpatialFilter,
    ) -> Option<ShapeHit> {
        let (shape, pose) = (shape.shape().ok()?, pose_of(transform));
        let options = ShapeCastOptions::with_max_time_of_impact(1.0);
        self.run(filter, |view| {
            let hit = view.cast_shape(&pose, to_engine(displacement), &**shape, options);
            self.shape_hit(hit?)
        })
    }

    /// The nearest point on any collider within a distance. Inside of a collider it is the point itself.
    pub fn project_point(
        &self,
        point: Vector,
        max_distance: Scalar,
        filter: &SpatialFilter,
    ) -> Option<PointHit> {
        self.run(filter, |view| {
            let (handle, hit) = view.project_point(to_engine(point), max_distance, true)?;
            let entity = self.world.entity_of_collider(handle)?;
            Some(PointHit { entity, point: to_bevy(hit.point), is_inside: hit.is_inside })
        })
    }

    /// All colliders that contain a point, in no particular order.
    pub fn intersections_with_point(&self, point: Vector, filter: &SpatialFilter) -> Vec<Entity> {
        self.run(filter, |view| {
            let found = view.intersect_point(to_engine(point));
            self.entities(found.map(|(handle, _)| handle))
        })
    }

    /// All colliders that a shape touches, in no particular order. None if the shape is invalid.
    pub fn intersections_with_shape(
        &self,
        shape: &Collider,
        transform: &Transform,
        filter: &SpatialFilter,
    ) -> Vec<Entity> {
        let Ok(shape) = shape.shape() else {
            return Vec::new();
        };
        self.run(filter, |view| {
            let found = view.intersect_shape(pose_of(transform), &**shape);
            self.entities(found.map(|(handle, _)| handle))
        })
    }

    /// Runs a query with the engine's filter.
    fn run<T>(&self, filter: &SpatialFilter, query: impl FnOnce(QueryView<'_>) -> T) -> T {
        let bodies = &self.world.engine.bodies;
        // A collider without entity must not hide those behind it.
        let passes = |_: ColliderHandle, collider: &EngineCollider| {
            let body = collider.parent().and_then(|handle| bodies.get(handle));
            let body = body.and_then(|body| entity_of(body.user_data));
            let is_excluded = |entity| filter.excluded.contains(&entity);
            entity_of(collider.user_data).is_some_and(|entity| !is_excluded(entity))
                && !body.is_some_and(is_excluded)
        };
        let filter =
            QueryFilter { flags: filter.flags, groups: filter.groups, ..QueryFilter::default() };
        query(self.world.engine.query_pipeline_with_filter(filter.predicate(&passes)))
    }

    fn entities(&self, handles: impl Iterator<Item = ColliderHandle>) -> Vec<Entity> {
        handles.filter_map(|handle| self.world.entity_of_collider(handle)).collect()
    }

    fn shape_hit(&self, (handle, hit): (ColliderHandle, ShapeCastHit)) -> Option<ShapeHit> {
        Some(ShapeHit {
            entity: self.world.entity_of_collider(handle)?,
            distance: hit.time_of_impact,
            point: to_bevy(hit.witness1),
            normal: to_bevy(hit.normal1),
        })
    }
}
