//! The overlap of two faces of polytopes: two points at most.

use super::polytope::{Face, Polytope};
use super::{RawManifold, RawPoint};
use crate::dim::math::{Pose, Real};

/// Points outside a face by up to this fraction of the shorter face still count as inside. Faces of equal
/// size meet often, and rounding must not determine their ends. Points above the deepest by the same fraction
/// count as equally deep.
pub(super) const RIM_FRACTION_MAX: Real = 5.0e-3;

/// A face, whose normal is the contact normal, and the polytope that it meets.
pub struct FaceContact<'a> {
    /// The polytope with the face.
    pub polytope: &'a Polytope<'a>,
    /// The face.
    pub face: Face,
    /// The other polytope.
    pub other: &'a Polytope<'a>,
    /// Its pose in the frame of the face.
    pub pose: &'a Pose,
}

/// The deepest point of an overlap.
pub struct Deepest {
    /// Its distance from the face.
    pub dist: Real,
    /// Minimum additional depth of another relevant point.
    pub tolerance: Real,
}

/// Adds the ends of the overlap that are within `prediction` above the face; `None` if there is no
/// overlap. `flipped`: the face is the second shape's.
pub fn clip_faces(
    contact: &FaceContact<'_>,
    prediction: Real,
    flipped: bool,
    raw: &mut RawManifold,
) -> Option<Deepest> {
    let normal = contact.face.normal;
    let other_face = contact.other.face_toward(contact.pose.rotation.inverse() * -normal)?;
    let ends = contact.polytope.corners(contact.face.id);
    let other_ends = contact.other.corners(other_face.id);
    let along = normal.perp(); // counter-clockwise, as the face
    let range = ends.map(|end| along.dot(end.point));
    let other_length = other_ends[0].point.distance(other_ends[1].point);
    let rim = RIM_FRACTION_MAX * (range[1] - range[0]).min(other_length);
    let points = other_ends.map(|end| *contact.pose * end.point);
    let places = points.map(|point| along.dot(point));
    if places[0].max(places[1]) < range[0] - rim || places[0].min(places[1]) > range[1] + rim {
        return None; // The projections are disjoint.
    }
    let inverse = contact.pose.inverse();
    let mut deepest = Real::INFINITY;
    for index in 0..2 {
        let face = contact.polytope.face_feature(contact.face.id);
        let (mut point, mut id, mut other_id) = (points[index], face, other_ends[index].vertex);
        // The end of the face, if any, that cuts the other face off here.
        let is_before = places[index] < range[0] - rim;
        if is_before || places[index] > range[1] + rim {
            let end = usize::from(!is_before);
            let fraction = (range[end] - places[index]) / (places[1 - index] - places[index]);
            // The other end may lie on the rim, where the fraction would be outside of 0 to 1.
            let fraction = fraction.clamp(0.0, 1.0);
            point += (points[1 - index] - point) * fraction;
            (id, other_id) = (ends[end].vertex, contact.other.face_feature(other_face.id));
        }
        let dist = normal.dot(point) - contact.face.offset;
        deepest = deepest.min(dist);
        if dist <= prediction {
            let (on_face, on_other) = (point - normal * dist, inverse * point);
            raw.points.push(RawPoint::flipped(on_face, on_other, id, other_id, dist, flipped));
        }
    }
    Some(Deepest { dist: deepest, tolerance: rim })
}
