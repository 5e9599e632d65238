//! The nearest point of a shape.
//!
//! Round shapes are projected onto by way of the sharp shape inside. parry searches the nearest point of a
//! round surface among its support points, and ends some millimetres beside the point.

use crate::dim::math::{Real, Vector};
use crate::dim::shapes::core_of_round;
use parry::shape::Shape;

/// The point of a shape, its inside included, that is nearest to a point. Both are in the shape's frame.
pub fn nearest_point(shape: &dyn Shape, point: Vector) -> Vector {
    let Some((core, radius)) = core_of_round(shape.as_typed_shape()) else {
        return shape.project_local_point(point, true).point;
    };
    let on_core = core.project_local_point(point, true).point;
    let (direction, distance) = (point - on_core).normalize_and_length();
    on_core + direction * Real::min(distance, radius)
}
