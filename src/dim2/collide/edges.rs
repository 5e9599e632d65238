//! In the plane faces are all that separates polytopes.

use crate::dim::math::Vector;

/// There is none: no direction of the plane is at right angles to two others.
pub fn edge_normal(_along1: Vector, _along2: Vector) -> Option<Vector> {
    None
}
