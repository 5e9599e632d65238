//! Rays and single shapes.

use super::hull::clip;
use super::rounded::chord;
use crate::dim::collide::has_inside;
use crate::dim::facets::Facets;
use crate::dim::field::ray_on_field;
use crate::dim::math::{DIM, Pose, Real, Vector};
use parry::query::{Ray, RayCast, RayIntersection};
use parry::shape::{Ball, Cuboid, FeatureId, Shape, TypedShape};

/// Returns whether a ray hits a shape at once: it begins inside the solid that a surface encloses, or it has
/// no direction and begins inside any shape.
fn begins_inside(shape: &dyn Shape, pose: &Pose, ray: &Ray) -> bool {
    (ray.dir == Vector::ZERO || has_inside(shape)) && shape.contains_point(pose, ray.origin)
}

/// Returns the time at which a ray hits a shape, if it is at most `limit`.
pub fn time_of_impact(
    shape: &dyn Shape,
    pose: &Pose,
    ray: &Ray,
    limit: Real,
    solid: bool,
) -> Option<Real> {
    let local = || ray.inverse_transform_by(pose);
    if ray.dir == Vector::ZERO || (solid && has_inside(shape)) {
        return intersection(shape, pose, ray, limit, solid).map(|hit| hit.time_of_impact);
    }
    match shape.as_typed_shape() {
        TypedShape::Ball(ball) => ball_time(ball, pose, ray, limit, solid).map(|(time, _)| time),
        TypedShape::Cuboid(cuboid) if solid => cuboid_time(cuboid, &local(), limit),
        TypedShape::Capsule(capsule) => capsule.cast_local_ray(&local(), limit, solid),
        TypedShape::TriMesh(mesh) if solid => mesh.cast_local_ray(&local(), limit, true),
        // Without a normal, parry's answer is wrong for hollow boxes whose wall is beyond the limit: it is
        // the limit, where there is no surface. Most shapes have no algorithm without a normal anyway.
        _ => intersection(shape, pose, ray, limit, solid).map(|hit| hit.time_of_impact),
    }
}

/// Returns the time at which a ray hits a shape, if it is at most `limit`, with the normal and feature there.
pub fn intersection(
    shape: &dyn Shape,
    pose: &Pose,
    ray: &Ray,
    limit: Real,
    solid: bool,
) -> Option<RayIntersection> {
    if solid && begins_inside(shape, pose, ray) {
        return Some(RayIntersection::new(0.0, Vector::ZERO, FeatureId::Unknown));
    }
    if ray.dir == Vector::ZERO {
        return None;
    }
    let typed = shape.as_typed_shape();
    if let TypedShape::Ball(ball) = typed {
        return ball_hit(ball, pose, ray, limit, solid);
    }
    let local = ray.inverse_transform_by(pose);
    let plain = || shape.cast_local_ray_and_get_normal(&local, limit, solid);
    let hit = match typed {
        TypedShape::Cuboid(_) => plain().map(|hit| against(hit, &local)),
        TypedShape::Capsule(_) => plain(),
        TypedShape::HeightField(field) => ray_on_field(field, &local, limit),
        _ => match Facets::of(typed) {
            Some((facets, 0.0)) if facets.is_flat() => plate_hit(&facets, &local, limit),
            Some((facets, 0.0)) => hull_hit(&facets, &local, limit, solid),
            _ if shape.as_support_map().is_some() => searched_hit(shape, &local, limit, solid),
            _ => plain(),
        },
    };
    hit.map(|hit| hit.transform_by(pose))
}

/// Returns the time at which a ray hits a solid box, in the frame of the box. This is parry's formula, for
/// all axes at once.
fn cuboid_time(cuboid: &Cuboid, ray: &Ray, limit: Real) -> Option<Real> {
    if (0..DIM).any(|axis| ray.dir[axis] == 0.0) {
        return cuboid.cast_local_ray(ray, limit, true); // Zero divided by zero gives no time.
    }
    let inv_dir = ray.dir.recip();
    let (low, high) = (-cuboid.half_extents - ray.origin, cuboid.half_extents - ray.origin);
    let (one, other) = (low * inv_dir, high * inv_dir);
    let start = one.min(other).max_element().max(0.0);
    let end = one.max(other).min_element().min(limit);
    (start <= end).then_some(start)
}

/// Returns the time at which a ray hits a ball, and whether the ray starts inside.
fn ball_time(
    ball: &Ball,
    pose: &Pose,
    ray: &Ray,
    limit: Real,
    solid: bool,
) -> Option<(Real, bool)> {
    let [enter, leave] = chord(pose.translation - ray.origin, ray.dir, ball.radius)?;
    let is_inside = enter <= 0.0;
    let time = match (is_inside, solid) {
        (true, true) => 0.0,
        (true, false) => leave,
        (false, _) => enter,
    };
    (leave >= 0.0 && time <= limit).then_some((time, is_inside))
}

fn ball_hit(
    ball: &Ball,
    pose: &Pose,
    ray: &Ray,
    limit: Real,
    solid: bool,
) -> Option<RayIntersection> {
    let (time, is_inside) = ball_time(ball, pose, ray, limit, solid)?;
    let outward = (ray.point_at(time) - pose.translation).normalize_or_zero();
    let normal = match (is_inside, solid) {
        (true, true) => Vector::ZERO,
        (true, false) => -outward,
        (false, _) => outward,
    };
    Some(RayIntersection::new(time, normal, FeatureId::Face(0)))
}

/// Returns the hit of a ray on a hull, in the frame of the hull.
fn hull_hit(facets: &Facets<'_>, ray: &Ray, limit: Real, solid: bool) -> Option<RayIntersection> {
    let span = clip(facets, ray.origin, ray.dir, 0.0)?;
    let normal = |face| facets.facet(face).normal;
    let (time, normal, face) = match (span.enter, span.leave) {
        (_, (leave, _)) if leave < 0.0 => return None,
        ((enter, face), _) if enter >= 0.0 => (enter, normal(face), face),
        ((_, face), _) if solid => (0.0, Vector::ZERO, face),
        (_, (leave, face)) => (leave, -normal(face), face),
    };
    let feature = FeatureId::Face(face as u32);
    (time <= limit).then(|| RayIntersection::new(time, normal, feature))
}

/// Returns a hit with the normal against the ray. That of a box without thickness may be along the ray.
fn against(mut hit: RayIntersection, ray: &Ray) -> RayIntersection {
    if hit.normal.dot(ray.dir) > 0.0 {
        hit.normal = -hit.normal;
    }
    hit
}

/// Returns the hit of a ray on a flat hull or triangle, in its frame. A ray in its plane hits
/// nothing.
fn plate_hit(facets: &Facets<'_>, ray: &Ray, limit: Real) -> Option<RayIntersection> {
    let front = facets.facet(0);
    let speed = front.normal.dot(ray.dir);
    let time = (front.offset - front.normal.dot(ray.origin)) / speed;
    let is_hit = (0.0..=limit).contains(&time) && facets.is_over(0, ray.point_at(time));
    let face = usize::from(speed > 0.0);
    let normal = if speed > 0.0 { -front.normal } else { front.normal };
    is_hit.then(|| RayIntersection::new(time, normal, FeatureId::Face(face as u32)))
}

/// Returns the hit of a ray on a shape for which parry searches, in the frame of the shape.
///
/// The search loses digits along the path, and confuses lengths with times at the exit of a hollow shape. So
/// it begins near the shape, and with a direction of unit length.
fn searched_hit(shape: &dyn Shape, ray: &Ray, limit: Real, solid: bool) -> Option<RayIntersection> {
    let length = ray.dir.length();
    if !length.is_normal() {
        return shape.cast_local_ray_and_get_normal(ray, limit, solid);
    }
    let unit = ray.dir / length;
    let around = shape.compute_local_bounding_sphere();
    let start = ((around.center - ray.origin).dot(unit) - 2.0 * around.radius).max(0.0);
    let rest = (limit * length).min(Real::MAX) - start;
    if rest.is_nan() || rest < 0.0 {
        return None;
    }
    let near = Ray::new(ray.origin + unit * start, unit);
    let mut hit = shape.cast_local_ray_and_get_normal(&near, rest, solid)?;
    hit.time_of_impact = (hit.time_of_impact + start) / length;
    (hit.time_of_impact <= limit).then_some(hit)
}
