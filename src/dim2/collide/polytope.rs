//! Convex shapes with flat faces: boxes, polygons, triangles, and segments, which have two.

use super::features::box_feature;
use crate::base::feature;
use crate::dim::math::{Real, Vector};
use parry::shape::{
    ConvexPolygon, Cuboid, PackedFeatureId, Segment, Shape, SupportMap, Triangle, TypedShape,
};

/// A convex shape with flat faces.
#[derive(Copy, Clone)]
pub enum Polytope<'a> {
    /// A box.
    Cuboid(&'a Cuboid),
    /// A convex polygon.
    Hull(&'a ConvexPolygon),
    /// A triangle, and whether its corners come counter-clockwise.
    Triangle(&'a Triangle, bool),
    /// A segment: one face for each direction.
    Segment(&'a Segment),
}

/// A face of a polytope, in the polytope's frame.
#[derive(Copy, Clone)]
pub struct Face {
    /// Its number.
    pub id: usize,
    /// Unit outward normal.
    pub normal: Vector,
    /// Distance from the origin along the normal.
    pub offset: Real,
}

/// An edge between two faces. 2D polytopes have no edges between faces.
#[derive(Copy, Clone)]
pub struct Edge {
    /// Its ends.
    pub ends: [Vector; 2],
    /// Its feature.
    pub feature: PackedFeatureId,
}

/// An end of a face.
#[derive(Copy, Clone)]
pub(super) struct Corner {
    /// Its position.
    pub point: Vector,
    /// Its feature.
    pub vertex: PackedFeatureId,
}

impl<'a> Polytope<'a> {
    /// The polytope that a shape is, and how thick (length units) the layer around it is; `None` if it
    /// is none, or has no inside.
    pub fn of(shape: &'a dyn Shape) -> Option<(Self, Real)> {
        let oriented = |triangle: &'a Triangle| {
            let area = (triangle.b - triangle.a).perp_dot(triangle.c - triangle.a);
            (area != 0.0).then_some(Self::Triangle(triangle, area > 0.0))
        };
        Some(match shape.as_typed_shape() {
            TypedShape::Cuboid(cuboid) => (Self::Cuboid(cuboid), 0.0),
            TypedShape::ConvexPolygon(polygon) => (Self::Hull(polygon), 0.0),
            TypedShape::Triangle(triangle) => (oriented(triangle)?, 0.0),
            TypedShape::Segment(segment) => (Self::Segment(segment), 0.0),
            TypedShape::Capsule(capsule) => (Self::Segment(&capsule.segment), capsule.radius),
            TypedShape::RoundCuboid(round) => {
                (Self::Cuboid(&round.inner_shape), round.border_radius)
            }
            TypedShape::RoundConvexPolygon(round) => {
                (Self::Hull(&round.inner_shape), round.border_radius)
            }
            TypedShape::RoundTriangle(round) => {
                (oriented(&round.inner_shape)?, round.border_radius)
            }
            _ => return None,
        })
    }

    /// Returns whether a point is between the lines across the ends of a face.
    pub fn is_above(&self, face: &Face, point: Vector) -> bool {
        let along = face.normal.perp(); // counter-clockwise, as the face
        let [start, end] = self.corners(face.id).map(|end| along.dot(end.point));
        (start..=end).contains(&along.dot(point))
    }

    /// Returns whether it is a box without thickness.
    pub fn is_flat_box(&self) -> bool {
        matches!(self, Self::Cuboid(cuboid) if cuboid.half_extents.min_element() == 0.0)
    }

    /// The shape, for searches of closest points.
    pub fn as_support(&self) -> &'a dyn SupportMap {
        match *self {
            Self::Cuboid(cuboid) => cuboid,
            Self::Hull(polygon) => polygon,
            Self::Triangle(triangle, _) => triangle,
            Self::Segment(segment) => segment,
        }
    }

    /// The point that is farthest along a direction.
    #[inline]
    pub fn support(&self, direction: Vector) -> Vector {
        match self {
            Self::Cuboid(cuboid) => cuboid.half_extents.copysign(direction),
            Self::Hull(polygon) => polygon.local_support_point(direction),
            Self::Triangle(triangle, _) => triangle.local_support_point(direction),
            Self::Segment(segment) => segment.local_support_point(direction),
        }
    }

    /// The face whose normal is closest to a direction; `None` if there are no faces, as of a segment
    /// without length.
    pub fn face_toward(&self, direction: Vector) -> Option<Face> {
        Some(match *self {
            Self::Cuboid(cuboid) => {
                let axis = direction.abs().max_position();
                let is_negative = direction[axis] < 0.0;
                let normal = if is_negative { -Vector::AXES[axis] } else { Vector::AXES[axis] };
                let id = 2 * axis + usize::from(is_negative);
                Face { id, normal, offset: cuboid.half_extents[axis] }
            }
            Self::Hull(polygon) => {
                let (id, normal) = best_normal(polygon.normals().iter().copied(), direction);
                Face { id, normal, offset: normal.dot(polygon.points()[id]) }
            }
            Self::Triangle(..) => {
                let normals = (0..3).map(|id| {
                    let [start, end] = self.corners(id);
                    let along = end.point - start.point;
                    Vector::new(along.y, -along.x).normalize_or_zero()
                });
                let (id, normal) = best_normal(normals, direction);
                Face { id, normal, offset: normal.dot(self.corners(id)[0].point) }
            }
            Self::Segment(segment) => {
                let along = (segment.b - segment.a).try_normalize()?;
                let right = Vector::new(along.y, -along.x);
                let is_left = right.dot(direction) < 0.0;
                let normal = if is_left { -right } else { right };
                Face { id: usize::from(is_left), normal, offset: normal.dot(segment.a) }
            }
        })
    }

    /// There are no edges between faces in the plane.
    pub fn edge_toward(&self, _direction: Vector) -> Option<Edge> {
        None
    }

    /// The feature of a face as a whole.
    pub(super) fn face_feature(&self, id: usize) -> PackedFeatureId {
        match self {
            Self::Cuboid(_) => box_feature(box_face(id)),
            _ => feature::face(id as u32),
        }
    }

    /// Calls `f` with the ends of the face along a direction.
    pub fn for_each_corner_toward(
        &self,
        direction: Vector,
        mut f: impl FnMut(Vector, PackedFeatureId),
    ) {
        if let Some(face) = self.face_toward(direction) {
            self.corners(face.id).iter().for_each(|corner| f(corner.point, corner.vertex));
        }
    }

    /// The two ends of a face, counter-clockwise.
    pub(super) fn corners(&self, id: usize) -> [Corner; 2] {
        match *self {
            Self::Cuboid(cuboid) => {
                let normal = box_face(id);
                let along = normal.perp();
                [-1.0, 1.0].map(|end| {
                    let at = normal + along * end;
                    Corner { point: at * cuboid.half_extents, vertex: box_feature(at) }
                })
            }
            Self::Hull(polygon) => {
                let points = polygon.points();
                [id, (id + 1) % points.len()].map(|index| named(points[index], index))
            }
            Self::Triangle(triangle, is_counter_clockwise) => {
                let points = [triangle.a, triangle.b, triangle.c];
                let ends = [id, (id + 1) % 3].map(|index| named(points[index], index));
                if is_counter_clockwise { ends } else { [ends[1], ends[0]] }
            }
            Self::Segment(segment) => {
                let ends = [named(segment.a, 0), named(segment.b, 1)];
                if id == 0 { ends } else { [ends[1], ends[0]] }
            }
        }
    }
}

fn named(point: Vector, index: usize) -> Corner {
    Corner { point, vertex: feature::vertex(index as u32) }
}

/// The outward normal of a face of a box.
fn box_face(id: usize) -> Vector {
    if id % 2 == 1 { -Vector::AXES[id / 2] } else { Vector::AXES[id / 2] }
}

fn best_normal(normals: impl Iterator<Item = Vector>, direction: Vector) -> (usize, Vector) {
    let mut best = (0, Vector::ZERO, Real::NEG_INFINITY);
    for (id, normal) in normals.enumerate() {
        let cosine = normal.dot(direction);
        if cosine > best.2 {
            best = (id, normal, cosine);
        }
    }
    (best.0, best.1)
}
