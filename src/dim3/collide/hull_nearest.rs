//! The place on a convex hull that is nearest to a point.
//!
//! Inside, it is on the face that is least deep. Outside, it is on a face that is visible from the point. If
//! the point projects into the face with the largest distance, it is there, else at the rim of that face or
//! on another one. Faces are skipped if the point's height above them exceeds its distance from the place
//! that was found.
//!
//! parry makes one face of nearly coplanar neighbours, and its tolerance is large for thin hulls. Such a face
//! bulges through the plane of its normal. The place is therefore checked: no corner of the hull may be above
//! the plane through it. Otherwise a general closest-point search is used.

use crate::base::feature;
use crate::base::nearest::{Nearest, direction_and_length};
use crate::dim::math::{Real, Vector};
use parry::shape::{ConvexPolyhedron, PackedFeatureId, TypedShape};
use smallvec::SmallVec;

/// The nearest point, if the shape is a hull with sufficiently flat faces. If it is surely farther than
/// `reach`, a place in whose plane the hull is apart from the point will do.
pub fn nearest_on_hull(shape: TypedShape<'_>, point: Vector, reach: Real) -> Option<Nearest> {
    let TypedShape::ConvexPolyhedron(hull) = shape else { return None };
    Some(nearest_by_faces(hull, point, reach)).filter(|nearest| nearest.is_proven_by(hull.points()))
}

fn nearest_by_faces(hull: &ConvexPolyhedron, point: Vector, reach: Real) -> Nearest {
    let mut visible = SmallVec::<[(usize, Real); 32]>::new();
    let mut top = (0, Real::NEG_INFINITY);
    for face in 0..hull.faces().len() {
        let height = height(hull, face, point);
        if height > top.1 {
            top = (face, height);
        }
        if height > 0.0 {
            visible.push((face, height));
        }
    }
    let mut best = on_face(hull, top.0, top.1, point);
    if best.is_inside || top.1 > reach {
        return on_plane(hull, top, point);
    }
    for (face, height) in visible {
        if face != top.0 && height * height < best.distance_squared {
            let found = on_face(hull, face, height, point);
            if found.distance_squared < best.distance_squared {
                best = found;
            }
        }
    }
    let (normal, dist) = direction_and_length(point - best.place, hull.faces()[top.0].normal);
    Nearest { point: best.place, normal, dist, feature: best.feature }
}

/// The place below a point in the plane of a face, above which it is so high.
fn on_plane(hull: &ConvexPolyhedron, (face, height): (usize, Real), point: Vector) -> Nearest {
    let normal = hull.faces()[face].normal;
    let feature = feature::face(face as u32);
    Nearest { point: point - normal * height, normal, dist: height, feature }
}

/// Height of a point above a face.
fn height(hull: &ConvexPolyhedron, face: usize, point: Vector) -> Real {
    let face = &hull.faces()[face];
    let corner = hull.vertices_adj_to_face()[face.first_vertex_or_edge as usize];
    face.normal.dot(point - hull.points()[corner as usize])
}

/// A place on a face.
#[derive(Copy, Clone)]
struct OnFace {
    place: Vector,
    distance_squared: Real,
    feature: PackedFeatureId,
    /// Whether it is within the face, not at its rim.
    is_inside: bool,
}

/// The place on a face that is nearest to a point above it.
///
/// In the plane of the face, the nearest point of a convex polygon lies on a side that the point is beyond.
/// There may be none. Below the face (then all others are deeper) only the plane matters.
fn on_face(hull: &ConvexPolyhedron, id: usize, height: Real, point: Vector) -> OnFace {
    let face = &hull.faces()[id];
    let (first, count) = (face.first_vertex_or_edge as usize, face.num_vertices_or_edges as usize);
    let vertices = &hull.vertices_adj_to_face()[first..first + count];
    let edges = &hull.edges_adj_to_face()[first..first + count];
    let mut best = OnFace {
        place: point - face.normal * height,
        distance_squared: height * height,
        feature: feature::face(id as u32),
        is_inside: true,
    };
    if height <= 0.0 {
        return best;
    }
    for (index, &vertex) in vertices.iter().enumerate() {
        let next = vertices[if index + 1 < count { index + 1 } else { 0 }];
        let start = hull.points()[vertex as usize];
        let along = hull.points()[next as usize] - start;
        if along.cross(face.normal).dot(point - start) <= 0.0 {
            continue;
        }
        let fraction = along.dot(point - start) / along.length_squared();
        let (place, feature) = match fraction {
            fraction if fraction >= 1.0 => (start + along, feature::vertex(next)),
            fraction if fraction > 0.0 => (start + along * fraction, feature::edge(edges[index])),
            _ => (start, feature::vertex(vertex)),
        };
        let distance_squared = place.distance_squared(point);
        if best.is_inside || distance_squared < best.distance_squared {
            best = OnFace { place, distance_squared, feature, is_inside: false };
        }
    }
    best
}
