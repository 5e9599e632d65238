//! Rotation by angles, lane by lane, in 2D.

use super::math::ANGLE_SQUARED_MAX;
use super::wide::{WideAngVector, WideRotation};
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

/// The angle after a further rotation.
#[inline(always)]
pub(crate) fn turned_further<W: Wide>(
    rotvec: WideAngVector<W>,
    by: WideAngVector<W>,
) -> WideAngVector<W> {
    rotvec + by
}
