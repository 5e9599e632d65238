//! What the shapes are made of that only two dimensions have.

use super::math::{Real, Vector};
use crate::base::measure::Measure;
use parry::shape::TypedShape;
use smallvec::{SmallVec, smallvec};

/// The numbers that a shape is made of, for the shapes whose type depends on the dimension; nothing
/// for the others.
pub fn measures(shape: TypedShape<'_>) -> SmallVec<[Measure<'_>; 4]> {
    use Measure::{Coordinates, Lengths, Margin, Points};
    match shape {
        TypedShape::ConvexPolygon(c) => smallvec![Points("points", c.points())],
        TypedShape::RoundConvexPolygon(c) => smallvec![
            Points("points", c.inner_shape.points()),
            Margin("border_radius", c.border_radius)
        ],
        TypedShape::HeightField(h) => {
            smallvec![Coordinates("heights", h.heights()), Lengths("scale", h.scale())]
        }
        _ => SmallVec::new(),
    }
}

/// Largest distance from `center` to any point of the shape, exactly, for those of this dimension's
/// shapes where that is easy.
pub fn farthest(shape: TypedShape<'_>, center: Vector) -> Option<Real> {
    match shape {
        TypedShape::ConvexPolygon(c) => Some(farthest_point(c.points(), center)),
        TypedShape::RoundConvexPolygon(c) => {
            Some(farthest_point(c.inner_shape.points(), center) + c.border_radius)
        }
        _ => None,
    }
}

fn farthest_point(points: &[Vector], center: Vector) -> Real {
    points.iter().map(|p| p.distance_squared(center)).fold(0.0, Real::max).sqrt()
}
