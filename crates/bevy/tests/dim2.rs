//! Shapes and vectors of two dimensions.

use crate::plugin::prelude::*;
use crate::plugin::rapier::prelude as engine;
use bevy::prelude::Entity;

/// A vector.
pub fn vector(x: Scalar, y: Scalar) -> Vector {
    Vector::new(x, y)
}

/// A rotation.
pub fn rotation(angle: Scalar) -> AngVector {
    angle
}

/// The angle.
pub fn angle(rotation: AngVector) -> Scalar {
    rotation
}

/// A cube or a square.
pub fn cube(half_extent: Scalar) -> Collider {
    Collider::cuboid(half_extent, half_extent)
}

/// A floor of thickness 2.
pub fn floor() -> Collider {
    Collider::cuboid(20.0, 1.0)
}

/// The engine's description of a square.
pub fn engine_cube(half_extent: Scalar) -> engine::ColliderBuilder {
    engine::ColliderBuilder::cuboid(half_extent, half_extent)
}

/// The engine's vector.
pub fn engine_vector(x: Scalar, y: Scalar) -> engine::Vector {
    engine::Vector::new(x, y)
}

/// A hinge.
pub fn hinge(body1: Entity, body2: Entity) -> Joint {
    Joint::revolute(body1, body2)
}

/// The axis of a hinge.
pub const HINGE: JointAxis = JointAxis::AngX;

/// Squared radius of gyration of a disc with radius 1.
pub const BALL_GYRATION: Scalar = 0.5;
