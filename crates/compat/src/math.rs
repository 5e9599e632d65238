//! Vectors, rotations, poses and matrices.

pub use crate::parry::glamx;
pub use crate::parry::math::*;
pub use engine::math::{ANG_DIM, MAX_MANIFOLD_POINTS, SPATIAL_DIM, rotation_from_angle};

/// Vector of any length.
pub type DVector = na::DVector<Real>;
/// Matrix of any size.
pub type DMatrix = na::DMatrix<Real>;

#[cfg(feature = "dim2")]
mod dimension {
    /// Number of coordinates.
    pub type Dim = na::U2;
    /// Number of rotational degrees of freedom.
    pub type AngDim = na::U1;
    /// Jacobian in twist coordinates.
    pub type Jacobian<N> = na::Matrix3xX<N>;
    /// Borrowed Jacobian.
    pub type JacobianView<'a, N> = na::MatrixView3xX<'a, N>;
    /// Mutably borrowed Jacobian.
    pub type JacobianViewMut<'a, N> = na::MatrixViewMut3xX<'a, N>;
    /// Friction impulse in the contact plane.
    pub type TangentImpulse<N> = na::Vector1<N>;
}

#[cfg(feature = "dim3")]
mod dimension {
    /// Number of coordinates.
    pub type Dim = na::U3;
    /// Number of rotational degrees of freedom.
    pub type AngDim = na::U3;
    /// Jacobian in twist coordinates.
    pub type Jacobian<N> = na::Matrix6xX<N>;
    /// Borrowed Jacobian.
    pub type JacobianView<'a, N> = na::MatrixView6xX<'a, N>;
    /// Mutably borrowed Jacobian.
    pub type JacobianViewMut<'a, N> = na::MatrixViewMut6xX<'a, N>;
    /// Friction impulse in the contact plane.
    pub type TangentImpulse<N> = na::Vector2<N>;
}
pub use dimension::*;
