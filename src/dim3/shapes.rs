//! What the shapes are made of that only three dimensions have.

use super::math::{Real, Vector};
use crate::base::measure::Measure;
use parry::shape::{Cylinder, TypedShape};
use smallvec::{SmallVec, smallvec};

/// The numbers that a shape is made of, for the shapes whose type depends on the dimension; nothing
/// for the others.
pub fn measures(shape: TypedShape<'_>) -> SmallVec<[Measure<'_>; 4]> {
    use Measure::{Coordinates, Length, Lengths, Margin, Points};
    let cylinder =
        |c: &Cylinder| smallvec![Length("half_height", c.half_height), Length("radius", c.radius)];
    let (mut inner, border): (SmallVec<[Measure<'_>; 4]>, _) = match shape {
        TypedShape::Cylinder(c) => return cylinder(c),
        TypedShape::RoundCylinder(c) => (cylinder(&c.inner_shape), c.border_radius),
        TypedShape::Cone(c) => {
            return smallvec![Length("half_height", c.half_height), Length("radius", c.radius)];
        }
        TypedShape::RoundCone(c) => {
            let cone = &c.inner_shape;
            let inner =
                smallvec![Length("half_height", cone.half_height), Length("radius", cone.radius)];
            (inner, c.border_radius)
        }
        TypedShape::ConvexPolyhedron(c) => return smallvec![Points("points", c.points())],
        TypedShape::RoundConvexPolyhedron(c) => {
            (smallvec![Points("points", c.inner_shape.points())], c.border_radius)
        }
        TypedShape::HeightField(h) => {
            let heights = Coordinates("heights", h.heights().data());
            return smallvec![heights, Lengths("scale", h.scale())];
        }
        _ => return SmallVec::new(),
    };
    inner.push(Margin("border_radius", border));
    inner
}

/// Largest distance from `center` to any point of the shape, exactly, for those of this dimension's
/// shapes where that is easy.
pub fn farthest(shape: TypedShape<'_>, center: Vector) -> Option<Real> {
    match shape {
        TypedShape::Cylinder(c) => Some(farthest_of_cylinder(c, center)),
        TypedShape::RoundCylinder(c) => {
            Some(farthest_of_cylinder(&c.inner_shape, center) + c.border_radius)
        }
        TypedShape::ConvexPolyhedron(c) => Some(farthest_point(c.points(), center)),
        TypedShape::RoundConvexPolyhedron(c) => {
            Some(farthest_point(c.inner_shape.points(), center) + c.border_radius)
        }
        _ => None,
    }
}

fn farthest_of_cylinder(cylinder: &Cylinder, center: Vector) -> Real {
    let across = Vector::new(center.x, 0.0, center.z).length() + cylinder.radius;
    let along = center.y.abs() + cylinder.half_height;
    (across * across + along * along).sqrt()
}

fn farthest_point(points: &[Vector], center: Vector) -> Real {
    points.iter().map(|p| p.distance_squared(center)).fold(0.0, Real::max).sqrt()
}
