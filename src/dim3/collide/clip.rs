//! The overlap of two faces of polytopes.
//!
//! Sutherland and Hodgman 1974: one polygon is cut by the planes through the edges of the other, one after
//! the other. Each remaining edge stores whether it is an edge of the cut polygon or lies in one of the
//! planes. The two edges of a corner define its features.

use super::polytope::{Corner, Corners, Face, Polytope};
use super::{RawManifold, RawPoint};
use crate::base::feature;
use crate::dim::math::{Pose, Real, Vector};
use arrayvec::ArrayVec;
use parry::shape::PackedFeatureId;

/// Points outside a face by up to this fraction of its edge, or of the other face's longest if that is
/// shorter, still count as inside. Faces of equal size meet often, and rounding must not determine their
/// corners. Points above the deepest by the same fraction count as equally deep.
pub(super) const RIM_FRACTION_MAX: Real = 5.0e-3;
/// Maximum number of corners of an overlap.
const OVERLAP_VERTICES_MAX: usize = 64;

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

/// An edge of the overlap: which edge of the cut polygon, or of the cutting one, it is a part of.
#[derive(Copy, Clone)]
enum Edge {
    Cut(u8),
    Cutting(u8),
}

/// A corner of the overlap and the edge that follows it.
#[derive(Copy, Clone)]
struct Vertex {
    point: Vector,
    edge: Edge,
}

type Overlap = ArrayVec<Vertex, OVERLAP_VERTICES_MAX>;

/// Adds the corners of the overlap that are within `prediction` above the face; `None` if there is no
/// overlap. `flipped`: the face is the second shape's.
pub fn clip_faces(
    contact: &FaceContact<'_>,
    prediction: Real,
    flipped: bool,
    raw: &mut RawManifold,
) -> Option<Deepest> {
    if let Polytope::Segment(segment) = contact.other {
        return clip_line(contact, [segment.a, segment.b], prediction, flipped, raw);
    }
    let normal = contact.face.normal;
    let other_face = contact.other.face_toward(contact.pose.rotation.inverse() * -normal)?;
    let cutting = contact.polytope.corners(contact.face.id);
    let cut = contact.other.corners(other_face.id);
    let rim_max = RIM_FRACTION_MAX * longest_edge(&cut);
    let vertex = |(index, corner): (usize, &Corner)| Vertex {
        point: *contact.pose * corner.point,
        edge: Edge::Cut(index as u8),
    };
    // Two buffers take turns.
    let (mut from, mut to) = (&mut Overlap::new(), &mut Overlap::new());
    from.extend(cut.iter().enumerate().map(vertex));
    for index in 0..cutting.len() {
        let side = [cutting[index].point, cutting[(index + 1) % cutting.len()].point];
        let outward = (side[1] - side[0]).cross(normal);
        cut_by(from, Side { index: index as u8, corner: side[0], outward, rim_max }, to);
        (from, to) = (to, from);
    }
    let overlap = from;
    let names = Names {
        cutting: &cutting,
        cut: &cut,
        cutting_face: contact.polytope.face_feature(contact.face.id),
        cut_face: contact.other.face_feature(other_face.id),
    };
    let inverse = contact.pose.inverse();
    let mut deepest = Real::INFINITY;
    let mut last = overlap.last()?.edge;
    for vertex in overlap {
        let dist = normal.dot(vertex.point) - contact.face.offset;
        deepest = deepest.min(dist);
        if dist <= prediction {
            let (id, other_id) = names.of(last, vertex.edge);
            let on_face = vertex.point - normal * dist;
            let on_other = inverse * vertex.point;
            raw.points.push(RawPoint::flipped(on_face, on_other, id, other_id, dist, flipped));
        }
        last = vertex.edge;
    }
    Some(Deepest { dist: deepest, tolerance: tolerance(&cutting).min(rim_max) })
}

/// The length of the longest edge of a face.
fn longest_edge(face: &Corners) -> Real {
    let next = |index: usize| face[(index + 1) % face.len()].point;
    let edges =
        face.iter().enumerate().map(|(index, corner)| corner.point.distance_squared(next(index)));
    edges.fold(0.0, Real::max).sqrt()
}

/// The distance outside of a side at which points still count as inside, multiplied by the length of the
/// side, as `outward` is.
fn rim(outward: Vector, rim_max: Real) -> Real {
    let squared = outward.length_squared();
    let own = RIM_FRACTION_MAX * squared;
    if RIM_FRACTION_MAX * own <= rim_max * rim_max { own } else { rim_max * squared.sqrt() }
}

/// Minimum additional depth of another relevant point of the other polytope.
fn tolerance(face: &Corners) -> Real {
    match face.as_slice() {
        [first, second, ..] => RIM_FRACTION_MAX * first.point.distance(second.point),
        _ => 0.0,
    }
}

/// The part of a segment above the face, as [`clip_faces`].
///
/// Cyrus and Beck 1978: the segment is a parameter range, which each side of the face cuts.
fn clip_line(
    contact: &FaceContact<'_>,
    ends: [Vector; 2],
    prediction: Real,
    flipped: bool,
    raw: &mut RawManifold,
) -> Option<Deepest> {
    let normal = contact.face.normal;
    let cutting = contact.polytope.corners(contact.face.id);
    let [start, end] = ends.map(|end| *contact.pose * end);
    let face = contact.polytope.face_feature(contact.face.id);
    let rim_max = RIM_FRACTION_MAX * start.distance(end);
    let mut range = [0.0, 1.0];
    let mut names = [0, 1].map(|end| (face, feature::vertex(end)));
    for (index, corner) in cutting.iter().enumerate() {
        let outward = (cutting[(index + 1) % cutting.len()].point - corner.point).cross(normal);
        let rim = rim(outward, rim_max);
        let [from, to] = [start, end].map(|point| outward.dot(point - corner.point) - rim);
        if from > 0.0 && to > 0.0 {
            return None;
        }
        let (crossing, name) = (from / (from - to), (corner.edge(), feature::edge(0)));
        if from > 0.0 && crossing > range[0] {
            (range[0], names[0]) = (crossing, name);
        } else if to > 0.0 && crossing < range[1] {
            (range[1], names[1]) = (crossing, name);
        }
    }
    if range[0] > range[1] {
        return None;
    }
    let mut deepest = Real::INFINITY;
    for (fraction, (id, other_id)) in range.into_iter().zip(names) {
        let point = start + (end - start) * fraction;
        let dist = normal.dot(point) - contact.face.offset;
        deepest = deepest.min(dist);
        if dist <= prediction {
            let (on_face, on_other) =
                (point - normal * dist, ends[0] + (ends[1] - ends[0]) * fraction);
            raw.points.push(RawPoint::flipped(on_face, on_other, id, other_id, dist, flipped));
        }
    }
    Some(Deepest { dist: deepest, tolerance: tolerance(&cutting).min(rim_max) })
}

/// A side of the face that cuts the other one.
struct Side {
    index: u8,
    /// The corner at which it begins.
    corner: Vector,
    /// Its outward normal, as long as the side.
    outward: Vector,
    /// Largest distance outside at which points count as inside.
    rim_max: Real,
}

/// Writes to `result` the part of a polygon inside a side.
fn cut_by(polygon: &Overlap, side: Side, result: &mut Overlap) {
    let Side { index, corner, outward, rim_max } = side;
    let rim = rim(outward, rim_max);
    let height = |vertex: &Vertex| outward.dot(vertex.point - corner);
    result.clear();
    let Some(first) = polygon.first() else { return };
    let height_first = height(first);
    let mut height_from = height_first;
    for (position, from) in polygon.iter().enumerate() {
        let next = polygon.get(position + 1);
        let (to, height_to) = next.map_or((first, height_first), |next| (next, height(next)));
        let crossing = || {
            let fraction = (height_from / (height_from - height_to)).clamp(0.0, 1.0);
            from.point + (to.point - from.point) * fraction
        };
        let (leaves, is_deep) = (height_to > rim, height_from < 0.0);
        if height_from <= rim {
            // A corner on the rim that the polygon leaves the plane at is the crossing itself.
            let edge = if leaves && !is_deep { Edge::Cutting(index) } else { from.edge };
            push(result, from.point, edge);
        }
        if leaves && is_deep {
            push(result, crossing(), Edge::Cutting(index));
        } else if height_from > rim && height_to < 0.0 {
            push(result, crossing(), from.edge);
        }
        height_from = height_to;
    }
}

fn push(polygon: &mut Overlap, point: Vector, edge: Edge) {
    // Two faces of this size have no more corners than the capacity.
    let _ = polygon.try_push(Vertex { point, edge });
}

/// Names of the edges of the overlap.
struct Names<'a> {
    cutting: &'a Corners,
    cut: &'a Corners,
    cutting_face: PackedFeatureId,
    cut_face: PackedFeatureId,
}

impl Names<'_> {
    /// The features of the cutting and the cut polytope where two edges meet.
    fn of(&self, before: Edge, after: Edge) -> (PackedFeatureId, PackedFeatureId) {
        let (cut, cutting) = (
            |index: u8| self.cut[usize::from(index)],
            |index: u8| self.cutting[usize::from(index)],
        );
        match (before, after) {
            (Edge::Cut(_), Edge::Cut(index)) => (self.cutting_face, cut(index).vertex()),
            (Edge::Cut(edge), Edge::Cutting(side)) | (Edge::Cutting(side), Edge::Cut(edge)) => {
                (cutting(side).edge(), cut(edge).edge())
            }
            (Edge::Cutting(side1), Edge::Cutting(side2)) => {
                // The corner where the later of two neighbouring sides begins.
                let (first, last) = (side1.min(side2), side1.max(side2));
                let is_wrap = first == 0 && usize::from(last) + 1 == self.cutting.len();
                (cutting(if is_wrap { 0 } else { last }).vertex(), self.cut_face)
            }
        }
    }
}
