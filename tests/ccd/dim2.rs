//! Thin shapes and thin grounds in 2D.

use crate::dim::grounds::Ground;
use rapier::parry::math::IVector;
use rapier::prelude::*;

fn v(x: Real, y: Real) -> Vector {
    Vector::new(x, y)
}

fn plate(half: Vector, angle: Real) -> ColliderBuilder {
    let turn = Rotation::new(angle);
    let corners =
        [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]].map(|[x, y]| turn * (half * v(x, y)));
    ColliderBuilder::convex_hull(&corners).unwrap()
}

/// Returns shapes of about 2 cm along their narrowest axis.
pub fn thin_shapes() -> Vec<(&'static str, ColliderBuilder)> {
    let quarter = core::f64::consts::FRAC_PI_4 as Real;
    let board = SharedShape::cuboid(0.4, 0.01);
    let upright = Pose::from_parts(v(0.0, 0.4), Rotation::new(2.0 * quarter));
    vec![
        ("board", ColliderBuilder::cuboid(0.4, 0.01)),
        ("plate at 45°", plate(v(1.0, 0.01), quarter)),
        ("plate askew", plate(v(0.4, 0.01), 0.4)),
        (
            "wedge",
            ColliderBuilder::convex_hull(&[v(0.5, 0.5), v(-0.5, -0.48), v(-0.48, -0.5)]).unwrap(),
        ),
        ("triangle", ColliderBuilder::triangle(v(-0.5, 0.0), v(0.5, 0.0), v(0.1, 0.03))),
        ("triangle askew", ColliderBuilder::triangle(v(-0.4, -0.4), v(0.4, 0.4), v(-0.02, 0.02))),
        (
            "round triangle",
            ColliderBuilder::round_triangle(v(-0.4, -0.4), v(0.4, 0.4), v(0.0, 0.01), 0.005),
        ),
        ("capsule", ColliderBuilder::capsule_y(0.4, 0.01)),
        ("round board", ColliderBuilder::round_cuboid(0.4, 0.005, 0.005)),
        (
            "two boards",
            ColliderBuilder::compound(vec![(Pose::IDENTITY, board.clone()), (upright, board)]),
        ),
        ("segment", ColliderBuilder::segment(v(-0.4, -0.05), v(0.4, 0.05)).mass(1.0)),
    ]
}

/// Grounds of minimum thickness, with their tops at y = 0, at least 10 m to both sides.
pub const THIN_GROUNDS: [Ground; 7] = [
    ("board", |world, _, _| {
        world.insert_collider(ColliderBuilder::cuboid(50.0, 0.01).translation(v(0.0, -0.01)), None);
    }),
    ("segment", |world, _, _| {
        world.insert_collider(ColliderBuilder::segment(v(-30.0, 0.0), v(30.0, 0.0)), None);
    }),
    ("height field", |world, _, _| {
        world.insert_collider(ColliderBuilder::heightfield(vec![0.0; 41], v(20.0, 1.0)), None);
    }),
    ("half-space", |world, _, _| {
        world.insert_collider(ColliderBuilder::halfspace(Vector::Y), None);
    }),
    ("compound", |world, _, _| {
        let tile = SharedShape::cuboid(1.0, 0.01);
        let tiles =
            (-5..5).map(|i| (Pose::from_translation(v((2 * i + 1) as Real, -0.01)), tile.clone()));
        world.insert_collider(ColliderBuilder::compound(tiles.collect()), None);
    }),
    ("hull", |world, _, _| {
        world.insert_collider(plate(v(10.0, 0.01), 0.0).translation(v(0.0, -0.01)), None);
    }),
    ("voxels", |world, _, _| {
        let cells: Vec<_> = (-50..50).map(|i| IVector::new(i, -1)).collect();
        world.insert_collider(ColliderBuilder::voxels(v(0.2, 0.02), &cells), None);
    }),
];

/// Returns a rotation by a random angle (rad).
pub fn random_turn([x, ..]: [Real; 3]) -> AngVector {
    x
}

/// Returns a sideways velocity.
pub fn sideways([x, _]: [Real; 2]) -> Vector {
    v(x, 0.0)
}
