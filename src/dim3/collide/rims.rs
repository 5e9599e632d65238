//! Points over a triangle, a triangle per lane.

use super::clip::RIM_FRACTION_MAX;
use super::flat::FlatBlock;
use crate::base::wide::Wide;
use crate::dim::math::{Real, Vector};
use crate::dim::wide::{WideVector, cross};

/// The planes through the edges of triangles, at right angles to a plane that all of them lie in.
#[derive(Copy, Clone)]
pub struct Rims<W> {
    corners: [WideVector<W>; 3],
    /// Outward vector of the length of the edge, and the tolerance along it.
    outward: [WideVector<W>; 3],
    limits: [W; 3],
}

impl<W: Wide> Rims<W> {
    /// The rims of the triangles of a block. No rim is wider than `tolerance`.
    #[inline(always)]
    pub fn of(block: &FlatBlock, normal: Vector, tolerance: Real) -> Self {
        let corners =
            [WideVector::load(&block[0]), WideVector::load(&block[1]), WideVector::load(&block[2])];
        let [a, b, c] = corners;
        let normal = WideVector::splat(normal);
        let outward = [cross(b - a, normal), cross(c - b, normal), cross(a - c, normal)];
        // For clockwise triangles, all signs are reversed.
        let is_clockwise = W::zero().lt(outward[0].dot(c - a));
        let sign = W::select(is_clockwise, W::splat(-1.0), W::splat(1.0));
        let outward = [outward[0] * sign, outward[1] * sign, outward[2] * sign];
        let limits =
            [rim(outward[0], tolerance), rim(outward[1], tolerance), rim(outward[2], tolerance)];
        Self { corners, outward, limits }
    }

    /// Returns whether a point is over the triangle. A point on the rim is inside, as in
    /// [`clip_faces`](super::clip_faces).
    #[inline(always)]
    pub fn contain(&self, point: WideVector<W>) -> W::Mask {
        self.is_inside(0, point) & self.is_inside(1, point) & self.is_inside(2, point)
    }

    #[inline(always)]
    fn is_inside(&self, edge: usize, point: WideVector<W>) -> W::Mask {
        self.outward[edge].dot(point - self.corners[edge]).le(self.limits[edge])
    }
}

/// Tolerance beyond an edge, times the length of the edge. A fraction of a long edge could be more than the
/// size of the body, which would then be supported beyond the edge.
#[inline(always)]
fn rim<W: Wide>(outward: WideVector<W>, tolerance: Real) -> W {
    let squared = outward.dot(outward);
    (W::splat(RIM_FRACTION_MAX) * squared).min(W::splat(tolerance) * squared.sqrt())
}
