//! Numbers for the vertices and faces of a box.

use crate::base::feature;
use crate::dim::math::{Real, Vector};
use parry::shape::PackedFeatureId;

/// The feature of a box that lies in the direction `offset`: a zero component means "between the two
/// faces of that axis".
///
/// Axis by axis: 0 between, 1 at the positive face, 2 at the negative one; read as a number of base 3.
pub fn box_feature(offset: Vector) -> PackedFeatureId {
    let digit = |x: Real| match x {
        x if x > 0.0 => 1,
        x if x < 0.0 => 2,
        _ => 0,
    };
    let code = digit(offset.x) + 3 * digit(offset.y);
    match code {
        1..=3 | 6 => feature::face(code),
        _ => feature::vertex(code),
    }
}
