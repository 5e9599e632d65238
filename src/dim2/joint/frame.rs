//! Frames and levers as the bodies turn, lane by lane.

use crate::base::wide::Wide;
use crate::dim2::math::{ANG_DIM, DIM, SPATIAL_DIM, TURN_MAX};
use crate::dim2::wide::{WideAngVector, WideRotation, WideSymmetric, WideVector};

/// The rotation that [`integrate_rotation`](crate::dim2::math::integrate_rotation) turns by.
#[inline(always)]
fn rotation_by<W: Wide>(turn: WideAngVector<W>) -> WideRotation<W> {
    let (one, square) = (W::splat(1.0), (turn * turn).min(W::splat(TURN_MAX)));
    let correction = W::splat(1.0 / 24.0) + square * W::splat(1.0 / 240.0);
    let t = turn * (W::splat(0.5) + square * correction);
    let scale = one / (one + t * t);
    WideRotation { re: (one - t * t) * scale, im: (t + t) * scale }
}

/// A lever of a body after the body has turned.
#[inline(always)]
pub(crate) fn turned_lever<W: Wide>(lever: WideVector<W>, turn: WideAngVector<W>) -> WideVector<W> {
    rotation_by(turn).rotate(lever)
}

/// A frame of a body after the body has turned.
#[inline(always)]
pub(crate) fn turned_frame<W: Wide>(
    frame: WideRotation<W>,
    turn: WideAngVector<W>,
) -> WideRotation<W> {
    let by = rotation_by(turn);
    WideRotation {
        re: by.re * frame.re - by.im * frame.im,
        im: by.im * frame.re + by.re * frame.im,
    }
}

/// The angle after a further turn.
#[inline(always)]
pub(crate) fn turned_further<W: Wide>(
    turn: WideAngVector<W>,
    by: WideAngVector<W>,
) -> WideAngVector<W> {
    turn + by
}

/// The inverse inertia of a body after the body has turned: the same in 2D.
#[inline(always)]
pub(crate) fn turned_inertia<W: Wide>(
    inv_inertia: WideSymmetric<W>,
    _turn: WideAngVector<W>,
) -> WideSymmetric<W> {
    inv_inertia
}

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

/// The error about the axis if it were locked, and the direction along which the relative angular velocity
/// changes it.
#[inline(always)]
pub(crate) fn locked_rotations<W: Wide>(
    frame1: WideRotation<W>,
    frame2: WideRotation<W>,
    _axes: &[WideVector<W>; DIM],
) -> ([W; ANG_DIM], [WideAngVector<W>; ANG_DIM]) {
    let one = W::splat(1.0);
    let between = frame2.since(frame1);
    // At half a turn both directions are as good, and the error is large in either.
    let sum = (one + between.re).max(W::splat(1.0e-3));
    ([(between.im + between.im) / sum], [one])
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
