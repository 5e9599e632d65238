//! The manifold of two convex parts.

use super::ball::ball_manifold;
use super::capsule::capsule_capsule;
use super::part::Part;
use super::polytopes::{face_contacts, polytope_polytope};
use super::sides::{is_flat, keep_side};
use super::support::{Core, contacts_along, support_manifold};
use crate::dim::collide::{Polytope, RawManifold, RawPoint, capsule_triangle, cuboid_cuboid};
use crate::dim::math::{Pose, Real, Vector};
use parry::query::{DefaultQueryDispatcher, PersistentQueryDispatcher};
use parry::shape::{Capsule, Shape, TypedShape};

/// Certain fraction of a computed distance, allowing for rounding.
pub(super) const DISTANCE_FRACTION: Real = 0.99;
/// Boxes that are closer than this fraction of the prediction distance touch with faces and edges only.
const CORNER_GAP_FRACTION_MAX: Real = 0.25;

/// Least cosine of a normal and the last one at which they count as the same.
const SAME_NORMAL_COSINE_MIN: Real = 0.9;

/// Computes the usable contacts of two convex parts, `pos12` being the pose of the second in the frame
/// of the first. Returns a lower bound of the distance, 0 if there are contacts or nothing is known;
/// `None` if such shapes never touch.
pub(super) fn part_manifold(
    pos12: &Pose,
    [part1, part2]: &[Part<'_>; 2],
    prediction: Real,
    raw: &mut RawManifold,
) -> Option<Real> {
    raw.points.clear();
    let last_normal = raw.local_n1;
    let gap = convex_manifold(pos12, part1, part2, prediction, raw)?;
    keep_sides(pos12, [part1, part2], last_normal, prediction, raw);
    raw.points.retain(|point| is_sound(point) && point.dist <= prediction);
    if !raw.points.is_empty() {
        return Some(0.0);
    }
    let gap = if gap > 0.0 {
        gap
    } else {
        separation_along(pos12, part1.shape, part2.shape, raw.local_n1)
    };
    Some(gap * DISTANCE_FRACTION)
}

/// Keeps two parts without thickness on the sides of the last normal, which is zero if there is none.
///
/// The direction of least overlap of two plates that meet at an angle is often that in which one of them has
/// no extent. It changes as soon as one has moved farther along the other than contacts overlap.
fn keep_sides(
    pos12: &Pose,
    parts: [&Part<'_>; 2],
    last_normal: Vector,
    prediction: Real,
    raw: &mut RawManifold,
) {
    let overlap = raw.points.iter().any(|point| point.dist < 0.0);
    let has_turned =
        last_normal != Vector::ZERO && raw.local_n1.dot(last_normal) < SAME_NORMAL_COSINE_MIN;
    if !(has_turned && parts.iter().all(|part| is_flat(part.shape))) {
        return;
    }
    let mut along_last = RawManifold::new();
    for is_first in [true, false].into_iter().filter(|_| overlap) {
        manifold_along(pos12, parts, is_first, last_normal, prediction, &mut along_last);
        along_last.points.retain(|point| is_sound(point) && point.dist <= prediction);
        let is_shallow = along_last.points.iter().all(|point| point.dist > -prediction);
        if is_shallow && !along_last.points.is_empty() {
            core::mem::swap(raw, &mut along_last);
            return;
        }
        along_last.points.clear();
    }
    keep_side(last_normal, raw);
}

/// Returns whether all numbers of the point are finite.
pub(super) fn is_sound(point: &RawPoint) -> bool {
    point.local_p1.is_finite() && point.local_p2.is_finite() && point.dist.is_finite()
}

/// Computes the points at which two convex parts are within `prediction`, into `raw`.
///
/// On entry, `raw.local_n1` contains the last normal, or zero. On exit it contains the normal, or a
/// separating direction if there are no points. Returns a lower bound of the distance, 0 if nothing is known
/// of it; `None` if such shapes never touch.
pub(super) fn convex_manifold(
    pos12: &Pose,
    part1: &Part<'_>,
    part2: &Part<'_>,
    prediction: Real,
    raw: &mut RawManifold,
) -> Option<Real> {
    if part1.constraints.is_some() || part2.constraints.is_some() {
        return general_manifold(pos12, part1, part2, prediction, raw).then_some(0.0);
    }
    match (part1.shape.as_typed_shape(), part2.shape.as_typed_shape()) {
        (TypedShape::Cuboid(cuboid1), TypedShape::Cuboid(cuboid2))
            if !(is_flat(part1.shape) || is_flat(part2.shape)) =>
        {
            let (half1, half2) = (cuboid1.half_extents, cuboid2.half_extents);
            let hint = raw.local_n1;
            let gap = cuboid_cuboid(pos12, half1, half2, prediction, raw);
            // Approaching corners at a distance are a contact. Corners of neighbours in a wall are none:
            // bodies would catch on them.
            let meet_with_corners =
                raw.points.is_empty() && gap > CORNER_GAP_FRACTION_MAX * prediction;
            if meet_with_corners && gap <= prediction {
                raw.local_n1 = hint;
                return others(pos12, part1, part2, prediction, raw);
            }
            Some(gap)
        }
        (_, TypedShape::Ball(ball2)) => {
            Some(ball_manifold(pos12, part1.shape, ball2.radius, prediction, raw))
        }
        (TypedShape::Ball(ball1), _) => {
            let gap = ball_manifold(&pos12.inverse(), part2.shape, ball1.radius, prediction, raw);
            flip(raw);
            Some(gap)
        }
        (TypedShape::Capsule(capsule1), TypedShape::Capsule(capsule2)) => {
            capsule_capsule(pos12, capsule1, capsule2, prediction, raw)
                .or_else(|| others(pos12, part1, part2, prediction, raw))
        }
        (TypedShape::Capsule(capsule1), TypedShape::Segment(segment2)) if capsule1.radius > 0.0 => {
            let thin = Capsule::new(segment2.a, segment2.b, 0.0);
            capsule_capsule(pos12, capsule1, &thin, prediction, raw)
                .or_else(|| others(pos12, part1, part2, prediction, raw))
        }
        (TypedShape::Capsule(capsule1), TypedShape::Triangle(triangle2))
            if capsule1.radius > 0.0 =>
        {
            capsule_triangle(pos12, capsule1, triangle2, prediction, raw)
                .or_else(|| others(pos12, part1, part2, prediction, raw))
        }
        (TypedShape::Segment(_) | TypedShape::Triangle(_), TypedShape::Capsule(capsule2))
            if capsule2.radius > 0.0 =>
        {
            raw.local_n1 = pos12.rotation.inverse() * -raw.local_n1;
            let gap = convex_manifold(&pos12.inverse(), part2, part1, prediction, raw);
            flip(raw);
            gap
        }
        _ => others(pos12, part1, part2, prediction, raw),
    }
}

/// The manifold of two parts without a special algorithm.
fn others(
    pos12: &Pose,
    part1: &Part<'_>,
    part2: &Part<'_>,
    prediction: Real,
    raw: &mut RawManifold,
) -> Option<Real> {
    if let [Some(polytope1), Some(polytope2)] = [part1, part2].map(|part| Polytope::of(part.shape))
    {
        return Some(polytope_polytope(pos12, [polytope1, polytope2], prediction, raw));
    }
    general_manifold(pos12, part1, part2, prediction, raw).then_some(0.0)
}

/// Computes the manifold of any two convex parts. Returns whether such pairs are supported.
fn general_manifold(
    pos12: &Pose,
    part1: &Part<'_>,
    part2: &Part<'_>,
    prediction: Real,
    raw: &mut RawManifold,
) -> bool {
    if let (Some(core1), Some(core2)) = (Core::of(part1), Core::of(part2)) {
        support_manifold(pos12, [part1, part2], [core1, core2], prediction, raw);
        return true;
    }
    DefaultQueryDispatcher
        .contact_manifold_convex_convex(
            pos12,
            part1.shape,
            part2.shape,
            part1.constraints,
            part2.constraints,
            prediction,
            raw,
        )
        .is_ok()
}

/// Computes the contacts of two parts along a direction, from the first to the second, into `raw`. They are
/// those of the face of either part with the most similar normal.
///
/// Balls have none but those that they have anyway.
pub(super) fn manifold_along(
    pos12: &Pose,
    parts: [&Part<'_>; 2],
    is_first: bool,
    direction: Vector,
    prediction: Real,
    raw: &mut RawManifold,
) {
    if let [Some(polytope1), Some(polytope2)] = parts.map(|part| Polytope::of(part.shape)) {
        face_contacts(pos12, [polytope1, polytope2], is_first, direction, prediction, raw);
    } else if let [Some(core1), Some(core2)] = parts.map(Core::of) {
        contacts_along(pos12, [core1, core2], direction, raw);
    }
}

/// Exchanges the roles of the two parts.
fn flip(raw: &mut RawManifold) {
    core::mem::swap(&mut raw.local_n1, &mut raw.local_n2);
    for point in &mut raw.points {
        core::mem::swap(&mut point.local_p1, &mut point.local_p2);
        core::mem::swap(&mut point.fid1, &mut point.fid2);
    }
}

/// Lower bound of the distance of two convex shapes along `direction`; 0 if they overlap along it or if it is
/// unknown.
pub(super) fn separation_along(
    pos12: &Pose,
    shape1: &dyn Shape,
    shape2: &dyn Shape,
    direction: Vector,
) -> Real {
    let (Some(support1), Some(support2)) = (shape1.as_support_map(), shape2.as_support_map())
    else {
        return 0.0;
    };
    let Some(direction) = direction.try_normalize() else { return 0.0 };
    let highest = support1.local_support_point(direction);
    let lowest = support2.support_point(pos12, -direction);
    let gap = direction.dot(lowest - highest);
    if gap.is_finite() { gap.max(0.0) } else { 0.0 }
}
