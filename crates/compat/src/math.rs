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
    /// Vector over any numbers.
    pub type SimdVector<N> = na::Vector2<N>;
    /// Point over any numbers.
    pub type SimdPoint<N> = na::Point2<N>;
    /// Pose over any numbers.
    pub type SimdPose<N> = na::Isometry2<N>;
    /// Rotation over any numbers.
    pub type SimdRotation<N> = na::UnitComplex<N>;
    /// Matrix over any numbers.
    pub type SimdMatrix<N> = na::Matrix2<N>;
    /// Angular vector over any numbers.
    pub type SimdAngVector<N> = N;
    /// Angular inertia over any numbers.
    pub type SimdAngularInertia<N> = N;
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
    /// Vector over any numbers.
    pub type SimdVector<N> = na::Vector3<N>;
    /// Point over any numbers.
    pub type SimdPoint<N> = na::Point3<N>;
    /// Pose over any numbers.
    pub type SimdPose<N> = na::Isometry3<N>;
    /// Rotation over any numbers.
    pub type SimdRotation<N> = na::UnitQuaternion<N>;
    /// Matrix over any numbers.
    pub type SimdMatrix<N> = na::Matrix3<N>;
    /// Angular vector over any numbers.
    pub type SimdAngVector<N> = na::Vector3<N>;
    /// Angular inertia over any numbers.
    pub type SimdAngularInertia<N> = crate::parry::utils::SdpMatrix3<N>;
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
