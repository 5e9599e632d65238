//! Frames of rotating bodies, lane by lane.

use crate::base::wide::Wide;
use crate::dim3::math::{ANG_DIM, DIM, Real, SPATIAL_DIM};
use crate::dim3::wide::{WideAngVector, WideRotation, WideVector};

/// Smallest cosine of half the angle between the frames with which the rows are computed.
const COS_MIN: Real = 1.0e-6;

/// The axes of a frame in world space.
#[inline(always)]
pub(crate) fn axes<W: Wide>(frame: WideRotation<W>) -> [WideVector<W>; DIM] {
    let (q, one, two) = (frame, W::splat(1.0), W::splat(2.0));
    let (x2, y2, z2) = (q.x * two, q.y * two, q.z * two);
    let (xx, yy, zz) = (q.x * x2, q.y * y2, q.z * z2);
    let (xy, xz, yz) = (q.x * y2, q.x * z2, q.y * z2);
    let (wx, wy, wz) = (q.w * x2, q.w * y2, q.w * z2);
    [
        WideVector { x: one - (yy + zz), y: xy + wz, z: xz - wy },
        WideVector { x: xy - wz, y: one - (xx + zz), z: yz + wx },
        WideVector { x: xz + wy, y: yz - wx, z: one - (xx + yy) },
    ]
}

/// An angular vector out of the frame with these axes, in world space.
#[inline(always)]
pub(crate) fn angular_to_world<W: Wide>(
    axes: &[WideVector<W>; DIM],
    v: WideAngVector<W>,
) -> WideAngVector<W> {
    axes[0] * v.x + axes[1] * v.y + axes[2] * v.z
}

/// The second frame as seen from the first: `p* q`.
#[inline(always)]
pub(crate) fn frame_between<W: Wide>(
    frame1: WideRotation<W>,
    frame2: WideRotation<W>,
) -> WideRotation<W> {
    let (p, q) = (frame1, frame2);
    WideRotation {
        x: p.w * q.x - p.x * q.w - (p.y * q.z - p.z * q.y),
        y: p.w * q.y - p.y * q.w - (p.z * q.x - p.x * q.z),
        z: p.w * q.z - p.z * q.w - (p.x * q.y - p.y * q.x),
        w: p.w * q.w + p.x * q.x + p.y * q.y + p.z * q.z,
    }
}

/// The error about each axis if it were locked, and the direction (world space) along which the relative
/// angular velocity changes it: see the head of this folder. `between` is the second frame as seen from the
/// first, which has these `axes`. `locked` is one for locked axes, zero for free axes.
#[inline(always)]
pub(crate) fn locked_rotations<W: Wide>(
    between: WideRotation<W>,
    locked: &[W; ANG_DIM],
    axes: &[WideVector<W>; DIM],
) -> ([W; ANG_DIM], [WideAngVector<W>; ANG_DIM]) {
    let (WideRotation { x, y, z, w }, one) = (between, W::splat(1.0));
    // Half a turn off, either direction leads back.
    let w = W::select(w.abs().lt(W::splat(COS_MIN)), W::splat(COS_MIN), w);
    let mut rows = [
        axes[0] * w + axes[1] * z - axes[2] * y,
        axes[1] * w + axes[2] * x - axes[0] * z,
        axes[2] * w + axes[0] * y - axes[1] * x,
    ];
    let mut errors = [x, y, z];
    let (mut cos_squared, mut towards) = (w * w, WideVector::zero());
    for k in 0..ANG_DIM {
        let free = errors[k] * (one - locked[k]);
        cos_squared = cos_squared + free * free;
        towards = towards + rows[k] * (errors[k] * locked[k]);
    }
    let cos = cos_squared.sqrt();
    let scale = one / (one + cos);
    towards = towards * (scale * scale / cos);
    for (row, error) in rows.iter_mut().zip(&mut errors) {
        let twice = *error + *error;
        *row = *row * (scale + scale) + towards * twice;
        *error = (twice + twice) * scale;
    }
    (errors, rows)
}

/// A vector out of the frame with these axes, in world space.
#[inline(always)]
pub(crate) fn linear_to_world<W: Wide>(
    axes: &[WideVector<W>; DIM],
    v: WideVector<W>,
) -> WideVector<W> {
    axes[0] * v.x + axes[1] * v.y + axes[2] * v.z
}

/// An angular vector in world space, in the frame with these axes.
#[inline(always)]
pub(crate) fn angular_to_frame<W: Wide>(
    axes: &[WideVector<W>; DIM],
    v: WideAngVector<W>,
) -> WideAngVector<W> {
    WideVector { x: axes[0].dot(v), y: axes[1].dot(v), z: axes[2].dot(v) }
}

/// A linear and an angular vector as numbers.
#[inline(always)]
pub(crate) fn components<W: Wide>(
    linear: WideVector<W>,
    angular: WideAngVector<W>,
) -> [W; SPATIAL_DIM] {
    [linear.x, linear.y, linear.z, angular.x, angular.y, angular.z]
}

/// Undoes [`components`].
#[inline(always)]
pub(crate) fn from_components<W: Wide>(c: [W; SPATIAL_DIM]) -> (WideVector<W>, WideAngVector<W>) {
    (WideVector { x: c[0], y: c[1], z: c[2] }, WideVector { x: c[3], y: c[4], z: c[5] })
}
