//! Points over a segment, a segment per lane.

use super::clip::RIM_FRACTION_MAX;
use super::flat::FlatBlock;
use crate::base::wide::Wide;
use crate::dim::math::{Real, Vector};
use crate::dim::wide::WideVector;

/// The lines through the ends of segments, at right angles to a line that all of them lie in.
#[derive(Copy, Clone)]
pub struct Rims<W> {
    start: WideVector<W>,
    /// From end to end.
    along: WideVector<W>,
    /// The square of its length, and the part beyond the ends that counts as inside.
    length: W,
    rim: W,
}

impl<W: Wide> Rims<W> {
    /// The rims of the segments of a block. No rim is wider than `tolerance`: a fraction of a long segment
    /// could be more than the size of the body.
    #[inline(always)]
    pub fn of(block: &FlatBlock, _normal: Vector, tolerance: Real) -> Self {
        let (start, end) = (WideVector::load(&block[0]), WideVector::load(&block[1]));
        let along = end - start;
        let length = along.dot(along);
        let rim = (W::splat(RIM_FRACTION_MAX) * length).min(W::splat(tolerance) * length.sqrt());
        Self { start, along, length, rim }
    }

    /// Returns whether a point is over the segment. A point on the rim is inside, as in
    /// [`clip_faces`](super::clip_faces).
    #[inline(always)]
    pub fn contain(&self, point: WideVector<W>) -> W::Mask {
        let place = self.along.dot(point - self.start);
        (-self.rim).le(place) & place.le(self.length + self.rim)
    }
}
