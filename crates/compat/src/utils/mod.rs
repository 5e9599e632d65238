//! Small mathematical helpers.

mod columns;
mod products;
mod scalar;
#[cfg(feature = "serde-serialize")]
pub mod serde;

pub use columns::{IndexMut2, MatrixColumn};
pub use products::{
    ComponentMul, CopySign, CrossProduct, CrossProductMatrix, DotProduct, OrthonormalBasis,
    SimdLength,
};
pub use scalar::{AngularInertiaOps, PoseOps, RotationOps, ScalarType, SimdRealCopy, SimdSelect};

use crate::math::{Matrix, Real, SimdMatrix, SimdVector, Vector};

/// Number of coordinates less one.
pub const DIM_MINUS_ONE: usize = crate::math::DIM - 1;

/// A type that several threads may read.
pub trait MaybeSync: Sync {}

impl<T: Sync + ?Sized> MaybeSync for T {}

/// The unit vector and the length of a vector that is longer than `threshold`.
pub fn try_normalize_and_get_length(v: Vector, threshold: Real) -> Option<(Vector, Real)> {
    let length = v.length();
    (length > threshold).then(|| (v / length, length))
}

/// A vector of nalgebra with the same components.
pub fn vect_to_na(v: Vector) -> SimdVector<Real> {
    SimdVector::from_column_slice(v.as_ref() as &[Real; crate::math::DIM])
}

/// A matrix of nalgebra with the same components.
pub fn mat_to_na(m: Matrix) -> SimdMatrix<Real> {
    SimdMatrix::from_columns(&core::array::from_fn::<_, { crate::math::DIM }, _>(|i| {
        vect_to_na(m.col(i))
    }))
}

/// The difference of two angles (rad), less a full turn if the rest is smaller.
pub fn smallest_abs_diff_between_angles<N: SimdRealCopy>(a: N, b: N) -> N {
    smallest_difference(a, b, N::simd_two_pi())
}

/// The difference of the sines of two half angles, less 2 if the rest is smaller.
pub fn smallest_abs_diff_between_sin_angles<N: SimdRealCopy>(a: N, b: N) -> N {
    smallest_difference(a, b, N::one() + N::one())
}

/// The difference of two values of a quantity with a period.
fn smallest_difference<N: SimdRealCopy>(a: N, b: N, period: N) -> N {
    let direct = a - b;
    let around = direct - direct.simd_signum() * period;
    direct.select(direct.simd_abs().simd_lt(around.simd_abs()), around)
}
