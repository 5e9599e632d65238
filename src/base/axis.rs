//! The axis that separates two polytopes best.

use super::wide::Wide;
use parry::math::{Pose, Real, Vector};

/// One of two polytopes.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Side {
    First,
    Second,
}

/// An axis, and the distance of two polytopes along it.
#[derive(Copy, Clone, Debug)]
pub struct BestAxis {
    /// Negative if they overlap.
    pub gap: Real,
    /// From the first to the second, in the frame of the first.
    pub normal: Vector,
    /// The box whose face is perpendicular to it; `None` for a pair of edges.
    pub face: Option<Side>,
}

impl BestAxis {
    /// The same axis with the roles of the two exchanged. `pose` is that of the first, as it was, in the
    /// frame of the second.
    pub fn exchanged(self, pose: &Pose) -> Self {
        let face = self.face.map(|side| match side {
            Side::First => Side::Second,
            Side::Second => Side::First,
        });
        Self { gap: self.gap, normal: pose.rotation * -self.normal, face }
    }
}

/// The distance of a range from the one within `limit` of zero, and its side (1 or -1).
#[inline(always)]
pub fn apart<W: Wide>(low: W, high: W, limit: W) -> (W, W) {
    let (above, below) = (low - limit, -limit - high);
    let one = W::splat(1.0);
    (above.max(below), W::select(below.le(above), one, -one))
}
