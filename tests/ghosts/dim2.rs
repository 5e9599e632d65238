//! Grounds of many pieces, with the line y = 0 as their surface, in 2D.

use crate::suite::ghosts::lay::{self, add, on_a_body};
use rapier::parry::math::IVector;
use rapier::prelude::*;

/// Range of the grounds along x (m).
const ALONG: [Real; 2] = [-3.0, 45.0];

/// Name of a ground, and the function that adds it to a world at a pose with this friction.
pub type Ground = (&'static str, fn(&mut PhysicsWorld, Pose, Real));

/// All grounds.
pub const GROUNDS: [Ground; 10] = [
    ("polyline", |world, pose, friction| add(world, pose, friction, polyline(1.0))),
    ("fine polyline", |world, pose, friction| add(world, pose, friction, polyline(0.11))),
    ("height field", |world, pose, friction| add(world, pose, friction, height_field())),
    ("compound", |world, pose, friction| add(world, pose, friction, compound())),
    ("voxels", |world, pose, friction| add(world, pose, friction, voxels())),
    ("colliders on a body", colliders_on_a_body),
    ("colliders", |world, pose, friction| scatter(world, pose, friction, tile(), false)),
    ("bodies", |world, pose, friction| scatter(world, pose, friction, tile(), true)),
    ("hulls", |world, pose, friction| scatter(world, pose, friction, hull(), false)),
    ("segments", |world, pose, friction| scatter(world, pose, friction, segment(), true)),
];

/// Returns whether the ground is below a place.
pub fn is_over_ground(place: Vector) -> bool {
    (ALONG[0]..ALONG[1]).contains(&place.x)
}

fn polyline(size: Real) -> ColliderBuilder {
    let count = ((ALONG[1] - ALONG[0]) / size).ceil() as usize;
    let vertices = (0..=count).map(|i| Vector::new(ALONG[0] + size * i as Real, 0.0)).collect();
    ColliderBuilder::polyline(vertices, None)
}

fn height_field() -> ColliderBuilder {
    // The middle of a height field is the origin.
    let reach = ALONG[1].max(-ALONG[0]);
    let heights = vec![0.0; (2.0 * reach) as usize + 1];
    ColliderBuilder::heightfield(heights, Vector::new(2.0 * reach, 1.0))
}

fn tile() -> ColliderBuilder {
    ColliderBuilder::cuboid(0.5, 0.5)
}

fn hull() -> ColliderBuilder {
    let corners = [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]].map(Vector::from_array);
    ColliderBuilder::convex_hull(&corners).unwrap()
}

fn segment() -> ColliderBuilder {
    ColliderBuilder::segment(Vector::new(-0.5, 0.5), Vector::new(0.5, 0.5))
}

/// Returns the middles of the tiles.
fn places() -> impl Iterator<Item = Vector> {
    (ALONG[0] as i32..ALONG[1] as i32).map(|i| Vector::new(i as Real + 0.5, -0.5))
}

fn compound() -> ColliderBuilder {
    let part = |place| (Pose::from_translation(place), SharedShape::cuboid(0.5, 0.5));
    ColliderBuilder::compound(places().map(part).collect())
}

fn voxels() -> ColliderBuilder {
    let cell = |place: Vector| {
        let [x, y] = place.to_array().map(|coordinate| coordinate.floor() as _);
        IVector::new(x, y)
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
    let straight = Pose::IDENTITY;
    let lying = Pose::from_rotation(Rotation::new(core::f64::consts::FRAC_PI_2 as Real));
    let wedge = [[-0.5, -0.25], [0.5, -0.25], [0.2, 0.25], [-0.3, 0.25]].map(Vector::from_array);
    vec![
        ("box", 0.5, straight, ColliderBuilder::cuboid(0.5, 0.5)),
        ("slab", 0.1, straight, ColliderBuilder::cuboid(0.5, 0.1)),
        ("ball", 0.5, straight, ColliderBuilder::ball(0.5)),
        ("small ball", 0.1, straight, ColliderBuilder::ball(0.1)),
        ("upright capsule", 0.5, straight, ColliderBuilder::capsule_y(0.2, 0.3)),
        ("lying capsule", 0.3, lying, ColliderBuilder::capsule_y(0.3, 0.3)),
        ("hull", 0.25, straight, ColliderBuilder::convex_hull(&wedge).unwrap()),
        ("round box", 0.5, straight, ColliderBuilder::round_cuboid(0.4, 0.4, 0.1)),
        ("compound", 0.3, straight, sledge()),
    ]
}

/// Returns two boxes, one behind the other, as parts of a compound.
fn sledge() -> ColliderBuilder {
    let half = SharedShape::cuboid(0.2, 0.3);
    let at = |x: Real| (Pose::from_translation(Vector::new(x, 0.0)), half.clone());
    ColliderBuilder::compound(vec![at(-0.3), at(0.3)])
}

/// Sideways displacement: none in 2D.
pub const ASIDE: Vector = Vector::ZERO;

/// Adds a V-shaped ground with this slope on both sides of x = 0, in pieces of 0.25 m.
pub fn gutter(world: &mut PhysicsWorld, slope: Real) {
    let vertex = |i: i32| {
        let x = 0.25 * (i - 20) as Real;
        Vector::new(x, slope * x.abs())
    };
    let ground = ColliderBuilder::polyline((0..=40).map(vertex).collect(), None);
    world.insert_collider(ground.friction(0.0), None);
}

/// Returns a closed box of segments.
pub fn box_mesh(half: Vector) -> ColliderBuilder {
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0]];
    let corners = corners.map(|corner| Vector::from_array(corner) * half);
    ColliderBuilder::polyline(corners.to_vec(), None)
}
