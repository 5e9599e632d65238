//! Thin shapes and thin grounds in 3D.

use crate::dim::grounds::Ground;
use rapier::parry::math::IVector;
use rapier::parry::utils::Array2;
use rapier::prelude::*;

fn v(x: Real, y: Real, z: Real) -> Vector {
    Vector::new(x, y, z)
}

/// Returns a plate that is oblique in its own frame, as a hull.
fn plate(half: Vector, angle: Vector) -> ColliderBuilder {
    let turn = Rotation::from_scaled_axis(angle);
    let signs = [-1.0, 1.0];
    let corners = signs.map(|x| signs.map(|y| signs.map(|z| turn * (half * v(x, y, z)))));
    ColliderBuilder::convex_hull(&corners.concat().concat()).unwrap()
}

/// Returns shapes of about 2 cm along their narrowest axis.
pub fn thin_shapes() -> Vec<(&'static str, ColliderBuilder)> {
    let askew = v(0.7, 0.3, 0.5);
    let wedge = [0.3, -0.3].map(|z| [v(0.5, 0.0, z), v(-0.5, 0.02, z), v(-0.5, -0.02, z)]);
    let disc = SharedShape::cylinder(0.01, 0.4);
    let upright = Rotation::from_scaled_axis(Vector::X * core::f64::consts::FRAC_PI_2 as Real);
    let upright = Pose::from_parts(v(0.0, 0.4, 0.0), upright);
    let hull = |points: &[Vector]| ColliderBuilder::convex_hull(points).unwrap();
    let sheet = vec![v(0.5, 0.0, 0.3), v(-0.5, 0.0, 0.3), v(-0.5, 0.0, -0.3), v(0.5, 0.0, -0.3)];
    vec![
        ("board", ColliderBuilder::cuboid(0.4, 0.01, 0.3)),
        ("disc", ColliderBuilder::cylinder(0.01, 0.4)),
        ("large disc", ColliderBuilder::cylinder(0.01, 1.0)),
        ("flat cone", ColliderBuilder::cone(0.01, 0.4)),
        ("large flat cone", ColliderBuilder::cone(0.01, 1.0)),
        ("plate askew", plate(v(1.0, 0.01, 1.0), askew)),
        ("strip askew", plate(v(1.0, 0.01, 0.05), askew)),
        ("wedge", hull(&wedge.concat())),
        ("capsule", ColliderBuilder::capsule_y(0.4, 0.01)),
        ("round disc", ColliderBuilder::round_cylinder(0.005, 0.4, 0.005)),
        ("round board", ColliderBuilder::round_cuboid(0.4, 0.005, 0.3, 0.005)),
        (
            "two discs",
            ColliderBuilder::compound(vec![(Pose::IDENTITY, disc.clone()), (upright, disc)]),
        ),
        ("sheet", ColliderBuilder::trimesh(sheet, vec![[0, 1, 2], [0, 2, 3]]).unwrap().mass(1.0)),
    ]
}

/// Grounds of minimum thickness, with their tops at y = 0, at least 10 m to all sides.
pub const THIN_GROUNDS: [Ground; 7] = [
    ("board", |world, _, _| {
        world.insert_collider(
            ColliderBuilder::cuboid(50.0, 0.01, 50.0).translation(v(0.0, -0.01, 0.0)),
            None,
        );
    }),
    ("two triangles", |world, _, _| {
        let corners = [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]]
            .map(|[x, z]| v(30.0 * x, 0.0, 30.0 * z));
        let triangles = vec![[0, 2, 1], [0, 3, 2]];
        world.insert_collider(ColliderBuilder::trimesh(corners.to_vec(), triangles).unwrap(), None);
    }),
    ("height field", |world, _, _| {
        let heights = Array2::new(41, 41, vec![0.0; 41 * 41]);
        world.insert_collider(ColliderBuilder::heightfield(heights, v(20.0, 1.0, 20.0)), None);
    }),
    ("half-space", |world, _, _| {
        world.insert_collider(ColliderBuilder::halfspace(Vector::Y), None);
    }),
    ("compound", |world, _, _| {
        let tile = SharedShape::cuboid(1.0, 0.01, 1.0);
        let places = (-5..5).flat_map(|i| (-5..5).map(move |k| (2 * i + 1, 2 * k + 1)));
        let tiles = places
            .map(|(i, k)| (Pose::from_translation(v(i as Real, -0.01, k as Real)), tile.clone()));
        world.insert_collider(ColliderBuilder::compound(tiles.collect()), None);
    }),
    ("hull", |world, _, _| {
        let hull = plate(v(10.0, 0.01, 10.0), Vector::ZERO);
        world.insert_collider(hull.translation(v(0.0, -0.01, 0.0)), None);
    }),
    ("voxels", |world, _, _| {
        let cells = (-50..50).flat_map(|i| (-50..50).map(move |k| IVector::new(i, -1, k)));
        let cells: Vec<_> = cells.collect();
        world.insert_collider(ColliderBuilder::voxels(v(0.2, 0.02, 0.2), &cells), None);
    }),
];

/// Returns a rotation by three random angles (rad).
pub fn random_turn([x, y, z]: [Real; 3]) -> AngVector {
    v(x, y, z)
}

/// Returns a sideways velocity.
pub fn sideways([x, z]: [Real; 2]) -> Vector {
    v(x, 0.0, z)
}
