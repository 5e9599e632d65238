//! The direction that separates two edges.

use crate::dim::math::{Real, Vector};

/// Edges whose directions have a smaller sine (squared) than this are parallel.
const PARALLEL_SINE_SQUARED_MAX: Real = 1.0e-4;

/// The unit vector at right angles to two directions; `None` if these are parallel.
pub fn edge_normal(along1: Vector, along2: Vector) -> Option<Vector> {
    let normal = along1.cross(along2);
    let is_parallel = normal.length_squared()
        <= PARALLEL_SINE_SQUARED_MAX * along1.length_squared() * along2.length_squared();
    if is_parallel { None } else { normal.try_normalize() }
}
