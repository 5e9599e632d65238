//! Saved forms of shapes that exist in two dimensions only.

use super::math::{Real, Vector};
use crate::base::fault::{Fault, ensure};
use crate::base::plain_shape::plain_shapes;
use parry::shape::{
    Ball, Capsule, ConvexPolygon, Cuboid, HalfSpace, HeightField, RoundConvexPolygon, RoundCuboid,
    RoundTriangle, Segment, SharedShape, Triangle, TypedShape,
};

plain_shapes!(
    Ball,
    Cuboid,
    Capsule,
    Segment,
    Triangle,
    HalfSpace,
    ConvexPolygon,
    RoundCuboid,
    RoundTriangle,
    RoundConvexPolygon
);

/// A height field without the data that follow from its heights.
#[derive(serde::Serialize, serde::Deserialize)]
pub struct SavedField {
    heights: Vec<Real>,
    scale: Vector,
    removed: Vec<usize>,
}

impl SavedField {
    pub fn of(field: &HeightField) -> Self {
        let removed = (0..field.num_cells()).filter(|&cell| field.is_segment_removed(cell));
        let removed = removed.collect();
        Self { heights: field.heights().clone(), scale: field.scale(), removed }
    }

    pub fn restore(self) -> Result<HeightField, Fault> {
        ensure!(self.heights.len() > 1, "a height field has {} heights", self.heights.len());
        let mut field = HeightField::new(self.heights, self.scale);
        for cell in self.removed {
            ensure!(cell < field.num_cells(), "cell {cell} of a height field is not there");
            field.set_segment_removed(cell, true);
        }
        Ok(field)
    }
}

/// Checks the parts of convex shapes that their constructors compute.
pub fn check_hull(shape: TypedShape<'_>) -> Result<(), Fault> {
    match shape {
        TypedShape::ConvexPolygon(polygon) => check_polygon(polygon),
        TypedShape::RoundConvexPolygon(round) => check_polygon(&round.inner_shape),
        _ => Ok(()),
    }
}

fn check_polygon(polygon: &ConvexPolygon) -> Result<(), Fault> {
    let (count, normals) = (polygon.points().len(), polygon.normals());
    ensure!(count > 2 && normals.len() == count, "{count} corners have {} sides", normals.len());
    let wrong = normals.iter().find(|normal| (normal.length_squared() - 1.0).abs() >= 1.0e-2);
    let wrong = wrong.or(normals.iter().find(|normal| !normal.is_finite()));
    ensure!(wrong.is_none(), "a polygon has the normal {wrong:?}");
    Ok(())
}
