//! Square matrices of any size, and systems of linear equations.

use parry::math::Real;

/// A pivot smaller than this fraction of its diagonal entry is rounding: the row is redundant.
const PIVOT_MIN: Real = 64.0 * Real::EPSILON;

/// A square matrix, found by `(row, column)`.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct SquareMatrix {
    size: usize,
    /// Row after row.
    entries: Vec<Real>,
}

impl SquareMatrix {
    /// A matrix of zeros.
    pub fn zeros(size: usize) -> Self {
        Self { size, entries: vec![0.0; size * size] }
    }

    /// Number of rows, and of columns.
    pub fn size(&self) -> usize {
        self.size
    }

    /// The product with a vector.
    ///
    /// # Panics
    /// If the length of the vector differs from the number of columns.
    pub fn mul(&self, vector: &[Real]) -> Vec<Real> {
        assert_eq!(vector.len(), self.size, "as many numbers as columns");
        let rows = self.entries.chunks(self.size.max(1)).take(self.size);
        rows.map(|row| row.iter().zip(vector).map(|(a, b)| a * b).sum()).collect()
    }

    /// Solves `A x = b` for a symmetric matrix `A` without negative eigenvalues, by `A = L D Lᵀ`.
    /// Undetermined components are zero.
    ///
    /// # Panics
    /// If the length of the vector differs from the number of rows.
    pub fn solve_symmetric(&self, vector: &[Real]) -> Vec<Real> {
        assert_eq!(vector.len(), self.size, "as many numbers as rows");
        let (lower, inv_pivots) = self.factorize();
        let mut x = vector.to_vec();
        for row in 0..self.size {
            for column in 0..row {
                x[row] -= lower[(row, column)] * x[column];
            }
        }
        for row in (0..self.size).rev() {
            x[row] *= inv_pivots[row];
            for below in row + 1..self.size {
                x[row] -= lower[(below, row)] * x[below];
            }
            if inv_pivots[row] == 0.0 {
                x[row] = 0.0;
            }
        }
        x
    }

    /// `L`, whose diagonal of ones is left out, and the inverse of `D`: zero for redundant rows.
    fn factorize(&self) -> (Self, Vec<Real>) {
        let mut lower = Self::zeros(self.size);
        let mut pivots = vec![0.0; self.size];
        let mut inv_pivots = vec![0.0; self.size];
        for row in 0..self.size {
            for column in 0..row {
                let known = (0..column).map(|k| lower[(row, k)] * lower[(column, k)] * pivots[k]);
                let rest = self[(row, column)] - known.sum::<Real>();
                lower[(row, column)] = rest * inv_pivots[column];
            }
            let known = (0..row).map(|k| lower[(row, k)] * lower[(row, k)] * pivots[k]);
            let pivot = self[(row, row)] - known.sum::<Real>();
            if pivot > PIVOT_MIN * self[(row, row)] {
                (pivots[row], inv_pivots[row]) = (pivot, 1.0 / pivot);
            }
        }
        (lower, inv_pivots)
    }
}

impl core::ops::Index<(usize, usize)> for SquareMatrix {
    type Output = Real;

    /// # Panics
    /// If there is no such row or column.
    fn index(&self, (row, column): (usize, usize)) -> &Real {
        assert!(row < self.size && column < self.size, "({row}, {column}) of {}", self.size);
        &self.entries[row * self.size + column]
    }
}

impl core::ops::IndexMut<(usize, usize)> for SquareMatrix {
    /// # Panics
    /// If there is no such row or column.
    fn index_mut(&mut self, (row, column): (usize, usize)) -> &mut Real {
        assert!(row < self.size && column < self.size, "({row}, {column}) of {}", self.size);
        &mut self.entries[row * self.size + column]
    }
}

#[cfg(test)]
mod tests {
    use super::SquareMatrix;

    fn matrix(rows: &[[f32; 3]; 3]) -> SquareMatrix {
        let mut matrix = SquareMatrix::zeros(3);
        for (i, row) in rows.iter().enumerate() {
            for (j, &entry) in row.iter().enumerate() {
                matrix[(i, j)] = entry.into();
            }
        }
        matrix
    }

    #[test]
    fn solutions_solve() {
        let a = matrix(&[[4.0, 1.0, -2.0], [1.0, 3.0, 0.5], [-2.0, 0.5, 5.0]]);
        let b = [1.0, -2.0, 3.0];
        let back = a.mul(&a.solve_symmetric(&b));
        assert!(back.iter().zip(&b).all(|(x, y)| (x - y).abs() < 1.0e-5), "{back:?}");
    }

    #[test]
    fn undetermined_components_stay_zero() {
        let a = matrix(&[[1.0, 1.0, 0.0], [1.0, 1.0, 0.0], [0.0, 0.0, 0.0]]);
        assert_eq!(a.solve_symmetric(&[2.0, 2.0, 7.0]), [2.0, 0.0, 0.0]);
    }
}
