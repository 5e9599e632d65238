//! Small dense blocks: joint against joint.
//!
//! Blocks are stored by columns: the innermost loop runs over a whole column, whose length is a compile-time
//! constant.

use crate::dim::math::Real;

/// A pivot below this fraction of its value before elimination is rounding: the row is redundant. A row that
/// differs from the others by the rounding of its numbers alone has a pivot of the square of that. (Where
/// locked rotations of the bodies leave nearly nothing to move, that value is rounding itself. Components
/// with redundant rows therefore use the joint's largest element of its kind.)
pub(super) const PIVOT_MIN: f64 =
    64.0 * (Real::EPSILON as f64) * (Real::EPSILON as f64) + 16.0 * f64::EPSILON;

/// A number for each row of a joint.
pub(super) type Column<const N: usize> = [f64; N];
/// Columns of a matrix.
pub(super) type Block<const N: usize> = [Column<N>; N];

/// A block of zeros.
pub(super) const fn zero<const N: usize>() -> Block<N> {
    [[0.0; N]; N]
}

/// Factorises a diagonal block in place, and returns the inverse pivots. Rows with a pivot of no more than
/// `least` are left out.
#[inline(always)]
pub(super) fn factorise<const N: usize>(
    d: &mut Block<N>,
    least: &Column<N>,
    size: usize,
) -> Column<N> {
    let mut inverses = [0.0; N];
    for j in 0..size {
        let pivot = d[j][j];
        let inverse = if pivot > least[j] { 1.0 / pivot } else { 0.0 };
        inverses[j] = inverse;
        let unscaled = d[j];
        d[j].iter_mut().for_each(|value| *value *= inverse);
        for m in j + 1..size {
            let factor = d[j][m];
            add(&mut d[m], &unscaled, -factor);
        }
    }
    inverses
}

/// `block ← block L⁻ᵀ` for a diagonal block that is factorised.
#[inline(always)]
pub(super) fn divide_right<const N: usize>(block: &mut Block<N>, d: &Block<N>, size: usize) {
    for j in 1..size {
        let (done, rest) = block.split_at_mut(j);
        for (m, column) in done.iter().enumerate() {
            add(&mut rest[0], column, -d[m][j]);
        }
    }
}

/// Adds a multiple of a column to another.
#[inline(always)]
pub(super) fn add<const N: usize>(target: &mut [f64; N], column: &[f64; N], factor: f64) {
    for (target, value) in target.iter_mut().zip(column) {
        *target += value * factor;
    }
}

#[inline(always)]
pub(super) fn dot<const N: usize>(a: &Column<N>, b: &Column<N>) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
