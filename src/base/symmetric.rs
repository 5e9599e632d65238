//! Symmetric systems of linear equations without negative eigenvalues, by `A = L D Lᵀ`.
//!
//! A matrix is the list of its lower half, row after row.

use parry::math::Real;

/// A pivot below this fraction of the row's diagonal element is rounding: the row is redundant.
const PIVOT_MIN: f64 = 64.0 * Real::EPSILON as f64;

/// Where a row of the list begins.
fn start(row: usize) -> usize {
    row * (row + 1) / 2
}

/// Replaces a matrix of this size by `L`, with the inverse of `D` on the diagonal: 0 for redundant rows.
pub fn factorize(a: &mut [f64], size: usize) {
    for i in 0..size {
        let own = a[start(i) + i];
        for j in 0..i {
            for m in 0..j {
                a[start(i) + j] -= a[start(i) + m] * a[start(j) + m];
            }
        }
        // The row holds `L D` so far.
        let mut pivot = own;
        for j in 0..i {
            let unscaled = a[start(i) + j];
            a[start(i) + j] *= a[start(j) + j];
            pivot -= unscaled * a[start(i) + j];
        }
        a[start(i) + i] = if pivot > PIVOT_MIN * own { 1.0 / pivot } else { 0.0 };
    }
}

/// Solves `A x = b` in place with the factors of `A`. Components of redundant rows are 0.
pub fn solve(factors: &[f64], x: &mut [f64]) {
    for i in 0..x.len() {
        for j in 0..i {
            x[i] -= factors[start(i) + j] * x[j];
        }
    }
    for i in (0..x.len()).rev() {
        x[i] *= factors[start(i) + i];
        for k in i + 1..x.len() {
            x[i] -= factors[start(k) + i] * x[k];
        }
    }
}
