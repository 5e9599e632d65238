//! A point of a body, and its response to an impulse there.

use crate::base::wide::Wide;
use crate::dim3::math::DIM;
use crate::dim3::wide::{WideSymmetric, WideVector};

/// Velocity of a point at the moment arm `r` by the rotation of its body, per unit of impulse at that point.
/// It is the lower half of `-[r]ₓ I⁻¹ [r]ₓ`.
#[inline(always)]
pub(crate) fn point_response<W: Wide>(
    inv_inertia: WideSymmetric<W>,
    r: WideVector<W>,
) -> [[W; DIM]; DIM] {
    let (m, zero) = (inv_inertia, W::zero());
    // `I⁻¹ (r × e)` for each unit vector e.
    let x = [m.m12 * r.z - m.m13 * r.y, m.m22 * r.z - m.m23 * r.y, m.m23 * r.z - m.m33 * r.y];
    let y = [m.m13 * r.x - m.m11 * r.z, m.m23 * r.x - m.m12 * r.z, m.m33 * r.x - m.m13 * r.z];
    let z = [m.m11 * r.y - m.m12 * r.x, m.m12 * r.y - m.m22 * r.x];
    [
        [r.z * x[1] - r.y * x[2], zero, zero],
        [r.x * x[2] - r.z * x[0], r.x * y[2] - r.z * y[0], zero],
        [r.y * x[0] - r.x * x[1], r.y * y[0] - r.x * y[1], r.y * z[0] - r.x * z[1]],
    ]
}

/// A vector as numbers.
#[inline(always)]
pub(crate) fn numbers<W: Wide>(v: WideVector<W>) -> [W; DIM] {
    [v.x, v.y, v.z]
}

/// Undoes [`numbers`].
#[inline(always)]
pub(crate) fn from_numbers<W: Wide>([x, y, z]: [W; DIM]) -> WideVector<W> {
    WideVector { x, y, z }
}
