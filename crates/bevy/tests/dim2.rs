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

/// A triangle with its slope from (1, 0) to (0, 1).
pub fn wedge() -> Collider {
    Collider::convex_hull(&[vector(0.0, 0.0), vector(1.0, 0.0), vector(0.0, 1.0)])
}

/// The slope of the wedge as a mesh.
pub fn mesh() -> Collider {
    let points = [vector(0.0, 0.0), vector(1.0, 0.0), vector(0.0, 1.0)];
    Collider::trimesh(&points, vec![[0, 1, 2]])
}

/// A shape of each constructor that has a mirrored form.
pub fn shapes() -> Vec<(&'static str, Collider)> {
    let [a, b, c] = [vector(0.0, 0.0), vector(1.0, 0.0), vector(0.0, 1.0)];
    vec![
        ("ball", Collider::ball(0.5)),
        ("cuboid", Collider::cuboid(0.5, 0.25)),
        ("round cuboid", Collider::round_cuboid(0.4, 0.4, 0.1)),
        ("capsule x", Collider::capsule_x(0.5, 0.25)),
        ("capsule y", Collider::capsule_y(0.5, 0.25)),
        ("tilted capsule", Collider::capsule_from_endpoints(a, vector(1.0, 0.5), 0.25)),
        ("segment", Collider::segment(a, vector(1.0, 0.5))),
        ("triangle", Collider::triangle(a, b, c)),
        ("polyline", Collider::polyline(&[a, b, c], None)),
        ("mesh", mesh()),
        ("hull", wedge()),
    ]
}
