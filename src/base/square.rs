//! Square matrices of any size, and systems of linear equations.

use super::symmetric::{factorize, solve};
use parry::math::Real;

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
        let rows = (0..self.size).flat_map(|row| (0..=row).map(move |column| (row, column)));
        let mut factors: Vec<_> = rows.map(|at| f64::from(self[at])).collect();
        factorize(&mut factors, self.size);
        let mut x: Vec<_> = vector.iter().copied().map(f64::from).collect();
        solve(&factors, &mut x);
        x.into_iter().map(|number| number as Real).collect()
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
