//! Products of vectors, for the vectors of glam and of nalgebra. Angular vectors are numbers in 2D.

use super::SimdRealCopy;
use crate::math::{Real, Vector};
use na::{SimdRealField, Vector1, Vector2, Vector3};

/// The product of equal components.
pub trait ComponentMul: Sized {
    /// The product of equal components.
    fn component_mul(&self, other: &Self) -> Self;
}

/// The cross product.
pub trait CrossProduct<Rhs>: Sized {
    /// Type of the product.
    type Result;
    /// The cross product.
    fn gcross(&self, rhs: Rhs) -> Self::Result;
}

/// The cross product with a vector as a matrix.
pub trait CrossProductMatrix: Sized {
    /// Type of the matrix.
    type CrossMat;
    /// Type of the transposed matrix.
    type CrossMatTr;
    /// The matrix.
    fn gcross_matrix(self) -> Self::CrossMat;
    /// The transposed matrix.
    fn gcross_matrix_tr(self) -> Self::CrossMatTr;
}

/// The scalar product.
pub trait DotProduct<Rhs>: Sized + Copy {
    /// Type of the product.
    type Result: SimdRealField;
    /// The scalar product.
    fn gdot(&self, rhs: Rhs) -> Self::Result;
}

/// The length.
pub trait SimdLength: DotProduct<Self> {
    /// The length.
    fn simd_length(&self) -> Self::Result {
        na::SimdComplexField::simd_sqrt(self.gdot(*self))
    }
}

impl<T: DotProduct<T>> SimdLength for T {}

/// The sign of a number on another number.
pub trait CopySign<Rhs>: Sized {
    /// `to` with the sign of `self`.
    fn copy_sign_to(self, to: Rhs) -> Rhs;
}

/// Vectors that form an orthonormal basis with a unit vector.
pub trait OrthonormalBasis: Sized {
    /// Type of the vectors.
    type Basis;
    /// The vectors.
    fn orthonormal_basis(self) -> Self::Basis;
    /// The last of the vectors.
    fn orthonormal_vector(self) -> Self;
}

impl ComponentMul for Vector {
    fn component_mul(&self, other: &Self) -> Self {
        *self * *other
    }
}

impl<N: SimdRealCopy> ComponentMul for Vector2<N> {
    fn component_mul(&self, other: &Self) -> Self {
        self.zip_map(other, |a, b| a * b)
    }
}

impl<N: SimdRealCopy> ComponentMul for Vector3<N> {
    fn component_mul(&self, other: &Self) -> Self {
        self.zip_map(other, |a, b| a * b)
    }
}

impl<N: SimdRealField + Copy> CrossProduct<Vector2<N>> for Vector2<N> {
    type Result = N;

    fn gcross(&self, rhs: Self) -> N {
        self.x * rhs.y - self.y * rhs.x
    }
}

impl<N: SimdRealField + Copy> CrossProduct<Vector2<N>> for N {
    type Result = Vector2<N>;

    fn gcross(&self, rhs: Vector2<N>) -> Vector2<N> {
        Vector2::new(-rhs.y * *self, rhs.x * *self)
    }
}

impl<N: SimdRealField + Copy> CrossProduct<Vector3<N>> for Vector3<N> {
    type Result = Self;

    fn gcross(&self, rhs: Self) -> Self {
        self.cross(&rhs)
    }
}

impl<N: SimdRealCopy> CrossProductMatrix for Vector2<N> {
    type CrossMat = Self;
    type CrossMatTr = Self;

    fn gcross_matrix(self) -> Self {
        Self::new(-self.y, self.x)
    }

    fn gcross_matrix_tr(self) -> Self {
        Self::new(-self.y, self.x)
    }
}

impl<N: SimdRealCopy> CrossProductMatrix for Vector3<N> {
    type CrossMat = na::Matrix3<N>;
    type CrossMatTr = na::Matrix3<N>;

    fn gcross_matrix(self) -> na::Matrix3<N> {
        self.cross_matrix()
    }

    fn gcross_matrix_tr(self) -> na::Matrix3<N> {
        -self.cross_matrix()
    }
}

impl CrossProductMatrix for Real {
    type CrossMat = na::Matrix2<Real>;
    type CrossMatTr = na::Matrix2<Real>;

    fn gcross_matrix(self) -> na::Matrix2<Real> {
        na::Matrix2::new(0.0, -self, self, 0.0)
    }

    fn gcross_matrix_tr(self) -> na::Matrix2<Real> {
        -self.gcross_matrix()
    }
}

impl DotProduct<Vector> for Vector {
    type Result = Real;

    fn gdot(&self, rhs: Vector) -> Real {
        self.dot(rhs)
    }
}

impl DotProduct<Real> for Real {
    type Result = Real;

    fn gdot(&self, rhs: Real) -> Real {
        self * rhs
    }
}

impl<N: SimdRealCopy> DotProduct<Vector1<N>> for N {
    type Result = N;

    fn gdot(&self, rhs: Vector1<N>) -> N {
        *self * rhs.x
    }
}

impl<N: SimdRealCopy> DotProduct<N> for Vector1<N> {
    type Result = N;

    fn gdot(&self, rhs: N) -> N {
        self.x * rhs
    }
}

impl<N: SimdRealCopy> DotProduct<Vector2<N>> for Vector2<N> {
    type Result = N;

    fn gdot(&self, rhs: Self) -> N {
        self.dot(&rhs)
    }
}

impl<N: SimdRealCopy> DotProduct<Vector3<N>> for Vector3<N> {
    type Result = N;

    fn gdot(&self, rhs: Self) -> N {
        self.dot(&rhs)
    }
}

impl CopySign<Real> for Real {
    fn copy_sign_to(self, to: Real) -> Real {
        to.copysign(self)
    }
}

impl CopySign<Vector2<Real>> for Vector2<Real> {
    fn copy_sign_to(self, to: Self) -> Self {
        self.zip_map(&to, CopySign::copy_sign_to)
    }
}

impl CopySign<Vector3<Real>> for Vector3<Real> {
    fn copy_sign_to(self, to: Self) -> Self {
        self.zip_map(&to, CopySign::copy_sign_to)
    }
}

#[cfg(feature = "dim2")]
mod dimension {
    use super::{CrossProduct, CrossProductMatrix, OrthonormalBasis};
    use crate::math::{Real, Vector};

    impl CrossProduct<Vector> for Vector {
        type Result = Real;

        fn gcross(&self, rhs: Vector) -> Real {
            self.perp_dot(rhs)
        }
    }

    impl CrossProduct<Vector> for Real {
        type Result = Vector;

        fn gcross(&self, rhs: Vector) -> Vector {
            rhs.perp() * *self
        }
    }

    impl CrossProductMatrix for Vector {
        type CrossMat = Self;
        type CrossMatTr = Self;

        fn gcross_matrix(self) -> Self {
            self.perp()
        }

        fn gcross_matrix_tr(self) -> Self {
            self.perp()
        }
    }

    impl OrthonormalBasis for Vector {
        type Basis = [Self; 1];

        fn orthonormal_basis(self) -> [Self; 1] {
            [self.perp()]
        }

        fn orthonormal_vector(self) -> Self {
            self.perp()
        }
    }
}

#[cfg(feature = "dim3")]
mod dimension {
    use super::{CrossProduct, CrossProductMatrix, OrthonormalBasis};
    use crate::math::{Matrix, Vector};

    impl CrossProduct<Vector> for Vector {
        type Result = Self;

        fn gcross(&self, rhs: Vector) -> Self {
            self.cross(rhs)
        }
    }

    impl CrossProductMatrix for Vector {
        type CrossMat = Matrix;
        type CrossMatTr = Matrix;

        fn gcross_matrix(self) -> Matrix {
            let column = |axis: Vector| self.cross(axis);
            Matrix::from_cols(column(Vector::X), column(Vector::Y), column(Vector::Z))
        }

        fn gcross_matrix_tr(self) -> Matrix {
            (-self).gcross_matrix()
        }
    }

    impl OrthonormalBasis for Vector {
        type Basis = [Self; 2];

        fn orthonormal_basis(self) -> [Self; 2] {
            let (first, second) = self.any_orthonormal_pair();
            [first, second]
        }

        fn orthonormal_vector(self) -> Self {
            self.any_orthonormal_pair().1
        }
    }
}
