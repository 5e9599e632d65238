//! Turning, lane by lane, in 2D.

use super::math::TURN_MAX;
use super::wide::{WideAngVector, WideRotation, WideVector};
use crate::base::wide::Wide;

/// The rotation that [`integrate_rotation`](crate::dim2::math::integrate_rotation) turns by.
#[inline(always)]
fn rotation_by<W: Wide>(turn: WideAngVector<W>) -> WideRotation<W> {
    let square = (turn * turn).min(W::splat(TURN_MAX));
    let (mut cosine, mut sine) = of_eighth(square);
    for _ in 0..3 {
        let product = cosine * sine;
        (cosine, sine) = (cosine * cosine - square * (sine * sine), product + product);
    }
    let sine = turn * sine;
    let scale = W::splat(1.0) / (cosine * cosine + sine * sine).sqrt();
    WideRotation { re: cosine * scale, im: sine * scale }
}

/// Cosine and sine of an eighth of an angle whose square this is; the sine as a share of the whole angle.
#[inline(always)]
fn of_eighth<W: Wide>(square: W) -> (W, W) {
    let (number, square) = (W::splat, square * W::splat(1.0 / 64.0));
    let cosine = number(1.0 / 24.0) - square * number(1.0 / 720.0);
    let cosine = number(1.0) - square * (number(1.0 / 2.0) - square * cosine);
    let sine = number(1.0 / 960.0) - square * number(1.0 / 40320.0);
    (cosine, number(1.0 / 8.0) - square * (number(1.0 / 48.0) - square * sine))
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
