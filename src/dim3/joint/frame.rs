//! Frames and levers as the bodies turn, lane by lane.

use crate::base::wide::Wide;
use crate::dim3::math::{ANG_DIM, DIM, SERIES_MAX, SPATIAL_DIM, TURN_MAX};
use crate::dim3::wide::{WideAngVector, WideRotation, WideSymmetric, WideVector, cross};

/// Half the rotation vector, lengthened so that the quaternion `(this, 1)` turns by the whole angle to seventh
/// order: see [`integrate_rotation`](crate::dim3::math::integrate_rotation), which this repeats.
#[inline(always)]
fn half_turn<W: Wide>(turn: WideAngVector<W>) -> WideVector<W> {
    let square = turn.dot(turn).min(W::splat(TURN_MAX));
    let correction = W::splat(1.0 / 24.0) + square * W::splat(1.0 / 240.0);
    turn * (W::splat(0.5) + square * correction)
}

/// A lever of a body after the body has turned.
#[inline(always)]
pub(crate) fn turned_lever<W: Wide>(lever: WideVector<W>, turn: WideAngVector<W>) -> WideVector<W> {
    let (one, u) = (W::splat(1.0), half_turn(turn));
    let scale = W::splat(2.0) / (one + u.dot(u));
    lever + cross(u, cross(u, lever) + lever) * scale
}

/// A frame of a body after the body has turned.
#[inline(always)]
pub(crate) fn turned_frame<W: Wide>(
    frame: WideRotation<W>,
    turn: WideAngVector<W>,
) -> WideRotation<W> {
    let (q, a) = (frame, half_turn(turn));
    let turned = WideRotation {
        x: q.x + (a.x * q.w + a.y * q.z - a.z * q.y),
        y: q.y + (a.y * q.w + a.z * q.x - a.x * q.z),
        z: q.z + (a.z * q.w + a.x * q.y - a.y * q.x),
        w: q.w - (a.x * q.x + a.y * q.y + a.z * q.z),
    };
    let scale = W::splat(1.0) / (W::splat(1.0) + a.dot(a)).sqrt();
    WideRotation {
        x: turned.x * scale,
        y: turned.y * scale,
        z: turned.z * scale,
        w: turned.w * scale,
    }
}

/// The rotation vector after a further turn: see [`turn_further`](crate::dim3::math::turn_further), which this repeats.
#[inline(always)]
pub(crate) fn turned_further<W: Wide>(
    turn: WideAngVector<W>,
    by: WideAngVector<W>,
) -> WideAngVector<W> {
    let across = cross(by, turn);
    let correction = across * W::splat(0.5) + cross(by - turn, across) * W::splat(1.0 / 12.0);
    let is_small = turn.dot(turn).lt(W::splat(SERIES_MAX * SERIES_MAX));
    turn + by + WideVector::select(is_small, correction, WideVector::zero())
}

/// The inverse inertia of a body after the body has turned: `R I⁻¹ Rᵀ`.
#[inline(always)]
pub(crate) fn turned_inertia<W: Wide>(
    inv_inertia: WideSymmetric<W>,
    turn: WideAngVector<W>,
) -> WideSymmetric<W> {
    let m = inv_inertia;
    // Of each row of I⁻¹, and then of each column of what comes out.
    let x = turned_lever(WideVector { x: m.m11, y: m.m12, z: m.m13 }, turn);
    let y = turned_lever(WideVector { x: m.m12, y: m.m22, z: m.m23 }, turn);
    let z = turned_lever(WideVector { x: m.m13, y: m.m23, z: m.m33 }, turn);
    let first = turned_lever(WideVector { x: x.x, y: y.x, z: z.x }, turn);
    let second = turned_lever(WideVector { x: x.y, y: y.y, z: z.y }, turn);
    let third = turned_lever(WideVector { x: x.z, y: y.z, z: z.z }, turn);
    WideSymmetric {
        m11: first.x,
        m12: first.y,
        m13: first.z,
        m22: second.y,
        m23: second.z,
        m33: third.z,
    }
}

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

/// The error about each axis if it were locked, and the direction (world space) along which the relative angular
/// velocity changes it.
#[inline(always)]
pub(crate) fn locked_rotations<W: Wide>(
    frame1: WideRotation<W>,
    frame2: WideRotation<W>,
    axes: &[WideVector<W>; DIM],
) -> ([W; ANG_DIM], [WideAngVector<W>; ANG_DIM]) {
    let (p, q, two) = (frame1, frame2, W::splat(2.0));
    let w = p.w * q.w + p.x * q.x + p.y * q.y + p.z * q.z;
    let x = p.w * q.x - p.x * q.w - (p.y * q.z - p.z * q.y);
    let y = p.w * q.y - p.y * q.w - (p.z * q.x - p.x * q.z);
    let z = p.w * q.z - p.z * q.w - (p.x * q.y - p.y * q.x);
    let rows = [
        axes[0] * w + axes[1] * z - axes[2] * y,
        axes[1] * w + axes[2] * x - axes[0] * z,
        axes[2] * w + axes[0] * y - axes[1] * x,
    ];
    ([x * two, y * two, z * two], rows)
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
