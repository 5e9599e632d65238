//! Shapes and vectors of three dimensions with the parameters of two.

use crate::plugin::prelude::*;
use crate::plugin::rapier::prelude as engine;
use bevy::prelude::Entity;

/// A vector in the plane of x and y.
pub fn vector(x: Scalar, y: Scalar) -> Vector {
    Vector::new(x, y, 0.0)
}

/// A rotation in the plane of x and y.
pub fn rotation(angle: Scalar) -> AngVector {
    Vector::new(0.0, 0.0, angle)
}

/// The angle in the plane.
pub fn angle(rotation: AngVector) -> Scalar {
    rotation.z
}

/// A cube or a square.
pub fn cube(half_extent: Scalar) -> Collider {
    Collider::cuboid(half_extent, half_extent, half_extent)
}

/// A floor of thickness 2.
pub fn floor() -> Collider {
    Collider::cuboid(20.0, 1.0, 20.0)
}

/// The engine's description of a cube.
pub fn engine_cube(half_extent: Scalar) -> engine::ColliderBuilder {
    engine::ColliderBuilder::cuboid(half_extent, half_extent, half_extent)
}

/// The engine's vector in the plane.
pub fn engine_vector(x: Scalar, y: Scalar) -> engine::Vector {
    engine::Vector::new(x, y, 0.0)
}

/// A hinge about z.
pub fn hinge(body1: Entity, body2: Entity) -> Joint {
    Joint::revolute(body1, body2, Vector::Z)
}

/// The axis of a hinge.
pub const HINGE: JointAxis = JointAxis::AngX;

/// Squared radius of gyration of a ball with radius 1.
pub const BALL_GYRATION: Scalar = 0.4;
