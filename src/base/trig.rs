//! Sine and cosine with the same bits on every machine.
//!
//! Those of the standard library are the platform's, whose last bits differ. Joint angles go through them in each
//! substep, so these are made of additions and multiplications alone, which are the same everywhere.

use core::f64::consts::FRAC_2_PI;
use parry::math::Real;

/// A quarter of a turn in three parts: the first two have so few digits that their small multiples are exact
/// (Cody and Waite 1980).
const QUARTER: [f64; 3] =
    [1.570_796_251_296_997, 7.549_789_415_861_596e-8, 5.390_302_858_158_119e-15];

/// Taylor's coefficients. At an eighth of a turn, the largest angle they see, what is left out is below the
/// last digit of a double.
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

/// Sine and cosine of an angle in radians. Their last digits fade as the angle grows beyond some million turns.
pub fn sin_cos(angle: Real) -> (Real, Real) {
    let angle = f64::from(angle);
    let quarters = (angle * FRAC_2_PI).round();
    // Beyond what has digits behind the point, the rest is nonsense: any angle will do, but it must be one.
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

#[cfg(test)]
mod tests {
    use super::sin_cos;
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
    fn nonsense_gives_nonsense_and_no_panic() {
        assert!(sin_cos(Real::INFINITY).0.is_nan() && sin_cos(Real::NAN).1.is_nan());
        let (sine, cosine) = sin_cos(Real::MAX);
        assert!(!sine.is_infinite() && !cosine.is_infinite());
    }
}
