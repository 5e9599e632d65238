//! The vocabulary of the shared tests in 2D.

use rapier::prelude::*;

/// What tables are headed with.
pub const NAME: &str = "2D";
/// Acceleration of a disc that rolls down a slope, as a share of sliding: `1 / (1 + I / m r²)` with
/// `I = 1/2 m r²`.
pub const ROLLING_BALL: Real = 2.0 / 3.0;

/// A vector.
pub fn vec(x: Real, y: Real) -> Vector {
    Vector::new(x, y)
}

/// An angle or angular velocity.
pub fn about_z(angle: Real) -> AngVector {
    angle
}

/// The same, back.
pub fn z_of(w: AngVector) -> Real {
    w
}

/// The angle by which a body is turned.
pub fn angle(rotation: &Rotation) -> Real {
    rotation.angle()
}

/// A box.
pub fn cuboid(half_width: Real, half_height: Real) -> ColliderBuilder {
    ColliderBuilder::cuboid(half_width, half_height)
}

#[path = "hostile/dim2.rs"]
pub mod hostile;
