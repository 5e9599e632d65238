//! Types and operations that belong to a kind of numbers.

use crate::math::{AngVector, AngularInertia, Matrix, Pose, Real, Rotation, Vector};
use na::{SimdRealField, SimdValue};

/// Numbers that are copied, alone or in lanes.
pub trait SimdRealCopy: SimdRealField<Element = Real> + Copy {}

impl<T: SimdRealField<Element = Real> + Copy> SimdRealCopy for T {}

/// Numbers, with the types of vectors, rotations and matrices over them.
pub trait ScalarType: SimdRealField<Element = Real> + Copy {
    /// Type of poses.
    type Pose: PoseOps<Self>;
    /// Type of vectors.
    type Vector: Copy;
    /// Type of angular vectors.
    type AngVector: Copy;
    /// Type of matrices.
    type Matrix: Copy;
    /// Type of angular inertias.
    type AngInertia: Copy;
    /// Type of rotations.
    type Rotation: RotationOps<Self>;
}

impl ScalarType for Real {
    type Pose = Pose;
    type Vector = Vector;
    type AngVector = AngVector;
    type Matrix = Matrix;
    type AngInertia = AngularInertia;
    type Rotation = Rotation;
}

/// Operations of poses.
pub trait PoseOps<N: ScalarType>: Copy {
    /// The rotation.
    fn rotation(&self) -> N::Rotation;
    /// The translation.
    fn translation(&self) -> N::Vector;
    /// Sets the translation.
    fn set_translation(&mut self, tra: N::Vector);
    /// The pose after a translation in its own frame.
    #[must_use]
    fn prepend_translation(&self, translation: N::Vector) -> Self;
    /// The pose after a translation in the outer frame.
    #[must_use]
    fn append_translation(&self, translation: N::Vector) -> Self;
    /// The pose after a rotation in its own frame (rad).
    #[must_use]
    fn prepend_rotation(&self, axisangle: N::AngVector) -> Self;
    /// The pose after a rotation about the origin of the outer frame (rad).
    #[must_use]
    fn append_rotation(&self, axisangle: N::AngVector) -> Self;
}

impl PoseOps<Real> for Pose {
    fn rotation(&self) -> Rotation {
        self.rotation
    }

    fn translation(&self) -> Vector {
        self.translation
    }

    fn set_translation(&mut self, tra: Vector) {
        self.translation = tra;
    }

    fn prepend_translation(&self, translation: Vector) -> Self {
        Self::from_parts(*self * translation, self.rotation)
    }

    fn append_translation(&self, translation: Vector) -> Self {
        Self::from_parts(self.translation + translation, self.rotation)
    }

    fn prepend_rotation(&self, axisangle: AngVector) -> Self {
        let rotation = crate::math::rotation_from_angle(axisangle);
        Self::from_parts(self.translation, self.rotation * rotation)
    }

    fn append_rotation(&self, axisangle: AngVector) -> Self {
        let rotation = crate::math::rotation_from_angle(axisangle);
        Self::from_parts(rotation * self.translation, rotation * self.rotation)
    }
}

/// Operations of rotations.
pub trait RotationOps<N: ScalarType>: Copy {
    /// The matrix of the rotation.
    fn to_mat(self) -> N::Matrix;
    /// The inverse rotation.
    #[must_use]
    fn inverse(self) -> Self;
}

impl RotationOps<Real> for Rotation {
    fn to_mat(self) -> Matrix {
        #[cfg(feature = "dim2")]
        return Matrix::from_cols(self * Vector::X, self * Vector::Y);
        #[cfg(feature = "dim3")]
        return Matrix::from_quat(self);
    }

    fn inverse(self) -> Self {
        // One type takes its receiver by value, the other by reference.
        let rotation = self;
        rotation.inverse()
    }
}

/// Operations of angular inertias.
pub trait AngularInertiaOps<N>: Copy + core::fmt::Debug + Default {
    /// Type of angular vectors.
    type AngVector;
    /// Type of matrices.
    type AngMatrix;
    /// The inverse; zero for an inertia without one.
    #[must_use]
    fn inverse(&self) -> Self;
    /// The product with an angular vector.
    fn transform_vector(&self, pt: Self::AngVector) -> Self::AngVector;
    /// The inertia as a matrix.
    fn into_matrix(self) -> Self::AngMatrix;
}

impl AngularInertiaOps<Real> for Real {
    type AngVector = Real;
    type AngMatrix = Real;

    fn inverse(&self) -> Self {
        if *self == 0.0 { 0.0 } else { 1.0 / self }
    }

    fn transform_vector(&self, pt: Real) -> Real {
        self * pt
    }

    fn into_matrix(self) -> Real {
        self
    }
}

#[cfg(feature = "dim3")]
impl AngularInertiaOps<Real> for AngularInertia {
    type AngVector = Vector;
    type AngMatrix = Matrix;

    fn inverse(&self) -> Self {
        let matrix = AngularInertiaOps::into_matrix(*self);
        if matrix.determinant() == 0.0 {
            return Self::zero();
        }
        let [x, y, z] = [0, 1, 2].map(|i| matrix.inverse().col(i));
        Self { m11: x.x, m12: x.y, m13: x.z, m22: y.y, m23: y.z, m33: z.z }
    }

    fn transform_vector(&self, pt: Vector) -> Vector {
        AngularInertiaOps::into_matrix(*self) * pt
    }

    fn into_matrix(self) -> Matrix {
        Matrix::from_cols(
            Vector::new(self.m11, self.m12, self.m13),
            Vector::new(self.m12, self.m22, self.m23),
            Vector::new(self.m13, self.m23, self.m33),
        )
    }
}

/// Selection by a condition for each lane.
pub trait SimdSelect<N: SimdValue> {
    /// `self` where the condition is true, elsewhere the other value.
    #[must_use]
    fn select(self, condition: N::SimdBool, if_false: Self) -> Self;
}

impl SimdSelect<Real> for Vector {
    fn select(self, condition: bool, if_false: Self) -> Self {
        if condition { self } else { if_false }
    }
}
