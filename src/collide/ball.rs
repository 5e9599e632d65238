//! A ball against any shape: the point of the surface that is nearest to its centre.

use crate::base::feature;
use crate::base::nearest::{Nearest, direction_and_length};
use crate::dim::collide::{RawManifold, RawPoint, box_feature, nearest_on_hull};
use crate::dim::math::{DIM, Pose, Real, Vector, tangents};
use parry::shape::{Capsule, Cuboid, Shape, TypedShape};

/// The contact of a shape with a ball, whose centre in the shape's frame is `pos12.translation`.
///
/// Returns the distance, 0 if they overlap.
pub(super) fn ball_manifold(
    pos12: &Pose,
    shape1: &dyn Shape,
    radius2: Real,
    prediction: Real,
    raw: &mut RawManifold,
) -> Real {
    let center = pos12.translation;
    let nearest = match shape1.as_typed_shape() {
        TypedShape::Ball(ball) => nearest_on_ball(ball.radius, center),
        TypedShape::Cuboid(cuboid) => nearest_on_cuboid(cuboid, center),
        TypedShape::Capsule(capsule) => nearest_on_capsule(capsule, center),
        TypedShape::HalfSpace(half_space) => nearest_on_plane(half_space.normal, center),
        shape => nearest_on_hull(shape, center, radius2 + prediction)
            .unwrap_or_else(|| nearest_on_any(shape1, center)),
    };
    raw.local_n1 = nearest.normal;
    raw.local_n2 = pos12.rotation.inverse() * -nearest.normal;
    let dist = nearest.dist - radius2;
    if dist <= prediction {
        let on_ball = raw.local_n2 * radius2;
        let feature2 = feature::face(0);
        raw.points.push(RawPoint::new(nearest.point, on_ball, nearest.feature, feature2, dist));
    }
    dist.max(0.0)
}

fn nearest_on_ball(radius: Real, center: Vector) -> Nearest {
    let (normal, length) = direction_and_length(center, Vector::Y);
    Nearest { point: normal * radius, normal, dist: length - radius, feature: feature::face(0) }
}

fn nearest_on_plane(normal: Vector, center: Vector) -> Nearest {
    let dist = normal.dot(center);
    let point = center - normal * dist;
    Nearest { point, normal, dist, feature: feature::face(0) }
}

fn nearest_on_cuboid(cuboid: &Cuboid, center: Vector) -> Nearest {
    let half = cuboid.half_extents;
    let clamped = center.clamp(-half, half);
    let offset = center - clamped;
    if offset != Vector::ZERO {
        let (normal, dist) = direction_and_length(offset, Vector::Y);
        return Nearest { point: clamped, normal, dist, feature: box_feature(offset) };
    }
    // The centre is inside: leave through the nearest face.
    let depth = half - center.abs();
    let axis = (1..DIM).fold(0, |best, i| if depth[i] < depth[best] { i } else { best });
    let sign = if center[axis] < 0.0 { -1.0 } else { 1.0 };
    let (mut point, mut normal) = (center, Vector::ZERO);
    point[axis] = sign * half[axis];
    normal[axis] = sign;
    Nearest { point, normal, dist: -depth[axis], feature: box_feature(normal) }
}

fn nearest_on_capsule(capsule: &Capsule, center: Vector) -> Nearest {
    let (start, axis) = (capsule.segment.a, capsule.segment.b - capsule.segment.a);
    let length_squared = axis.length_squared();
    let fraction =
        if length_squared > 0.0 { (center - start).dot(axis) / length_squared } else { 0.0 };
    let on_axis = start + axis * fraction.clamp(0.0, 1.0);
    let aside = axis.try_normalize().map_or(Vector::Y, |unit| tangents(unit)[0]);
    let (normal, length) = direction_and_length(center - on_axis, aside);
    Nearest {
        point: on_axis + normal * capsule.radius,
        normal,
        dist: length - capsule.radius,
        feature: feature::face(0),
    }
}

fn nearest_on_any(shape: &dyn Shape, center: Vector) -> Nearest {
    let (found, feature) = shape.project_local_point_and_get_feature(center);
    let fallback = center.normalize_or(Vector::Y);
    let (outward, length) = direction_and_length(center - found.point, fallback);
    let sign = if found.is_inside { -1.0 } else { 1.0 };
    Nearest {
        point: found.point,
        normal: outward * sign,
        dist: length * sign,
        feature: feature.into(),
    }
}
