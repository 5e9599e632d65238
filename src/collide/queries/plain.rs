//! Queries of two plain parts: convex shapes with a support function, and half-spaces.
//!
//! A shape of the user's own with neither a support function nor parts counts as its bounding box. With a
//! ball it counts as itself, because the distance of a point suffices.

use super::balls::{Cast, cast_of_ball};
use super::convex_cast::cast_of_convex;
use super::pair_query::{Found, PairQuery};
use crate::base::guard::guarded;
use crate::base::parry_version::{distance_of, is_intersecting};
use crate::collide::parts::Parts;
use crate::dim::math::{Pose, Real, Vector};
use parry::query::details::distance_support_map_support_map;
use parry::query::{
    Contact, DefaultQueryDispatcher, QueryDispatcher, ShapeCastHit, ShapeCastOptions,
    ShapeCastStatus,
};
use parry::shape::{Ball, Cuboid, HalfSpace, Shape};

/// The result of a query for two plain parts, if its cost is at most `limit`.
pub(super) fn least(
    query: PairQuery,
    pose12: &Pose,
    shapes: [&dyn Shape; 2],
    limit: Real,
) -> Option<Found> {
    if shapes.iter().any(|shape| box_of_unknown(*shape).is_some()) {
        return least_of_unknown(query, pose12, shapes, limit);
    }
    if let [Some(plane1), Some(plane2)] = shapes.map(|shape| shape.as_halfspace()) {
        return least_of_planes(query, pose12, [plane1, plane2])
            .filter(|found| found.cost <= limit);
    }
    let [shape1, shape2] = shapes;
    let found = match query {
        PairQuery::Intersection => {
            let test = || DefaultQueryDispatcher.intersection_test(pose12, shape1, shape2);
            let found = guarded(test)?.is_ok_and(is_intersecting);
            found.then_some(Found::at(0.0))
        }
        PairQuery::Distance => distance(pose12, shapes).map(Found::at),
        PairQuery::Contact => contact(pose12, shapes, limit).map(Found::from),
        PairQuery::Cast { velocity, options } => {
            let options = ShapeCastOptions { max_time_of_impact: limit, ..options };
            cast(pose12, velocity, shapes, options)
        }
    };
    found.filter(|found| found.cost <= limit)
}

impl From<Contact> for Found {
    fn from(contact: Contact) -> Self {
        let Contact { point1, point2, normal1, normal2, dist, .. } = contact;
        let (points, normals) = ([point1, point2], [normal1, normal2]);
        Self { points, normals, ..Self::at(dist) }
    }
}

impl From<ShapeCastHit> for Found {
    fn from(hit: ShapeCastHit) -> Self {
        let points = [hit.witness1, hit.witness2];
        let normals = [hit.normal1, hit.normal2];
        Self { points, normals, status: hit.status, ..Self::at(hit.time_of_impact) }
    }
}

/// The distance of two plain parts of which at most one is a half-space: zero if they overlap.
pub(crate) fn distance(pose12: &Pose, [shape1, shape2]: [&dyn Shape; 2]) -> Option<Real> {
    // parry's distance of two boxes is that of two of their features, which need not be the closest ones.
    if let [Some(box1), Some(box2)] = [shape1.as_cuboid(), shape2.as_cuboid()] {
        return guarded(|| distance_support_map_support_map(pose12, box1, box2));
    }
    let distance = || DefaultQueryDispatcher.distance(pose12, shape1, shape2);
    Some(distance_of(guarded(distance)?.ok()?))
}

pub(super) fn contact(
    pose12: &Pose,
    [shape1, shape2]: [&dyn Shape; 2],
    limit: Real,
) -> Option<Contact> {
    if shape2.as_halfspace().is_some() {
        // parry exchanges the two shapes without inverting the pose.
        let pose21 = pose12.inverse();
        let contact = || DefaultQueryDispatcher.contact(&pose21, shape2, shape1, limit);
        return guarded(contact)?.ok()?.map(Contact::flipped);
    }
    guarded(|| DefaultQueryDispatcher.contact(pose12, shape1, shape2, limit))?.ok()?
}

fn cast(
    pose12: &Pose,
    velocity: Vector,
    shapes: [&dyn Shape; 2],
    options: ShapeCastOptions,
) -> Option<Found> {
    match cast_of_ball(pose12, velocity, shapes, &options) {
        Cast::Known(hit) => hit.map(Found::from),
        Cast::Unclear => cast_of_convex(pose12, velocity, shapes, options),
    }
}

/// The time after which a gap closes; `None` if it does not. Shapes that overlap touch at once. Those that
/// move apart do so only if the cast stops at penetration.
pub(super) fn time_until_touch(
    gap: Real,
    closing: Real,
    options: &ShapeCastOptions,
) -> Option<Real> {
    let touches = closing > 0.0 || (gap <= 0.0 && options.stop_at_penetration);
    touches.then(|| if gap > 0.0 { gap / closing } else { 0.0 })
}

/// The status of a hit after a gap or a time, which are 0 or less for shapes that touch from the start.
pub(super) fn status_of(gap: Real) -> ShapeCastStatus {
    if gap > 0.0 {
        ShapeCastStatus::Converged
    } else {
        ShapeCastStatus::PenetratingOrWithinTargetDist
    }
}

/// The result for two half-spaces. They are apart only if their normals are opposite.
fn least_of_planes(
    query: PairQuery,
    pose12: &Pose,
    [plane1, plane2]: [&HalfSpace; 2],
) -> Option<Found> {
    let normals = [plane1.normal, plane2.normal];
    let opposite = pose12.rotation * plane2.normal + plane1.normal;
    let are_parallel = opposite.length() <= 4.0 * Real::EPSILON;
    let gap = if are_parallel { pose12.translation.dot(plane1.normal) } else { Real::MIN };
    let points = [pose12.translation - plane1.normal * gap.max(0.0), Vector::ZERO];
    let found = |cost: Real, status| Found { cost, points, normals, ids: [0; 2], status };
    let touching = ShapeCastStatus::PenetratingOrWithinTargetDist;
    match query {
        PairQuery::Intersection => (gap <= 0.0).then_some(found(0.0, touching)),
        PairQuery::Distance => Some(found(gap.max(0.0), touching)),
        PairQuery::Contact => Some(found(gap, touching)),
        // Half-spaces that are not parallel overlap without end in any direction.
        PairQuery::Cast { .. } if !are_parallel => Some(found(0.0, touching)),
        PairQuery::Cast { velocity, options } => {
            let gap = gap - options.target_distance;
            let time = time_until_touch(gap, -velocity.dot(plane1.normal), &options)?;
            Some(found(time, status_of(gap)))
        }
    }
}

/// The bounding box of a shape of the user's own with neither a support function nor parts, and its place.
pub(super) fn box_of_unknown(shape: &dyn Shape) -> Option<(Pose, Cuboid)> {
    let is_unknown = shape.as_support_map().is_none()
        && shape.as_halfspace().is_none()
        && Parts::of(shape).is_convex();
    let aabb = is_unknown.then(|| shape.compute_local_aabb())?;
    Some((Pose::from_translation(aabb.center()), Cuboid::new(aabb.half_extents())))
}

/// The result for pairs with a shape of the user's own.
fn least_of_unknown(
    query: PairQuery,
    pose12: &Pose,
    shapes: [&dyn Shape; 2],
    limit: Real,
) -> Option<Found> {
    let [shape1, shape2] = shapes;
    if !matches!(query, PairQuery::Cast { .. }) {
        if let Some(ball) = shape2.as_ball() {
            return least_of_ball(query, pose12, shape1, ball).filter(|found| found.cost <= limit);
        }
        if let Some(ball) = shape1.as_ball() {
            let found = least_of_ball(query, &pose12.inverse(), shape2, ball)?;
            return Some(found.swapped()).filter(|found| found.cost <= limit);
        }
    }
    let boxes = shapes.map(box_of_unknown);
    let pose = |side: usize| boxes[side].map_or(Pose::IDENTITY, |(pose, _)| pose);
    let shape = |side: usize| match &boxes[side] {
        Some((_, cuboid)) => cuboid as &dyn Shape,
        None => shapes[side],
    };
    let boxes12 = pose(0).inv_mul(&(*pose12 * pose(1)));
    let mut found = least(query, &boxes12, [shape(0), shape(1)], limit)?;
    for side in 0..2 {
        found.points[side] = pose(side) * found.points[side];
    }
    Some(found)
}

/// The result for any shape and a ball, from the point that is nearest to the ball's centre.
fn least_of_ball(query: PairQuery, pose12: &Pose, shape: &dyn Shape, ball: &Ball) -> Option<Found> {
    let center = pose12.translation;
    let nearest = shape.project_local_point(center, false);
    let out = if nearest.is_inside { nearest.point - center } else { center - nearest.point };
    let normal1 = out.try_normalize().unwrap_or(Vector::Y);
    let height = if nearest.is_inside { -out.length() } else { out.length() };
    let dist = height - ball.radius;
    let normal2 = pose12.rotation.inverse() * -normal1;
    let (points, normals) = ([nearest.point, normal2 * ball.radius], [normal1, normal2]);
    let cost = match query {
        PairQuery::Contact => Some(dist),
        PairQuery::Distance => Some(dist.max(0.0)),
        _ => (dist <= 0.0).then_some(0.0),
    };
    Some(Found { points, normals, ..Found::at(cost?) })
}
