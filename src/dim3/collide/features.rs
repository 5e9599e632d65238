//! Numbers for the vertices, edges and faces of a box.

use crate::base::feature;
use crate::dim::math::{Real, Vector};
use parry::shape::PackedFeatureId;

/// The feature of a box that lies in the direction `offset`: a zero component means "between the two
/// faces of that axis".
pub fn box_feature(offset: Vector) -> PackedFeatureId {
    let number = box_number(offset.to_array());
    match offset.to_array().iter().filter(|&&x| x != 0.0).count() {
        1 => feature::face(number),
        2 => feature::edge(number),
        _ => feature::vertex(number),
    }
}

/// The number of a feature among all of a box.
///
/// Axis by axis: 0 between, 1 at the positive face, 2 at the negative one; read as a number of base 3.
pub const fn box_number(offset: [Real; 3]) -> u32 {
    digit(offset[0]) + 3 * digit(offset[1]) + 9 * digit(offset[2])
}

const fn digit(x: Real) -> u32 {
    if x > 0.0 {
        1
    } else if x < 0.0 {
        2
    } else {
        0
    }
}
