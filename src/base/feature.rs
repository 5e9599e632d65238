//! Names for vertices, edges and faces.
//!
//! Inline versions of parry's functions of the same names, which are calls into another crate for two
//! instructions. They are called for each contact point in each step, and took up to 3 % of it.

use parry::shape::PackedFeatureId;

/// Numbers from here on do not fit.
const NUMBER_BOUND: u32 = 1 << 30;
const VERTEX: u32 = 1 << 30;
#[allow(dead_code, reason = "in the plane there are no edges but faces")]
const EDGE: u32 = 2 << 30;
const FACE: u32 = 3 << 30;

/// The vertex of this number.
#[inline]
pub const fn vertex(number: u32) -> PackedFeatureId {
    debug_assert!(number < NUMBER_BOUND);
    PackedFeatureId(VERTEX | number)
}

/// The edge of this number.
#[inline]
#[allow(dead_code, reason = "in the plane there are no edges but faces")]
pub const fn edge(number: u32) -> PackedFeatureId {
    debug_assert!(number < NUMBER_BOUND);
    PackedFeatureId(EDGE | number)
}

/// The face of this number.
#[inline]
pub const fn face(number: u32) -> PackedFeatureId {
    debug_assert!(number < NUMBER_BOUND);
    PackedFeatureId(FACE | number)
}

#[cfg(test)]
mod tests {
    use super::{NUMBER_BOUND, edge, face, vertex};
    use parry::shape::FeatureId;

    #[test]
    fn parry_reads_them() {
        for number in [0, 1, 77, NUMBER_BOUND - 1] {
            assert_eq!(vertex(number).unpack(), FeatureId::Vertex(number));
            assert_eq!(face(number).unpack(), FeatureId::Face(number));
            assert_eq!(edge(number).0 & (NUMBER_BOUND - 1), number);
            assert!(
                !edge(number).is_vertex() && !edge(number).is_face() && !edge(number).is_unknown()
            );
        }
    }
}
