//! Vectors, rotations, poses, and their number type.

pub use crate::dim::math::{
    ANG_DIM, AngVector, AngularInertia, DIM, Int, Isometry, MAX_MANIFOLD_POINTS, Matrix,
    Orientation, Point, Pose, Real, Rotation, SPATIAL_DIM, SpatialVector, Vector,
    rotation_from_angle,
};
// The mathematics under `Vector` and `Pose`: programs that name a dimension name these.
pub use parry::glamx;
pub use parry::math::{IVector, Mat2, Mat3, Pose2, Pose3, Rot2, Rot3, Vec2, Vec3};

/// The Jacobian of a link of a multibody. Each element is the velocity of the link for a unit velocity of one
/// degree of freedom.
pub type Jacobian = Vec<SpatialVector>;

/// The components of a vector as a slice.
pub trait AsSlice {
    /// The components, `x` first.
    fn as_slice(&self) -> &[Real];
}

impl AsSlice for Vector {
    fn as_slice(&self) -> &[Real] {
        let components: &[Real; DIM] = self.as_ref();
        components
    }
}

/// A [`Vector`](crate::math::Vector) from its components: `vector![1.0, 2.0, 3.0]` in 3D,
/// `vector![1.0, 2.0]` in 2D.
#[macro_export]
macro_rules! vector {
    ($($component:expr),+ $(,)?) => { $crate::math::Vector::new($($component),+) };
}

/// A [`Point`](crate::math::Point) from its coordinates: `point![1.0, 2.0, 3.0]` in 3D,
/// `point![1.0, 2.0]` in 2D.
#[macro_export]
macro_rules! point {
    ($($coordinate:expr),+ $(,)?) => { $crate::math::Point::new($($coordinate),+) };
}
