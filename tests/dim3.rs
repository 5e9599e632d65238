//! The vocabulary of the shared tests in 3D. Their pictures lie in the plane of x and y.

use rapier::prelude::*;

/// What tables are headed with.
pub const NAME: &str = "3D";
/// Acceleration of a ball that rolls down a slope, as a share of sliding: `1 / (1 + I / m r²)` with
/// `I = 2/5 m r²`.
pub const ROLLING_BALL: Real = 5.0 / 7.0;

/// A vector in the plane of the picture.
pub fn vec(x: Real, y: Real) -> Vector {
    Vector::new(x, y, 0.0)
}

/// A rotation vector or angular velocity about the axis that points out of the picture.
pub fn about_z(angle: Real) -> AngVector {
    AngVector::new(0.0, 0.0, angle)
}

/// Its component about that axis.
pub fn z_of(w: AngVector) -> Real {
    w.z
}

/// The angle by which a body is turned about that axis.
pub fn angle(rotation: &Rotation) -> Real {
    rotation.to_scaled_axis().z
}

/// A box that is as deep as it is wide.
pub fn cuboid(half_width: Real, half_height: Real) -> ColliderBuilder {
    ColliderBuilder::cuboid(half_width, half_height, half_width)
}

#[path = "hostile/dim3.rs"]
pub mod hostile;
