//! Sine, cosine and the angle of a direction, with the same bits on every machine.
//!
//! The standard library uses the platform's functions, whose last bits differ. Joint angles go through them
//! in each substep, so these are made of arithmetic alone, which is the same everywhere.

use core::f64::consts::{FRAC_2_PI, FRAC_PI_2, FRAC_PI_4, PI};
use parry::math::Real;

/// A quarter of a turn in three parts: the first two have so few digits that their small multiples are exact
/// (Cody and Waite 1980).
const QUARTER: [f64; 3] =
    [1.570_796_251_296_997, 7.549_789_415_861_596e-8, 5.390_302_858_158_119e-15];

/// Taylor's coefficients. At an eighth of a turn, the largest argument, the omitted terms are below the last
/// digit of a double.
const SINE: [f64; 8] = [
    1.0,
    -1.0 / 6.0,
    1.0 / 120.0,
    -1.0 / 5_040.0,
    1.0 / 362_880.0,
    -1.0 / 39_916_800.0,
    1.0 / 6_227_020_800.0,
    -1.0 / 1_307_674_368_000.0,
];
const COSINE: [f64; 9] = [
    1.0,
    -0.5,
    1.0 / 24.0,
    -1.0 / 720.0,
    1.0 / 40_320.0,
    -1.0 / 3_628_800.0,
    1.0 / 479_001_600.0,
    -1.0 / 87_178_291_200.0,
    1.0 / 20_922_789_888_000.0,
];

/// Sine and cosine of an angle in radians. Their last digits fade as the angle grows beyond some million
/// turns.
pub fn sin_cos(angle: Real) -> (Real, Real) {
    let angle = f64::from(angle);
    let quarters = (angle * FRAC_2_PI).round();
    // Numbers without fractional digits give an arbitrary angle, which must be finite.
    let rest =
        QUARTER.into_iter().fold(angle, |rest, part| rest - quarters * part).clamp(-1.0, 1.0);
    let square = rest * rest;
    let series = |terms: &[f64]| terms.iter().rev().fold(0.0, |sum, term| sum * square + term);
    let (sine, cosine) = (rest * series(&SINE), series(&COSINE));
    let (sine, cosine) = match quarters.rem_euclid(4.0) as u8 {
        0 => (sine, cosine),
        1 => (cosine, -sine),
        2 => (-sine, -cosine),
        _ => (-cosine, sine),
    };
    (sine as Real, cosine as Real)
}

/// `atan(t) = t + t z P(z)/Q(z)` with `z = t²`, for `t` up to ±0.66. The rational approximation is that of
/// Moshier's "Methods and Programs for Mathematical Functions" (1989). Its error is a unit or two in the last
/// place of a double.
pub const ATAN_P: [f64; 5] = [
    -64.850_219_049_420_25,
    -122.886_668_449_013_61,
    -75.008_557_923_147_05,
    -16.157_537_187_333_652,
    -0.875_060_860_003_190_4,
];
pub const ATAN_Q: [f64; 6] = [
    194.550_657_148_261_4,
    485.390_399_635_913_7,
    432.881_060_491_290_27,
    165.027_009_831_698_85,
    24.858_464_901_423_062,
    1.0,
];

/// The angle (radians, from `-π` to `π`) of `(x, y)` from the first axis; 0 if both are 0.
pub fn atan2(y: Real, x: Real) -> Real {
    let (y, x) = (f64::from(y), f64::from(x));
    let (short, long) = if y.abs() < x.abs() { (y.abs(), x.abs()) } else { (x.abs(), y.abs()) };
    let angle = if long == 0.0 { 0.0 } else { atan_within_one(short / long) };
    let angle = if y.abs() < x.abs() || long == 0.0 { angle } else { FRAC_PI_2 - angle };
    let angle = if x < 0.0 { PI - angle } else { angle };
    (if y < 0.0 { -angle } else { angle }) as Real
}

/// The angle of a slope between 0 and 1.
fn atan_within_one(slope: f64) -> f64 {
    // Above 0.66 from an eighth of a turn: tan(a - π/4) = (t - 1)/(t + 1).
    let (from, t) =
        if slope > 0.66 { (FRAC_PI_4, (slope - 1.0) / (slope + 1.0)) } else { (0.0, slope) };
    let z = t * t;
    let polynomial = |terms: &[f64]| terms.iter().rev().fold(0.0, |sum, term| sum * z + term);
    from + (t + t * (z * polynomial(&ATAN_P) / polynomial(&ATAN_Q)))
}

#[cfg(test)]
mod tests {
    use super::{atan2, sin_cos};
    use parry::math::Real;

    #[test]
    fn agrees_with_the_standard_library() {
        for k in -2000..2000_i16 {
            let angle = Real::from(k) * 0.037;
            let (sine, cosine) = sin_cos(angle);
            let expected = (angle.sin(), angle.cos());
            let error = (sine - expected.0).abs().max((cosine - expected.1).abs());
            assert!(error < 2.0 * Real::EPSILON, "{angle}: {error}");
        }
        assert_eq!(sin_cos(0.0), (0.0, 1.0));
    }

    #[test]
    fn angles_agree_with_the_standard_library() {
        for k in -2000..2000_i16 {
            let angle = Real::from(k) * 0.00157;
            for length in [1.0e-30, 0.3, 1.0e30] {
                let (y, x) = (angle.sin() * length, angle.cos() * length);
                let (found, expected) = (atan2(y, x), y.atan2(x));
                // Two units in the last place at most.
                assert!(
                    (found - expected).abs() <= 2.0 * Real::EPSILON * expected.abs(),
                    "{y}, {x}: {found}"
                );
            }
        }
        let quarter = core::f64::consts::FRAC_PI_2 as Real;
        assert_eq!([atan2(0.0, 0.0), atan2(0.0, 2.0), atan2(3.0, 0.0)], [0.0, 0.0, quarter]);
        assert_eq!([atan2(0.0, -1.0), atan2(-3.0, 0.0)], [2.0 * quarter, -quarter]);
    }

    #[test]
    fn nonsense_gives_nonsense_and_no_panic() {
        assert!(sin_cos(Real::INFINITY).0.is_nan() && sin_cos(Real::NAN).1.is_nan());
        assert!(atan2(Real::NAN, 1.0).is_nan() && atan2(1.0, Real::NAN).is_nan());
        let (sine, cosine) = sin_cos(Real::MAX);
        assert!(!sine.is_infinite() && !cosine.is_infinite());
    }
}
