//! Access to parts of lists and matrices.

use crate::math::{Matrix, Vector};
use core::ops::IndexMut;

/// Mutable access to two elements of a list.
pub trait IndexMut2<I>: IndexMut<I> {
    /// Two elements, both mutable.
    ///
    /// # Panics
    /// If both indices are equal or one of them is out of range.
    fn index_mut2(&mut self, i: usize, j: usize) -> (&mut Self::Output, &mut Self::Output);

    /// Two elements, the first mutable.
    ///
    /// # Panics
    /// If both indices are equal or one of them is out of range.
    fn index_mut_const(&mut self, i: usize, j: usize) -> (&mut Self::Output, &Self::Output) {
        let (first, second) = self.index_mut2(i, j);
        (first, second)
    }
}

impl<T> IndexMut2<usize> for [T] {
    fn index_mut2(&mut self, i: usize, j: usize) -> (&mut T, &mut T) {
        let [first, second] =
            self.get_disjoint_mut([i, j]).expect("two different elements of the list");
        (first, second)
    }
}

impl<T> IndexMut2<usize> for Vec<T> {
    fn index_mut2(&mut self, i: usize, j: usize) -> (&mut T, &mut T) {
        self.as_mut_slice().index_mut2(i, j)
    }
}

/// The columns of a matrix.
pub trait MatrixColumn {
    /// Type of a column.
    type Column;
    /// A column.
    fn column(&self, i: usize) -> Self::Column;
}

impl MatrixColumn for Matrix {
    type Column = Vector;

    fn column(&self, i: usize) -> Vector {
        self.col(i)
    }
}

impl<T: na::Scalar> MatrixColumn for na::Matrix2<T> {
    type Column = na::Vector2<T>;

    fn column(&self, i: usize) -> na::Vector2<T> {
        self.column(i).into_owned()
    }
}

impl<T: na::Scalar> MatrixColumn for na::Matrix3<T> {
    type Column = na::Vector3<T>;

    fn column(&self, i: usize) -> na::Vector3<T> {
        self.column(i).into_owned()
    }
}

impl<T: Copy> MatrixColumn for [T; 2] {
    type Column = T;

    fn column(&self, i: usize) -> T {
        self[i]
    }
}
