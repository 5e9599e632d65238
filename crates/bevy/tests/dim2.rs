//! Shapes and vectors of two dimensions.

use crate::plugin::prelude::*;
use crate::plugin::rapier::prelude as engine;
use bevy::prelude::Entity;

/// A vector.
pub fn vector(x: Real, y: Real) -> Vector {
    Vector::new(x, y)
}

/// A rotation.
pub fn rotation(angle: Real) -> AngVector {
    angle
}

/// The angle.
pub fn angle(rotation: AngVector) -> Real {
    rotation
}

/// A cube or a square.
pub fn cube(half_extent: Real) -> Collider {
    Collider::cuboid(half_extent, half_extent)
}

/// A floor of thickness 2.
pub fn floor() -> Collider {
    Collider::cuboid(20.0, 1.0)
}

/// The engine's description of a square.
pub fn engine_cube(half_extent: Real) -> engine::ColliderBuilder {
    engine::ColliderBuilder::cuboid(half_extent, half_extent)
}

/// The engine's vector.
pub fn engine_vector(x: Real, y: Real) -> engine::Vector {
    engine::Vector::new(x, y)
}

/// A hinge.
pub fn hinge(body1: Entity, body2: Entity) -> Joint {
    Joint::revolute(body1, body2)
}

/// The axis of a hinge.
pub const HINGE: JointAxis = JointAxis::AngX;

/// Squared radius of gyration of a disc with radius 1.
pub const BALL_GYRATION: Real = 0.5;
