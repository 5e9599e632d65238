//! A capsule and a triangle: the part of the axis above the face, or the point where the axis is
//! nearest to an edge.
//!
//! The axis is a segment. It passes through the triangle, or is nearest to it at one of its ends, above the
//! face, or at an edge. (Ericson 2005, "Real-Time Collision Detection", section 5.1.10.)

use super::clip::{FaceContact, clip_faces};
use super::polytope::Polytope;
use super::{RawManifold, RawPoint};
use crate::base::feature;
use crate::base::segments::Segments;
use crate::dim::math::{Pose, Real, Vector};
use parry::shape::{Capsule, PackedFeatureId, Triangle};

/// Least cosine of a direction and the triangle's normal that count as equal (1.1 degrees).
const NORMAL_COSINE_MIN: Real = 0.9998;

/// The points of two shapes that are nearest to each other, and the feature of the triangle.
struct Nearest {
    on_axis: Vector,
    on_triangle: Vector,
    edge: PackedFeatureId,
}

/// Computes the contacts into `raw`. Returns a lower bound of the distance, 0 if they overlap; `None`
/// if the triangle has no area.
pub fn capsule_triangle(
    pos12: &Pose,
    capsule: &Capsule,
    triangle: &Triangle,
    prediction: Real,
    raw: &mut RawManifold,
) -> Option<Real> {
    let local_normal = triangle.normal()?;
    let polytope = Polytope::Triangle(triangle, local_normal);
    let normal = pos12.rotation * local_normal;
    let corners = [triangle.a, triangle.b, triangle.c].map(|corner| *pos12 * corner);
    let axis = [capsule.segment.a, capsule.segment.b];
    let heights = axis.map(|end| normal.dot(end - corners[0]));
    let above_face = nearest_to_face(axis, corners, normal, heights);
    // From the triangle to the capsule.
    let outward = if above_face.is_some_and(|(_, is_below)| is_below) { -normal } else { normal };
    let to_edges = nearest_to_edges(axis, corners);
    let offset = to_edges.on_triangle - to_edges.on_axis;
    let to_edge = offset.length();
    let (dist, direction) = match above_face {
        Some((height, _)) if height <= to_edge => (height, -outward),
        _ if to_edge > 0.0 => (to_edge, offset / to_edge),
        _ => (0.0, -outward),
    };
    let is_face = direction.dot(normal).abs() > NORMAL_COSINE_MIN;
    let direction = match is_face {
        true if direction.dot(normal) < 0.0 => -normal,
        true => normal,
        false => direction,
    };
    (raw.local_n1, raw.local_n2) = (direction, pos12.rotation.inverse() * -direction);
    let bound = dist - capsule.radius;
    if bound > prediction {
        return Some(bound);
    }
    if is_face {
        add_face(pos12, capsule, &polytope, direction, prediction, raw);
    }
    if raw.points.is_empty() {
        let p1 = to_edges.on_axis + direction * capsule.radius;
        let p2 = pos12.inverse_transform_point(to_edges.on_triangle);
        raw.points.push(RawPoint::new(p1, p2, feature::face(0), to_edges.edge, bound));
    }
    Some(bound.max(0.0))
}

/// Distance of the part of the axis above or below the face, 0 if it passes through, and whether it is below.
/// `None` if there is no such part. An axis that passes through leaves on the side of its longer end.
fn nearest_to_face(
    axis: [Vector; 2],
    corners: [Vector; 3],
    normal: Vector,
    heights: [Real; 2],
) -> Option<(Real, bool)> {
    let is_inside = |point: Vector| {
        (0..3).all(|index| {
            let along = corners[(index + 1) % 3] - corners[index];
            along.cross(point - corners[index]).dot(normal) >= 0.0
        })
    };
    if heights[0] * heights[1] < 0.0 {
        let fraction = heights[0] / (heights[0] - heights[1]);
        if is_inside(axis[0] + (axis[1] - axis[0]) * fraction) {
            return Some((0.0, heights[0] + heights[1] < 0.0));
        }
    }
    let ends = (0..2).filter(|&end| is_inside(axis[end]));
    let nearest = ends.min_by(|&a, &b| heights[a].abs().total_cmp(&heights[b].abs()))?;
    Some((heights[nearest].abs(), heights[nearest] < 0.0))
}

/// The points of the axis and the edges that are nearest to each other.
fn nearest_to_edges([start, end]: [Vector; 2], corners: [Vector; 3]) -> Nearest {
    let mut best = (Real::INFINITY, Vector::ZERO, Vector::ZERO, 0);
    for index in 0..3 {
        let ends = [corners[index], corners[(index + 1) % 3]];
        let (p1, p2) = nearest_of_segments([start, end], ends);
        let distance_squared = p1.distance_squared(p2);
        if distance_squared < best.0 {
            best = (distance_squared, p1, p2, index as u32);
        }
    }
    let (_, on_axis, on_triangle, index) = best;
    Nearest { on_axis, on_triangle, edge: feature::edge(index) }
}

/// The nearest points of two segments.
fn nearest_of_segments([p1, q1]: [Vector; 2], [p2, q2]: [Vector; 2]) -> (Vector, Vector) {
    let (along1, along2) = (q1 - p1, q2 - p2);
    let segments = Segments::new([p1, p2], [along1, along2]);
    let [fraction1, fraction2] = segments.nearest_from(segments.crossing());
    (p1 + along1 * fraction1, p2 + along2 * fraction2)
}

/// Adds both ends of the part of the axis that is above the face. `direction` is from the capsule to the
/// face.
fn add_face(
    pos12: &Pose,
    capsule: &Capsule,
    triangle: &Polytope<'_>,
    direction: Vector,
    prediction: Real,
    raw: &mut RawManifold,
) {
    let pos21 = pos12.inverse();
    let Some(face) = triangle.face_toward(pos21.rotation * -direction) else { return };
    let other = &Polytope::Segment(&capsule.segment);
    let contact = FaceContact { polytope: triangle, face, other, pose: &pos21 };
    let _ = clip_faces(&contact, prediction + capsule.radius, true, raw);
    for point in &mut raw.points {
        point.local_p1 += direction * capsule.radius;
        point.dist -= capsule.radius;
    }
}
