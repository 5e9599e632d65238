//! Rotation by angles, lane by lane, in 2D.

use super::math::{ANGLE_SQUARED_MAX, AngVector};
use super::wide::{WideAngVector, WideRotation, WideSymmetric};
use crate::base::turning::wide_cosine_and_sine;
use crate::base::wide::Wide;

/// The rotation that [`integrate_rotation`](crate::dim2::math::integrate_rotation) applies.
#[inline(always)]
pub(crate) fn rotation_by<W: Wide>(rotvec: WideAngVector<W>) -> WideRotation<W> {
    let square = (rotvec * rotvec).min(W::splat(ANGLE_SQUARED_MAX));
    let (cosine, sine) = wide_cosine_and_sine::<W, 3>(square);
    let sine = rotvec * sine;
    let scale = W::splat(1.0) / (cosine * cosine + sine * sine).sqrt();
    WideRotation { re: cosine * scale, im: sine * scale }
}

/// The inverse inertia of a body after a rotation of the body: constant in the plane.
#[inline(always)]
pub(crate) fn turned_inertia<W: Wide>(
    inv_inertia: WideSymmetric<W>,
    _: WideRotation<W>,
) -> WideSymmetric<W> {
    inv_inertia
}

/// The angle after a further rotation.
#[inline(always)]
pub(crate) fn turned_further<W: Wide>(
    rotvec: WideAngVector<W>,
    by: WideAngVector<W>,
) -> WideAngVector<W> {
    rotvec + by
}

/// The angle of a body after two rotations.
pub(crate) fn composed_rotation(rotvec: AngVector, by: AngVector) -> AngVector {
    rotvec + by
}
