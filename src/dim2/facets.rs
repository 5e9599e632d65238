//! Convex shapes with flat faces, as a moving point meets them: lines, and the corners between them.

use super::math::{Real, Vector};
use parry::shape::{ConvexPolygon, TypedShape};

/// A convex polygon.
#[derive(Copy, Clone)]
pub struct Facets<'a>(&'a ConvexPolygon);

/// A face. The product of an inside point and the normal is at most `offset`.
#[derive(Copy, Clone)]
pub struct Facet {
    /// Unit outward normal.
    pub normal: Vector,
    /// Distance (length units) of the face from the origin along the normal.
    pub offset: Real,
}

impl<'a> Facets<'a> {
    /// The facets of a shape, and how thick (length units) the layer around them is.
    pub fn of(shape: TypedShape<'a>) -> Option<(Self, Real)> {
        Some(match shape {
            TypedShape::ConvexPolygon(polygon) => (Self(polygon), 0.0),
            TypedShape::RoundConvexPolygon(round) => {
                (Self(&round.inner_shape), round.border_radius)
            }
            _ => return None,
        })
    }

    /// Returns whether the shape has no interior, so that it consists of the layer around it. A polygon
    /// always has an interior.
    pub fn is_flat(&self) -> bool {
        false
    }

    /// Number of faces.
    pub fn len(&self) -> usize {
        self.0.normals().len()
    }

    /// A face by its number.
    #[inline]
    pub fn facet(&self, index: usize) -> Facet {
        let [from, to] = self.ends(index);
        let (stored, along) = (self.0.normals()[index], to - from);
        // parry leaves out corners between lines that are nearly one, up to more than a degree, and keeps the
        // normal of one of the two.
        let is_right = stored.dot(along).abs() <= 64.0 * Real::EPSILON * along.length();
        let across = Vector::new(along.y, -along.x);
        let normal = if is_right { stored } else { across.normalize_or(stored) };
        Facet { normal, offset: normal.dot(from) }
    }

    /// The ends of a face.
    fn ends(&self, index: usize) -> [Vector; 2] {
        let points = self.0.points();
        let next = if index + 1 < points.len() { index + 1 } else { 0 };
        [points[index], points[next]]
    }

    /// Returns whether a point is right above or below a face.
    pub fn is_over(&self, index: usize, point: Vector) -> bool {
        let [from, to] = self.ends(index);
        let along = to - from;
        (0.0..=along.length_squared()).contains(&along.dot(point - from))
    }

    /// Number of borders between faces.
    pub fn border_count(&self) -> usize {
        self.0.points().len()
    }

    /// The ends of a border between faces: a corner, twice.
    pub fn border(&self, index: usize) -> [Vector; 2] {
        [self.0.points()[index]; 2]
    }
}
