//! Copies of shapes whose stored directions contradict their points.
//!
//! parry scales normals like points, which is wrong for uneven factors. It keeps the order of corners under
//! negative factors, which is then clockwise. Height fields with a negative scale find none of their cells.

use super::flat_hull::{flat_hull, rounded_flat_hull};
use super::hull::{convex_outline, signed_area};
use super::math::{Real, Vector};
use super::shapes::convex_defect;
use parry::shape::{
    ConvexPolygon, HeightField, RoundShape, SharedShape, TriMesh, TriMeshBuilderError, TypedShape,
};

/// Largest sine of the angle between a side and the line that its normal belongs to. parry leaves out corners
/// between sides up to 1.5°, and keeps the normal of one side.
const SINE_MAX: Real = 0.1;

/// A copy of a convex shape or a height field that is consistent; `None` if the shape is.
pub fn repaired(shape: TypedShape<'_>) -> Option<SharedShape> {
    match shape {
        TypedShape::ConvexPolygon(polygon) => match repaired_polygon(polygon) {
            None if convex_defect(shape).is_some() => {
                flat_hull(polygon.points()).map(SharedShape::new)
            }
            copy => copy.map(SharedShape::new),
        },
        TypedShape::RoundConvexPolygon(RoundShape { inner_shape, border_radius }) => {
            let border_radius = *border_radius;
            match repaired_polygon(inner_shape) {
                None if convex_defect(shape).is_some() => {
                    let flat = flat_hull(inner_shape.points());
                    flat.map(|flat| rounded_flat_hull(flat, border_radius))
                }
                copy => copy.map(|inner| {
                    SharedShape::new(RoundShape { inner_shape: inner, border_radius })
                }),
            }
        }
        TypedShape::HeightField(field) => repaired_field(field).map(SharedShape::new),
        _ => None,
    }
}

fn repaired_polygon(polygon: &ConvexPolygon) -> Option<ConvexPolygon> {
    let points = polygon.points();
    let next = |at: usize| points[if at + 1 < points.len() { at + 1 } else { 0 }];
    let is_own = points.iter().zip(polygon.normals()).enumerate().all(|(at, (point, normal))| {
        let along = next(at) - *point;
        let outward = Vector::new(along.y, -along.x).dot(*normal);
        along.dot(*normal).abs() <= SINE_MAX * along.length() && outward >= 0.0
    });
    let is_clockwise = signed_area(points) < 0.0;
    if is_own && !is_clockwise { None } else { convex_outline(points.to_vec()) }
}

/// The same line with a positive scale.
fn repaired_field(field: &HeightField) -> Option<HeightField> {
    let scale = field.scale();
    if scale.min_element() > 0.0 {
        return None;
    }
    let height = scale.y.signum() * if scale.y == 0.0 { 0.0 } else { 1.0 };
    let mut heights: Vec<Real> = field.heights().iter().map(|value| value * height).collect();
    let cells = field.num_cells();
    let at = |cell: usize| if scale.x < 0.0 { cells - 1 - cell } else { cell };
    if scale.x < 0.0 {
        heights.reverse();
    }
    let positive = Vector::new(scale.x.abs(), if height == 0.0 { 1.0 } else { scale.y.abs() });
    let mut copy = HeightField::new(heights, positive);
    (0..cells).for_each(|cell| copy.set_segment_removed(cell, field.is_segment_removed(at(cell))));
    Some(copy)
}

/// Meshes have neither normals nor an inside of their own in 2D.
pub fn repaired_mesh(_: &TriMesh) -> Result<Option<TriMesh>, TriMeshBuilderError> {
    Ok(None)
}
