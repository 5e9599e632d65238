//! Cosine and sine of the rotation angle in a substep, from the square of that angle. They use no root and no
//! function of the platform, whose last bits differ between machines.
//!
//! For an eighth of the angle, the series to sixth order are sufficient. Each doubling
//!
//! ```text
//! cos 2α = cos² α - sin² α        sin 2α = 2 cos α sin α
//! ```
//!
//! leads to twice the angle. The sine is given relative to the angle: the rotation vector already contains
//! the angle as a factor.

use super::wide::Wide;
use parry::math::Real;

/// From `θ²`, the cosine of the angle `θ 2ᴰ / 8` after `D` doublings, and its sine divided by `θ`.
#[inline(always)]
pub fn cosine_and_sine<const D: usize>(square: Real) -> (Real, Real) {
    let eighth = square * (1.0 / 64.0);
    let mut cosine = 1.0 - eighth * (1.0 / 2.0 - eighth * (1.0 / 24.0 - eighth * (1.0 / 720.0)));
    let mut sine =
        0.125 - eighth * (1.0 / 48.0 - eighth * (1.0 / 960.0 - eighth * (1.0 / 40320.0)));
    for _ in 0..D {
        (cosine, sine) = (cosine * cosine - square * (sine * sine), 2.0 * cosine * sine);
    }
    (cosine, sine)
}

/// The same lane by lane.
#[inline(always)]
pub fn wide_cosine_and_sine<W: Wide, const D: usize>(square: W) -> (W, W) {
    let (number, eighth) = (W::splat, square * W::splat(1.0 / 64.0));
    let cosine = number(1.0 / 24.0) - eighth * number(1.0 / 720.0);
    let mut cosine = number(1.0) - eighth * (number(1.0 / 2.0) - eighth * cosine);
    let sine = number(1.0 / 960.0) - eighth * number(1.0 / 40320.0);
    let mut sine = number(1.0 / 8.0) - eighth * (number(1.0 / 48.0) - eighth * sine);
    for _ in 0..D {
        let product = cosine * sine;
        (cosine, sine) = (cosine * cosine - square * (sine * sine), product + product);
    }
    (cosine, sine)
}
