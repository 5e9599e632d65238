//! A point of a body, and its response to an impulse there.

use crate::base::wide::Wide;
use crate::dim2::math::DIM;
use crate::dim2::wide::{WideSymmetric, WideVector};

/// Velocity of a point at the moment arm `r` by the rotation of its body, per unit of impulse at that point.
/// It is the lower half of the matrix.
#[inline(always)]
pub(crate) fn point_response<W: Wide>(
    inv_inertia: WideSymmetric<W>,
    r: WideVector<W>,
) -> [[W; DIM]; DIM] {
    let turn = r * inv_inertia;
    [[turn.y * r.y, W::zero()], [-(turn.x * r.y), turn.x * r.x]]
}

/// A vector as numbers.
#[inline(always)]
pub(crate) fn numbers<W: Wide>(v: WideVector<W>) -> [W; DIM] {
    [v.x, v.y]
}

/// Undoes [`numbers`].
#[inline(always)]
pub(crate) fn from_numbers<W: Wide>([x, y]: [W; DIM]) -> WideVector<W> {
    WideVector { x, y }
}
