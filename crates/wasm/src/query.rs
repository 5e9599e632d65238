//! Queries of worlds: rays, points and shapes.
//!
//! A query takes the filter that [`query_filter`] stored before it. A result is the handle of a collider, or
//! NaN; its numbers are in the scratch block.

use crate::collider::groups;
use crate::fault::Fault;
use crate::handle::{Handle, optional};
use crate::host;
use crate::memory::{self, Single, number, put_number, put_vector, vector};
use crate::rapier::dynamics::RigidBodyHandle;
use crate::rapier::geometry::{
    Aabb, BoundingVolume, Collider, ColliderHandle, FeatureId, InteractionGroups, Ray,
    RayIntersection, ShapeCastHit, ShapeCastOptions,
};
use crate::rapier::math::Real;
use crate::rapier::pipeline::{QueryFilter, QueryFilterFlags, QueryView};
use crate::registry::queried;
use crate::shape::shape;

/// Filter of a query.
#[derive(Copy, Clone, Default)]
struct Filter {
    flags: QueryFilterFlags,
    groups: Option<InteractionGroups>,
    exclude_collider: Option<ColliderHandle>,
    exclude_rigid_body: Option<RigidBodyHandle>,
    has_predicate: bool,
}

static FILTER: Single<Option<Filter>> = Single::new(None);

fn predicate(handle: ColliderHandle, _: &Collider) -> bool {
    host::accepts(handle.to_number()) != 0
}

/// Returns the filter that JavaScript stored. It is used by one query.
pub fn filter() -> QueryFilter<'static> {
    // SAFETY: the reference ends with the statement.
    let filter = unsafe { FILTER.get() }.take().unwrap_or_default();
    QueryFilter {
        flags: filter.flags,
        groups: filter.groups,
        exclude_collider: filter.exclude_collider,
        exclude_rigid_body: filter.exclude_rigid_body,
        predicate: if filter.has_predicate { Some(&predicate) } else { None },
    }
}

/// A time or distance that may be infinite.
pub fn limit(name: &str, value: f64) -> Result<Real, Fault> {
    match value >= 0.0 {
        true => Ok((value as Real).min(Real::MAX)),
        false => Err(Fault::number(name, value, "at least 0")),
    }
}

/// A ray from places 0 and 1.
pub fn ray() -> Result<Ray, Fault> {
    Ok(Ray::new(vector(0, "ray.origin")?, vector(1, "ray.dir")?))
}

/// Writes a feature: its kind and its number.
pub fn put_feature(place: usize, feature: FeatureId) {
    let (kind, id) = match feature {
        FeatureId::Vertex(id) => (0.0, id),
        #[cfg(not(feature = "dim2"))]
        FeatureId::Edge(id) => (1.0, id),
        FeatureId::Face(id) => (2.0, id),
        FeatureId::Unknown => (3.0, 0),
    };
    put_number(place, 0, kind);
    // A number of 32 bits does not fit into a float of 32 bits: two halves do.
    put_number(place, 1, (id & 0xffff) as Real);
    put_number(place, 2, (id >> 16) as Real);
}

/// Writes the hit of a ray: normal, feature, time.
pub fn put_ray_hit(hit: &RayIntersection) {
    put_vector(0, hit.normal);
    put_feature(1, hit.feature);
    put_number(2, 0, hit.time_of_impact);
}

/// Writes the hit of a shape: two points, two normals, the time.
pub fn put_shape_hit(hit: &ShapeCastHit) {
    put_vector(0, hit.witness1);
    put_vector(1, hit.witness2);
    put_vector(2, hit.normal1);
    put_vector(3, hit.normal2);
    put_number(4, 0, hit.time_of_impact);
}

/// The options of a cast.
pub fn cast_options(target: f64, max: f64, stop: u32) -> Result<ShapeCastOptions, Fault> {
    Ok(ShapeCastOptions {
        max_time_of_impact: limit("maxToi", max)?,
        target_distance: limit("targetDistance", target)?,
        stop_at_penetration: stop != 0,
        ..ShapeCastOptions::default()
    })
}

/// Passes colliders to the visitor of JavaScript until it ends the query.
fn visit<'a>(found: impl Iterator<Item = (ColliderHandle, &'a Collider)>) {
    for (handle, _) in found {
        if host::visit(handle.to_number()) == 0 {
            break;
        }
    }
}

/// The result of a query: the numbers are written, the handle is returned.
fn answer<T>(found: Option<(ColliderHandle, T)>, put: impl FnOnce(&T)) -> f64 {
    if let Some((_, numbers)) = &found {
        put(numbers);
    }
    optional(found.map(|(handle, _)| handle))
}

/// Runs a query of the colliders that pass the stored filter, at their present poses.
fn query<R>(world: u32, work: impl FnOnce(QueryView<'_>) -> R) -> Result<R, Fault> {
    let filter = filter();
    queried(world, |world, queries| work(queries.view(&world.colliders, filter)))
}

exports! {
    /// Stores the filter of the next query. Negative groups and handles that are NaN exclude nothing.
    fn query_filter(flags: u32, groups_or_minus: f64, exclude_collider: f64, exclude_body: f64, has_predicate: u32) {
        let filter = Filter {
            // The bits of the published packages begin one lower.
            flags: QueryFilterFlags::from_bits_truncate(flags << 1),
            groups: (groups_or_minus >= 0.0).then(|| groups(groups_or_minus as u32)),
            exclude_collider: (!exclude_collider.is_nan()).then(|| ColliderHandle::of_number(exclude_collider)),
            exclude_rigid_body: (!exclude_body.is_nan()).then(|| RigidBodyHandle::of_number(exclude_body)),
            has_predicate: has_predicate != 0,
        };
        // SAFETY: the reference ends with the statement.
        *unsafe { FILTER.get() } = Some(filter);
    }

    /// The first collider that a ray hits. Writes the time.
    fn query_cast_ray(world: u32, max: f64, solid: u32) -> f64 {
        let (ray, max) = (ray()?, limit("maxToi", max)?);
        let hit = query(world, |view| view.cast_ray(&ray, max, solid != 0))?;
        answer(hit, |time| put_number(2, 0, *time))
    }

    /// The first collider that a ray hits. Writes normal, feature and time.
    fn query_cast_ray_and_get_normal(world: u32, max: f64, solid: u32) -> f64 {
        let (ray, max) = (ray()?, limit("maxToi", max)?);
        let hit = query(world, |view| view.cast_ray_and_get_normal(&ray, max, solid != 0))?;
        answer(hit, put_ray_hit)
    }

    /// Passes all colliders that a ray hits to the visitor, each with normal, feature and time.
    fn query_intersections_with_ray(world: u32, max: f64, solid: u32) {
        let (ray, max) = (ray()?, limit("maxToi", max)?);
        query(world, |view| {
            for (handle, _, hit) in view.intersect_ray(ray, max, solid != 0) {
                put_ray_hit(&hit);
                if host::visit(handle.to_number()) == 0 {
                    break;
                }
            }
        })?;
    }

    /// The collider nearest to a point. Writes the nearest point and whether the point is inside.
    fn query_project_point(world: u32, solid: u32) -> f64 {
        let point = vector(0, "point")?;
        let found = query(world, |view| view.project_point(point, Real::MAX, solid != 0))?;
        answer(found, |projection| {
            put_vector(0, projection.point);
            put_number(1, 0, projection.is_inside.into());
        })
    }

    /// The collider whose surface is nearest to a point. Writes the nearest point, whether the point is
    /// inside, and the feature.
    fn query_project_point_and_get_feature(world: u32) -> f64 {
        let point = vector(0, "point")?;
        let found = query(world, |view| {
            let found = view.project_point_and_get_feature(point, Real::MAX);
            found.map(|(handle, projection, feature)| (handle, (projection, feature)))
        })?;
        answer(found, |(projection, feature)| {
            put_vector(0, projection.point);
            put_number(1, 0, projection.is_inside.into());
            put_feature(2, *feature);
        })
    }

    /// Passes all colliders that contain a point to the visitor.
    fn query_intersections_with_point(world: u32) {
        let point = vector(0, "point")?;
        query(world, |view| visit(view.intersect_point(point)))?;
    }

    /// A collider that a shape touches. The scratch block holds the pose of the shape.
    fn query_intersection_with_shape(world: u32, number: u32) -> f64 {
        let (shape, pose) = (shape(number)?, memory::pose(0)?);
        let found = query(world, |view| view.intersect_shape(pose, &*shape).next().map(|(handle, _)| handle))?;
        optional(found)
    }

    /// Passes all colliders that a shape touches to the visitor.
    fn query_intersections_with_shape(world: u32, number: u32) {
        let (shape, pose) = (shape(number)?, memory::pose(0)?);
        query(world, |view| visit(view.intersect_shape(pose, &*shape)))?;
    }

    /// The first collider in the path of a shape: pose in places 0 and 1, velocity in place 2. Writes the
    /// hit.
    fn query_cast_shape(world: u32, number: u32, target: f64, max: f64, stop: u32) -> f64 {
        let (shape, pose, velocity) = (shape(number)?, memory::pose(0)?, vector(2, "shapeVel")?);
        let options = cast_options(target, max, stop)?;
        let hit = query(world, |view| view.cast_shape(&pose, velocity, &*shape, options))?;
        answer(hit, put_shape_hit)
    }

    /// Passes all colliders whose boxes overlap a box to the visitor: centre and half extents.
    fn query_colliders_in_aabb(world: u32) {
        let (center, extents) = (vector(0, "aabbCenter")?, vector(1, "aabbHalfExtents")?);
        let aabb = Aabb::from_half_extents(center, extents.abs());
        query(world, |view| {
            // The trees hold the boxes of the last step, too.
            let found = view.intersect_aabb_conservative(aabb);
            visit(found.filter(|(_, collider)| collider.compute_aabb().intersects(&aabb)));
        })?;
    }

    /// The high half of the number of a feature that is in a place.
    fn query_feature_id(place: usize) -> u32 {
        number(place, 1) as u32 | (number(place, 2) as u32) << 16
    }
}
