//! Frames of rotating bodies, lane by lane.

use crate::base::wide::Wide;
use crate::dim2::math::{ANG_DIM, DIM, Real, SPATIAL_DIM};
use crate::dim2::wide::{WideAngVector, WideRotation, WideVector};

/// Least cosine of half the angle that a locked axis is off.
const COS_MIN: Real = 1.0e-3;

/// The axes of a frame in world space.
#[inline(always)]
pub(crate) fn axes<W: Wide>(frame: WideRotation<W>) -> [WideVector<W>; DIM] {
    [WideVector { x: frame.re, y: frame.im }, WideVector { x: -frame.im, y: frame.re }]
}

/// An angular vector out of a frame, in world space: the same in 2D.
#[inline(always)]
pub(crate) fn angular_to_world<W: Wide>(
    _axes: &[WideVector<W>; DIM],
    v: WideAngVector<W>,
) -> WideAngVector<W> {
    v
}

/// The second frame as seen from the first.
#[inline(always)]
pub(crate) fn frame_between<W: Wide>(
    frame1: WideRotation<W>,
    frame2: WideRotation<W>,
) -> WideRotation<W> {
    frame2.since(frame1)
}

/// The error about the axis if it were locked, and its change per relative angular velocity: see the head of
/// this folder. `between` is the second frame as seen from the first.
#[inline(always)]
pub(crate) fn locked_rotations<W: Wide>(
    between: WideRotation<W>,
    _locked: &[W; ANG_DIM],
    _axes: &[WideVector<W>; DIM],
) -> ([W; ANG_DIM], [WideAngVector<W>; ANG_DIM]) {
    let (zero, one, half) = (W::zero(), W::splat(1.0), W::splat(0.5));
    let cos = ((one + between.re) * half).max(W::splat(COS_MIN * COS_MIN)).sqrt();
    // Half a turn off, the sine of the half angle is 1 or -1.
    let is_small = zero.lt(between.re);
    let size = ((one - between.re) * half).max(zero).sqrt();
    let large = W::select(between.im.lt(zero), -size, size);
    let sin = W::select(is_small, between.im * half / cos, large);
    let scale = one / (one + cos);
    ([W::splat(4.0) * sin * scale], [scale + scale])
}

/// A vector out of the frame with these axes, in world space.
#[inline(always)]
pub(crate) fn linear_to_world<W: Wide>(
    axes: &[WideVector<W>; DIM],
    v: WideVector<W>,
) -> WideVector<W> {
    axes[0] * v.x + axes[1] * v.y
}

/// An angular vector in world space, in a frame: the same in 2D.
#[inline(always)]
pub(crate) fn angular_to_frame<W: Wide>(
    _axes: &[WideVector<W>; DIM],
    v: WideAngVector<W>,
) -> WideAngVector<W> {
    v
}

/// A linear and an angular vector as numbers.
#[inline(always)]
pub(crate) fn components<W: Wide>(
    linear: WideVector<W>,
    angular: WideAngVector<W>,
) -> [W; SPATIAL_DIM] {
    [linear.x, linear.y, angular]
}

/// Undoes [`components`].
#[inline(always)]
pub(crate) fn from_components<W: Wide>(c: [W; SPATIAL_DIM]) -> (WideVector<W>, WideAngVector<W>) {
    (WideVector { x: c[0], y: c[1] }, c[2])
}
