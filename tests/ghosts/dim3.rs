//! Grounds of many pieces, with the plane y = 0 as their surface, in 3D.

use crate::suite::ghosts::lay::{self, add, on_a_body};
use rapier::parry::math::IVector;
use rapier::parry::utils::Array2;
use rapier::prelude::*;

/// Range of the grounds along x (m).
const ALONG: [Real; 2] = [-3.0, 45.0];
/// Range of the grounds to both sides (m).
const TO_THE_SIDE: Real = 4.0;

/// Name of a ground, and the function that adds it to a world at a pose with this friction.
pub type Ground = (&'static str, fn(&mut PhysicsWorld, Pose, Real));

/// All grounds.
pub const GROUNDS: [Ground; 11] = [
    ("mesh", |world, pose, friction| add(world, pose, friction, mesh(1.0))),
    ("fine mesh", |world, pose, friction| add(world, pose, friction, mesh(0.23))),
    ("height field", |world, pose, friction| add(world, pose, friction, height_field())),
    ("compound", |world, pose, friction| add(world, pose, friction, compound())),
    ("voxels", |world, pose, friction| add(world, pose, friction, voxels())),
    ("colliders on a body", colliders_on_a_body),
    ("colliders", |world, pose, friction| scatter(world, pose, friction, tile(), false)),
    ("bodies", |world, pose, friction| scatter(world, pose, friction, tile(), true)),
    ("hulls", |world, pose, friction| scatter(world, pose, friction, hull(), false)),
    ("closed meshes", |world, pose, friction| scatter(world, pose, friction, closed_mesh(), true)),
    ("flat meshes", |world, pose, friction| scatter(world, pose, friction, square(), true)),
];

/// Returns whether the ground is below a place.
pub fn is_over_ground(place: Vector) -> bool {
    (ALONG[0]..ALONG[1]).contains(&place.x) && place.z.abs() < TO_THE_SIDE
}

fn mesh(size: Real) -> ColliderBuilder {
    let count = |length: Real| (length / size).ceil() as u32;
    let (columns, rows) = (count(ALONG[1] - ALONG[0]), count(2.0 * TO_THE_SIDE));
    let place = |i: u32, j: u32| {
        Vector::new(ALONG[0] + size * i as Real, 0.0, size * j as Real - TO_THE_SIDE)
    };
    let vertices = (0..=columns).flat_map(|i| (0..=rows).map(move |j| place(i, j))).collect();
    let at = |i: u32, j: u32| i * (rows + 1) + j;
    let square = |i: u32, j: u32| {
        let (a, b, c, d) = (at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j));
        [[a, b, c], [a, c, d]]
    };
    let triangles = (0..columns).flat_map(|i| (0..rows).flat_map(move |j| square(i, j))).collect();
    ColliderBuilder::trimesh(vertices, triangles).unwrap()
}

fn height_field() -> ColliderBuilder {
    // The middle of a height field is the origin.
    let reach = ALONG[1].max(-ALONG[0]);
    let (rows, columns) = ((2.0 * TO_THE_SIDE) as usize + 1, (2.0 * reach) as usize + 1);
    let heights = Array2::new(rows, columns, vec![0.0; rows * columns]);
    ColliderBuilder::heightfield(heights, Vector::new(2.0 * reach, 1.0, 2.0 * TO_THE_SIDE))
}

fn tile() -> ColliderBuilder {
    ColliderBuilder::cuboid(0.5, 0.5, 0.5)
}

fn corners() -> Vec<Vector> {
    let signs = [-0.5, 0.5];
    let corner = |x| signs.map(|y| signs.map(|z| Vector::new(x, y, z)));
    signs.into_iter().flat_map(|x| corner(x).into_iter().flatten().collect::<Vec<_>>()).collect()
}

fn hull() -> ColliderBuilder {
    ColliderBuilder::convex_hull(&corners()).unwrap()
}

/// Corner 4 x + 2 y + z; each face as two triangles, counter-clockwise from outside.
fn box_triangles() -> Vec<[u32; 3]> {
    let faces: [[u32; 4]; 6] =
        [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]];
    faces.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect()
}

fn closed_mesh() -> ColliderBuilder {
    ColliderBuilder::trimesh(corners(), box_triangles()).unwrap()
}

fn square() -> ColliderBuilder {
    let corner = |x: Real, z: Real| Vector::new(x, 0.5, z);
    let vertices = vec![corner(-0.5, -0.5), corner(-0.5, 0.5), corner(0.5, 0.5), corner(0.5, -0.5)];
    ColliderBuilder::trimesh(vertices, vec![[0, 1, 2], [0, 2, 3]]).unwrap()
}

/// Returns the middles of the tiles.
fn places() -> impl Iterator<Item = Vector> {
    let columns = ALONG[0] as i32..ALONG[1] as i32;
    let rows = -TO_THE_SIDE as i32..TO_THE_SIDE as i32;
    let place = |i: i32, j: i32| Vector::new(i as Real + 0.5, -0.5, j as Real + 0.5);
    columns.flat_map(move |i| rows.clone().map(move |j| place(i, j)))
}

fn compound() -> ColliderBuilder {
    let part = |place| (Pose::from_translation(place), SharedShape::cuboid(0.5, 0.5, 0.5));
    ColliderBuilder::compound(places().map(part).collect())
}

fn voxels() -> ColliderBuilder {
    let cell = |place: Vector| {
        let [x, y, z] = place.to_array().map(|coordinate| coordinate.floor() as _);
        IVector::new(x, y, z)
    };
    ColliderBuilder::voxels(Vector::ONE, &places().map(cell).collect::<Vec<_>>())
}

fn colliders_on_a_body(world: &mut PhysicsWorld, pose: Pose, friction: Real) {
    on_a_body(world, pose, friction, &tile(), places());
}

/// Adds each tile as a separate collider, each on a separate body if `with_bodies`.
fn scatter(
    world: &mut PhysicsWorld,
    pose: Pose,
    friction: Real,
    tile: ColliderBuilder,
    with_bodies: bool,
) {
    lay::scatter(world, pose, &tile.friction(friction), places(), with_bodies);
}

/// Returns sliding bodies: name, height of the middle above the ground, pose, and collider.
pub fn sliders() -> Vec<(&'static str, Real, Pose, ColliderBuilder)> {
    let turned = |angle| Pose::from_rotation(Rotation::from_rotation_y(angle));
    let straight = Pose::IDENTITY;
    let lying =
        Pose::from_rotation(Rotation::from_rotation_x(core::f64::consts::FRAC_PI_2 as Real));
    let six: Vec<_> = (0..6)
        .flat_map(|k| {
            let (sin, cos) = (core::f64::consts::FRAC_PI_3 as Real * k as Real).sin_cos();
            [-0.5, 0.5].map(|y| Vector::new(0.5 * cos, y, 0.5 * sin))
        })
        .collect();
    let slab = ColliderBuilder::cuboid(0.5, 0.1, 0.5);
    vec![
        ("box", 0.5, straight, ColliderBuilder::cuboid(0.5, 0.5, 0.5)),
        ("turned box", 0.5, turned(0.4), ColliderBuilder::cuboid(0.5, 0.5, 0.5)),
        ("slab", 0.1, straight, slab),
        ("ball", 0.5, straight, ColliderBuilder::ball(0.5)),
        ("small ball", 0.1, straight, ColliderBuilder::ball(0.1)),
        ("upright capsule", 0.5, straight, ColliderBuilder::capsule_y(0.2, 0.3)),
        ("lying capsule", 0.3, lying, ColliderBuilder::capsule_y(0.3, 0.3)),
        ("cylinder", 0.5, straight, ColliderBuilder::cylinder(0.5, 0.5)),
        ("hull", 0.5, turned(0.2), ColliderBuilder::convex_hull(&six).unwrap()),
        ("round box", 0.5, straight, ColliderBuilder::round_cuboid(0.4, 0.4, 0.4, 0.1)),
        ("small round box", 0.06, straight, ColliderBuilder::round_cuboid(0.08, 0.04, 0.08, 0.02)),
        ("compound", 0.3, straight, sledge()),
    ]
}

/// Returns two boxes side by side, as parts of a compound.
fn sledge() -> ColliderBuilder {
    let half = SharedShape::cuboid(0.5, 0.3, 0.2);
    let at = |z: Real| (Pose::from_translation(Vector::new(0.0, 0.0, z)), half.clone());
    ColliderBuilder::compound(vec![at(-0.3), at(0.3)])
}

/// Sideways displacement, away from internal edges.
pub const ASIDE: Vector = Vector::new(0.0, 0.0, 0.27);

/// Adds a V-shaped ground along z with this slope on both sides of x = 0, in strips of 0.25 m.
pub fn gutter(world: &mut PhysicsWorld, slope: Real) {
    let vertex = |i: i32, z: Real| {
        let x = 0.25 * (i - 20) as Real;
        Vector::new(x, slope * x.abs(), z)
    };
    let vertices = (0..=40).flat_map(|i| [vertex(i, -TO_THE_SIDE), vertex(i, TO_THE_SIDE)]);
    let strip = |i: u32| [[2 * i, 2 * i + 1, 2 * i + 3], [2 * i, 2 * i + 3, 2 * i + 2]];
    let ground = ColliderBuilder::trimesh(vertices.collect(), (0..40).flat_map(strip).collect());
    world.insert_collider(ground.unwrap().friction(0.0), None);
}

/// Returns a closed box of triangles, as deep as it is wide.
pub fn box_mesh(half: Vector) -> ColliderBuilder {
    let corners = corners().into_iter().map(|c| c * 2.0 * Vector::new(half.x, half.y, 5.0));
    ColliderBuilder::trimesh(corners.collect(), box_triangles()).unwrap()
}
