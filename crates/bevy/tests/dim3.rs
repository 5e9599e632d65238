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

/// The corners of a prism along z whose slope leads from (1, 0) to (0, 1).
fn wedge_points() -> Vec<Vector> {
    let corner = |[x, y, z]: [Scalar; 3]| Vector::new(x, y, z);
    let near = [[0.0, 0.0, -1.0], [1.0, 0.0, -1.0], [0.0, 1.0, -1.0]].map(corner);
    let far = [[0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [0.0, 1.0, 1.0]].map(corner);
    [near, far].concat()
}

/// The prism.
pub fn wedge() -> Collider {
    Collider::convex_hull(&wedge_points())
}

/// The slope of the wedge as a mesh.
pub fn mesh() -> Collider {
    Collider::trimesh(&wedge_points(), vec![[1, 2, 5], [1, 5, 4]])
}

/// A shape of each constructor that has a mirrored form.
pub fn shapes() -> Vec<(&'static str, Collider)> {
    let [a, b, c] = [vector(0.0, 0.0), vector(1.0, 0.0), vector(0.0, 1.0)];
    vec![
        ("ball", Collider::ball(0.5)),
        ("cuboid", Collider::cuboid(0.5, 0.25, 0.25)),
        ("round cuboid", Collider::round_cuboid(0.4, 0.4, 0.4, 0.1)),
        ("capsule x", Collider::capsule_x(0.5, 0.25)),
        ("capsule y", Collider::capsule_y(0.5, 0.25)),
        ("capsule z", Collider::capsule_z(0.5, 0.25)),
        ("tilted capsule", Collider::capsule_from_endpoints(a, vector(1.0, 0.5), 0.25)),
        ("cylinder", Collider::cylinder(0.5, 0.25)),
        ("cone", Collider::cone(0.5, 0.25)),
        ("segment", Collider::segment(a, vector(1.0, 0.5))),
        ("triangle", Collider::triangle(a, b, c)),
        ("polyline", Collider::polyline(&[a, b, c], None)),
        ("mesh", mesh()),
        ("hull", wedge()),
    ]
}
