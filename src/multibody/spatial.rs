//! Spatial vectors and matrices of the recursions over links.

use crate::dim::math::{
    ANG_DIM, AngVector, DIM, Real, SPATIAL_DIM, SpatialVector, Vector, cross, torque,
};
use crate::dim::spatial::{ANG_AXES, angular, join, linear};

/// The spatial vector of nothing.
pub const ZERO: SpatialVector = [0.0; SPATIAL_DIM];

/// `a · b`: the power of a wrench at a velocity.
#[inline]
pub fn dot(a: &SpatialVector, b: &SpatialVector) -> Real {
    let mut sum = 0.0;
    for k in 0..SPATIAL_DIM {
        sum += a[k] * b[k];
    }
    sum
}

/// `target += vector · factor`.
#[inline]
pub fn add_scaled(target: &mut SpatialVector, vector: &SpatialVector, factor: Real) {
    for k in 0..SPATIAL_DIM {
        target[k] += vector[k] * factor;
    }
}

/// `X v`: a velocity (or acceleration without velocity) of a body, at `r` from where it was measured.
#[inline]
pub fn carry(v: &SpatialVector, r: Vector) -> SpatialVector {
    join(linear(v) + cross(angular(v), r), angular(v))
}

/// `Xᵀ f`: a wrench that acts at `r` from where it is to be measured.
#[inline]
pub fn carry_back(f: &SpatialVector, r: Vector) -> SpatialVector {
    join(linear(f), angular(f) + torque(r, linear(f)))
}

/// The angular part of an inertia, row after row.
pub type AngularMatrix = [[Real; ANG_DIM]; ANG_DIM];

/// `I ω`.
#[inline]
pub fn angular_momentum(inertia: &AngularMatrix, angvel: AngVector) -> AngVector {
    let w = angular_numbers(angvel);
    let mut product = ZERO;
    for (row, target) in inertia.iter().zip(&mut product[DIM..]) {
        for k in 0..ANG_DIM {
            *target += row[k] * w[k];
        }
    }
    angular(&product)
}

fn angular_numbers(w: AngVector) -> [Real; ANG_DIM] {
    let numbers = join(Vector::ZERO, w);
    core::array::from_fn(|k| numbers[DIM + k])
}

/// A symmetric spatial matrix: an inertia, rigid or articulated. All entries are kept: the compiler makes
/// wide instructions of whole rows.
#[derive(Copy, Clone, Debug, Default)]
pub struct SpatialMatrix([SpatialVector; SPATIAL_DIM]);

impl SpatialMatrix {
    /// No inertia.
    pub const ZERO: Self = Self([ZERO; SPATIAL_DIM]);

    /// The spatial inertia of a rigid body about its centre of mass.
    pub fn rigid(mass: Real, inertia: &AngularMatrix) -> Self {
        let mut matrix = Self::ZERO;
        for k in 0..DIM {
            matrix.0[k][k] = mass;
        }
        for (row, entries) in matrix.0[DIM..].iter_mut().zip(inertia) {
            row[DIM..].copy_from_slice(entries);
        }
        matrix
    }

    /// The spatial inertia of several bodies about a point, with the sum of their moments `m r` from there.
    pub fn composite(mass: Real, moment: Vector, inertia: &AngularMatrix) -> Self {
        let mut matrix = Self::rigid(mass, inertia);
        for (k, axis) in ANG_AXES.into_iter().enumerate() {
            let momentum = join(cross(axis, moment), axis);
            for (row, entry) in momentum[..DIM].iter().enumerate() {
                matrix.0[DIM + k][row] = *entry;
                matrix.0[row][DIM + k] = *entry;
            }
        }
        matrix
    }

    /// The product with a vector.
    #[inline]
    pub fn mul(&self, v: &SpatialVector) -> SpatialVector {
        let mut product = ZERO;
        for (column, factor) in self.0.iter().zip(v) {
            add_scaled(&mut product, column, *factor);
        }
        product
    }

    /// Adds another matrix.
    #[inline]
    pub fn add(&mut self, other: &Self) {
        for (column, more) in self.0.iter_mut().zip(&other.0) {
            add_scaled(column, more, 1.0);
        }
    }

    /// Adds `a bᵀ · factor`.
    #[inline]
    pub fn add_product(&mut self, a: &SpatialVector, b: &SpatialVector, factor: Real) {
        for (column, entry) in self.0.iter_mut().zip(b) {
            add_scaled(column, a, entry * factor);
        }
    }

    /// `X Ω Xᵀ`: the response of a body to wrenches at `r` from where it was measured, there.
    pub fn carried(&self, r: Vector) -> Self {
        let columns = self.0.map(|column| carry(&column, r));
        let rows: [SpatialVector; SPATIAL_DIM] =
            core::array::from_fn(|k| carry(&columns.map(|column| column[k]), r));
        Self(rows)
    }

    /// The diagonal.
    pub fn diagonal(&self) -> SpatialVector {
        core::array::from_fn(|k| self.0[k][k])
    }

    /// Adds to the diagonal.
    pub fn add_diagonal(&mut self, numbers: &SpatialVector) {
        for (k, number) in numbers.iter().enumerate() {
            self.0[k][k] += number;
        }
    }

    /// The inverse of a matrix without negative eigenvalues. Where the pivot of an axis is not above the
    /// least one, or is infinite, the axis is left out: the inverse has zeros there.
    ///
    /// Each step of Gauss and Jordan sweeps one axis; after all of them, the matrix is the negative inverse.
    pub fn inverse(&self, least_pivots: &SpatialVector) -> Self {
        let mut a = self.0;
        for k in 0..SPATIAL_DIM {
            let (pivot, column) = (a[k][k], a[k]);
            let is_determined = pivot > least_pivots[k] && pivot.is_finite();
            let inverse = if is_determined { 1.0 / pivot } else { 0.0 };
            for (j, other) in a.iter_mut().enumerate() {
                let factor = column[j] * inverse;
                for (entry, swept) in other.iter_mut().zip(&column) {
                    *entry -= swept * factor;
                }
                other[k] = factor;
            }
            a[k] = column.map(|entry| entry * inverse);
            a[k][k] = -inverse;
        }
        Self(a.map(|column| column.map(|entry| -entry)))
    }

    /// `Xᵀ I X`: the inertia at `r` from the reference point, about that point.
    pub fn carried_back(&self, r: Vector) -> Self {
        // A rotation about an axis moves a point at `r` by `axis × r`: columns of I X, then rows of Xᵀ I X.
        let along = ANG_AXES.map(|axis| join(cross(axis, r), axis));
        let mut columns = self.0;
        for (column, motion) in columns[DIM..].iter_mut().zip(&along) {
            *column = self.mul(motion);
        }
        Self(columns.map(|column| carry_back(&column, r)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inverses_invert_what_is_determined() {
        let mut inertia: AngularMatrix = [[0.0; ANG_DIM]; ANG_DIM];
        for (k, row) in inertia.iter_mut().enumerate() {
            row[k] = 0.3 + k as Real;
        }
        let matrix =
            SpatialMatrix::rigid(2.0, &inertia).carried_back(Vector::X * 0.7 - Vector::Y * 0.4);
        let mut least = [1.0e-6; SPATIAL_DIM];
        let v: SpatialVector = core::array::from_fn(|k| 1.0 - 0.4 * k as Real);
        let found = matrix.inverse(&least).mul(&matrix.mul(&v));
        assert!(found.iter().zip(&v).all(|(a, b)| (a - b).abs() < 1.0e-5), "{found:?} for {v:?}");
        // A locked axis gets nothing, and the others move as if it stood still.
        least[1] = Real::MAX;
        let (mut locked, push) = (v, [1.0; SPATIAL_DIM]);
        locked.copy_from_slice(&matrix.inverse(&least).mul(&push));
        assert_eq!(locked[1], 0.0);
        let back = matrix.mul(&locked);
        assert!((0..SPATIAL_DIM).all(|k| k == 1 || (back[k] - 1.0).abs() < 1.0e-5), "{back:?}");
    }

    #[test]
    fn a_carried_inertia_is_the_sum_of_carried_parts() {
        let r = Vector::X * 0.7 - Vector::Y * 0.4;
        let mut inertia: AngularMatrix = [[0.0; ANG_DIM]; ANG_DIM];
        for (k, row) in inertia.iter_mut().enumerate() {
            row[k] = 0.3 + k as Real;
        }
        let matrix = SpatialMatrix::rigid(2.0, &inertia);
        let v: SpatialVector = core::array::from_fn(|k| 1.0 - 0.4 * k as Real);
        let momentum = SpatialMatrix::composite(2.0, r * 2.0, &inertia).mul(&v);
        let of_mass = linear(&carry(&v, r)) * 2.0;
        let linear_error = (linear(&momentum) - of_mass).length();
        assert!(linear_error < 1.0e-5, "{momentum:?} for {of_mass}");
        let expected = carry_back(&matrix.mul(&carry(&v, r)), r);
        let found = matrix.carried_back(r).mul(&v);
        let error = found.iter().zip(&expected).map(|(a, b)| (a - b).abs());
        assert!(error.fold(0.0, Real::max) < 1.0e-5, "{found:?} for {expected:?}");
    }
}
