//! Two shapes and the context of their contacts.

use super::neighbor::Neighbor;
use crate::base::wide::Simd;
use crate::dim::collide::RawPoint;
use crate::dim::math::{Pose, Real, Vector};
use parry::shape::Shape;

/// Two shapes, and the settings of their contacts.
#[derive(Copy, Clone)]
pub(crate) struct ShapePair<'a> {
    /// Pose of the second shape in the frame of the first.
    pub pos12: Pose,
    pub shapes: [&'a dyn Shape; 2],
    /// Approximate displacement of the second relative to the first in a step, in the frame of the first.
    pub motion: Vector,
    /// Largest distance of points (length units).
    pub prediction: Real,
    /// Height below which a step is ignored (length units).
    pub step_height_tolerance: Real,
    /// The other contacts of each of the two.
    pub neighbors: [&'a [Neighbor<'a>]; 2],
    /// The instructions that kernels run on.
    pub simd: Simd,
}

impl<'a> ShapePair<'a> {
    /// Two shapes that touch nothing else, and among whose own parts no step is too low to be one.
    #[cfg(test)]
    pub fn alone(pos12: &Pose, shapes: [&'a dyn Shape; 2], prediction: Real) -> Self {
        Self {
            pos12: *pos12,
            shapes,
            motion: Vector::ZERO,
            prediction,
            step_height_tolerance: 0.0,
            neighbors: [&[], &[]],
            simd: Simd::detect(),
        }
    }

    /// Displacement of the shape on a side relative to the other in a step, in the frame of the other.
    pub fn motion_of(&self, side: usize) -> Vector {
        match side {
            0 => self.pos12.rotation.inverse() * -self.motion,
            _ => self.motion,
        }
    }

    /// The position of a contact on the shape on a side, in the frame of the other shape.
    pub fn in_other_frame(&self, side: usize, point: &RawPoint) -> Vector {
        match side {
            0 => self.pos12.inverse_transform_point(point.local_p1),
            _ => self.pos12 * point.local_p2,
        }
    }
}
