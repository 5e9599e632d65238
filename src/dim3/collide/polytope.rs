//! Convex shapes with flat faces: boxes, hulls and triangles. And segments, which have none.

use super::cuboid::unit;
use super::features::{box_feature, box_number};
use crate::base::feature;
use crate::dim::math::{Real, Vector};
use arrayvec::ArrayVec;
use parry::shape::{
    ConvexPolyhedron, Cuboid, PackedFeatureId, Segment, Shape, SupportMap, Triangle, TypedShape,
};

/// Largest number of corners of a face. Faces with more corners lose some of them evenly.
const CORNERS_MAX: usize = 32;

/// A convex shape with flat faces.
#[derive(Copy, Clone)]
pub enum Polytope<'a> {
    /// A box.
    Cuboid(&'a Cuboid),
    /// A convex hull.
    Hull(&'a ConvexPolyhedron),
    /// A triangle with its unit normal: a hull with two faces.
    Triangle(&'a Triangle, Vector),
    /// A segment: an edge without faces.
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

/// An edge of a polytope, in the polytope's frame.
#[derive(Copy, Clone)]
pub struct Edge {
    /// Its ends.
    pub ends: [Vector; 2],
    /// Its feature.
    pub feature: PackedFeatureId,
}

/// A corner of a face. Few corners become contacts, so features are named when they do.
#[derive(Copy, Clone)]
pub(super) struct Corner {
    /// Its position.
    pub point: Vector,
    /// The number of its feature, and that of the edge to the next corner.
    numbers: [u32; 2],
}

impl Corner {
    /// Its feature.
    pub fn vertex(&self) -> PackedFeatureId {
        feature::vertex(self.numbers[0])
    }

    /// The feature of the edge to the next corner.
    pub fn edge(&self) -> PackedFeatureId {
        feature::edge(self.numbers[1])
    }
}

/// The corners of a face, counter-clockwise as seen from outside.
pub(super) type Corners = ArrayVec<Corner, CORNERS_MAX>;

impl<'a> Polytope<'a> {
    /// The polytope of a shape, and the thickness (length units) of the layer around it. `None` if it is no
    /// polytope, or has neither interior nor normal.
    pub fn of(shape: &'a dyn Shape) -> Option<(Self, Real)> {
        let flat = |triangle: &'a Triangle| Some(Self::Triangle(triangle, triangle.normal()?));
        Some(match shape.as_typed_shape() {
            TypedShape::Cuboid(cuboid) => (Self::Cuboid(cuboid), 0.0),
            TypedShape::ConvexPolyhedron(hull) => (Self::Hull(hull), 0.0),
            TypedShape::Triangle(triangle) => (flat(triangle)?, 0.0),
            TypedShape::Segment(segment) => (Self::Segment(segment), 0.0),
            TypedShape::Capsule(capsule) => (Self::Segment(&capsule.segment), capsule.radius),
            TypedShape::RoundCuboid(round) => {
                (Self::Cuboid(&round.inner_shape), round.border_radius)
            }
            TypedShape::RoundConvexPolyhedron(round) => {
                (Self::Hull(&round.inner_shape), round.border_radius)
            }
            TypedShape::RoundTriangle(round) => (flat(&round.inner_shape)?, round.border_radius),
            _ => return None,
        })
    }

    /// Returns whether it is a box without thickness.
    pub fn is_flat_box(&self) -> bool {
        matches!(self, Self::Cuboid(cuboid) if cuboid.half_extents.min_element() == 0.0)
    }

    /// Returns whether a point is between the planes through the sides of a face.
    pub fn is_above(&self, face: &Face, point: Vector) -> bool {
        let corners = self.corners(face.id);
        let is_inside = |[corner, next]: [Vector; 2]| {
            (next - corner).cross(face.normal).dot(point - corner) <= 0.0
        };
        let next = |index: usize| corners[(index + 1) % corners.len()].point;
        corners.iter().enumerate().all(|(index, corner)| is_inside([corner.point, next(index)]))
    }

    /// The shape, for searches of closest points.
    pub fn as_support(&self) -> &'a dyn SupportMap {
        match *self {
            Self::Cuboid(cuboid) => cuboid,
            Self::Hull(hull) => hull,
            Self::Triangle(triangle, _) => triangle,
            Self::Segment(segment) => segment,
        }
    }

    /// The point that is farthest along a direction.
    #[inline]
    pub fn support(&self, direction: Vector) -> Vector {
        match self {
            Self::Cuboid(cuboid) => cuboid.half_extents.copysign(direction),
            Self::Hull(hull) => hull.local_support_point(direction),
            Self::Triangle(triangle, _) => triangle.local_support_point(direction),
            Self::Segment(segment) => segment.local_support_point(direction),
        }
    }

    /// The face whose normal is closest to a direction; `None` if there are no faces.
    pub fn face_toward(&self, direction: Vector) -> Option<Face> {
        Some(match *self {
            Self::Cuboid(cuboid) => {
                let axis = direction.abs().max_position();
                let is_negative = direction[axis] < 0.0;
                let normal = if is_negative { -unit(axis) } else { unit(axis) };
                let id = 2 * axis + usize::from(is_negative);
                Face { id, normal, offset: cuboid.half_extents[axis] }
            }
            Self::Hull(hull) => {
                let mut best = (0, Real::NEG_INFINITY);
                for (id, face) in hull.faces().iter().enumerate() {
                    let cosine = face.normal.dot(direction);
                    if cosine > best.1 {
                        best = (id, cosine);
                    }
                }
                let face = &hull.faces()[best.0];
                let vertex = hull.vertices_adj_to_face()[face.first_vertex_or_edge as usize];
                let offset = face.normal.dot(hull.points()[vertex as usize]);
                Face { id: best.0, normal: face.normal, offset }
            }
            Self::Triangle(triangle, normal) => {
                let is_back = normal.dot(direction) < 0.0;
                let normal = if is_back { -normal } else { normal };
                Face { id: usize::from(is_back), normal, offset: normal.dot(triangle.a) }
            }
            Self::Segment(_) => return None,
        })
    }

    /// The edge that is farthest along a direction: the one at the farthest corner that falls off
    /// least.
    pub fn edge_toward(&self, direction: Vector) -> Option<Edge> {
        match *self {
            Self::Cuboid(cuboid) => {
                let half = cuboid.half_extents;
                let axis = (direction * half).abs().min_position();
                let mut signs = Vector::ONE.copysign(direction);
                signs[axis] = 0.0;
                let (middle, along) = (signs * half, unit(axis) * half);
                Some(Edge { ends: [middle - along, middle + along], feature: box_feature(signs) })
            }
            Self::Hull(hull) => hull_edge(hull, direction),
            Self::Triangle(triangle, _) => {
                let points = [triangle.a, triangle.b, triangle.c];
                let heights = Vector::from_array(points.map(|point| point.dot(direction)));
                // Edge 0 is opposite of corner 2, and so on round.
                let id = (heights.min_position() + 1) % 3;
                let ends = [points[id], points[(id + 1) % 3]];
                Some(Edge { ends, feature: feature::edge(id as u32) })
            }
            Self::Segment(segment) => {
                Some(Edge { ends: [segment.a, segment.b], feature: feature::edge(0) })
            }
        }
    }

    /// The feature of a face as a whole.
    pub(super) fn face_feature(&self, id: usize) -> PackedFeatureId {
        match self {
            Self::Cuboid(_) => box_feature(box_face(id)),
            _ => feature::face(id as u32),
        }
    }

    /// Calls `f` with the corners of the face along a direction, or with the ends of a segment.
    pub fn for_each_corner_toward(
        &self,
        direction: Vector,
        mut f: impl FnMut(Vector, PackedFeatureId),
    ) {
        if let Self::Segment(segment) = self {
            f(segment.a, feature::vertex(0));
            f(segment.b, feature::vertex(1));
        } else if let Some(face) = self.face_toward(direction) {
            self.corners(face.id).iter().for_each(|corner| f(corner.point, corner.vertex()));
        }
    }

    /// The corners of a face.
    pub(super) fn corners(&self, id: usize) -> Corners {
        match *self {
            Self::Cuboid(cuboid) => box_corners(cuboid.half_extents, id),
            Self::Hull(hull) => hull_corners(hull, id),
            Self::Triangle(triangle, _) => triangle_corners(triangle, id == 1),
            Self::Segment(_) => Corners::new(),
        }
    }
}

/// The outward normal of a face of a box.
fn box_face(id: usize) -> Vector {
    if id % 2 == 1 { -unit(id / 2) } else { unit(id / 2) }
}

/// A corner of a box of half extents 1, with the numbers of the features.
type UnitCorner = ([Real; 3], [u32; 2]);

/// The corners of the six faces.
const BOX_CORNERS: [[UnitCorner; 4]; 6] = {
    let mut corners = [[([0.0; 3], [0; 2]); 4]; 6];
    let mut index = 0;
    while index < 24 {
        corners[index / 4][index % 4] = box_corner(index / 4, index % 4);
        index += 1;
    }
    corners
};

/// A corner of a face of a box, counter-clockwise as seen from outside.
const fn box_corner(face: usize, index: usize) -> UnitCorner {
    let (axis, is_negative) = (face / 2, face % 2 == 1);
    // Counter-clockwise about +axis; reversed for the negative face.
    let turn = if is_negative { [2, 1] } else { [1, 2] };
    let (u, v) = ((axis + turn[0]) % 3, (axis + turn[1]) % 3);
    let mut at = [0.0; 3];
    at[axis] = if is_negative { -1.0 } else { 1.0 };
    at[u] = if index == 0 || index == 3 { 1.0 } else { -1.0 };
    at[v] = if index < 2 { 1.0 } else { -1.0 };
    let mut along = at;
    along[if index.is_multiple_of(2) { u } else { v }] = 0.0;
    (at, [box_number(at), box_number(along)])
}

fn box_corners(half: Vector, id: usize) -> Corners {
    let corner =
        |(at, numbers): UnitCorner| Corner { point: Vector::from_array(at) * half, numbers };
    BOX_CORNERS[id].into_iter().map(corner).collect()
}

fn hull_edge(hull: &ConvexPolyhedron, direction: Vector) -> Option<Edge> {
    let points = hull.points();
    let mut top = (0, Real::NEG_INFINITY);
    for (index, point) in points.iter().enumerate() {
        let height = point.dot(direction);
        if height > top.1 {
            top = (index as u32, height);
        }
    }
    let mut best = (None, Real::NEG_INFINITY);
    for (id, edge) in hull.edges().iter().enumerate() {
        let [a, b] = edge.vertices;
        if a == top.0 || b == top.0 {
            let height = points[(a + b - top.0) as usize].dot(direction);
            if height > best.1 {
                best = (Some((id, [a, b])), height);
            }
        }
    }
    let (id, ends) = best.0?;
    let ends = ends.map(|end| points[end as usize]);
    Some(Edge { ends, feature: feature::edge(id as u32) })
}

fn hull_corners(hull: &ConvexPolyhedron, id: usize) -> Corners {
    let face = &hull.faces()[id];
    let (first, count) = (face.first_vertex_or_edge as usize, face.num_vertices_or_edges as usize);
    let vertices = &hull.vertices_adj_to_face()[first..first + count];
    let edges = &hull.edges_adj_to_face()[first..first + count];
    let kept = count.min(CORNERS_MAX);
    (0..kept)
        .map(|index| {
            let index = index * count / kept;
            Corner {
                point: hull.points()[vertices[index] as usize],
                numbers: [vertices[index], edges[index]],
            }
        })
        .collect()
}

fn triangle_corners(triangle: &Triangle, is_back: bool) -> Corners {
    let points = [triangle.a, triangle.b, triangle.c];
    // From behind, the order of the corners is reversed, but their names stay.
    let [order, edges] = if is_back { [[0, 2, 1], [2, 1, 0]] } else { [[0, 1, 2], [0, 1, 2]] };
    (0..3)
        .map(|index| Corner {
            point: points[order[index]],
            numbers: [order[index], edges[index]].map(|number| number as u32),
        })
        .collect()
}
