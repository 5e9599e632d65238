//! What surfaces are made of: segments.

use super::polytope::Polytope;
use crate::dim::math::{Pose, Real, Vector};
use parry::shape::{Segment, Shape};

/// A flat shape.
pub type FlatShape = Segment;

/// The flat shape that a shape is, if it is one.
pub fn as_flat(shape: &dyn Shape) -> Option<&FlatShape> {
    shape.as_segment()
}

/// The ends of a flat shape.
pub fn flat_corners(flat: &FlatShape) -> [Vector; 2] {
    [flat.a, flat.b]
}

/// A segment.
#[derive(Copy, Clone, Debug)]
pub struct Flat {
    segment: Segment,
}

impl Flat {
    /// A segment; `None` if it has no normal.
    pub fn new(segment: &Segment) -> Option<Self> {
        segment.normal().map(|_| Self { segment: *segment })
    }

    /// As it is in the frame in which its own is at `pose`.
    pub fn at(&self, pose: &Pose) -> Self {
        Self { segment: self.segment.transformed(pose) }
    }

    pub fn as_polytope(&self) -> Polytope<'_> {
        Polytope::Segment(&self.segment)
    }

    pub fn as_shape(&self) -> &dyn Shape {
        &self.segment
    }

    /// How far it reaches along a direction.
    pub fn height(&self, direction: Vector) -> Real {
        let [a, b] = flat_corners(&self.segment).map(|corner| corner.dot(direction));
        a.max(b)
    }
}
