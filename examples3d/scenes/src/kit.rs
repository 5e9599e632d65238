//! The first parts of most scenes.

use crate::common::Dice;
pub(crate) use crate::common::{add, add_fixed};
use crate::rapier::prelude::*;
use std::f64::consts::PI;

/// Half a turn (rad).
pub(crate) const HALF_TURN: Real = PI as Real;

/// Returns a world with a level floor: a box with its top at y = 0, `half_extent` to each side.
pub(crate) fn world_with_floor(half_extent: Real) -> PhysicsWorld {
    let mut world = PhysicsWorld::new();
    let floor = ColliderBuilder::cuboid(half_extent, 1.0, half_extent);
    world.insert(RigidBodyBuilder::fixed().translation(-Vector::Y), floor);
    world
}

/// Returns the height of smooth hills at a point. `high` is the height of the wide ones.
pub(crate) fn hills(high: Real, x: Real, z: Real) -> Real {
    high * (0.31 * x).sin() * (0.23 * z).cos() + 0.3 * (0.9 * x + 0.4 * z).sin()
}

/// Returns a mesh over a square in the middle of the world, with heights at its vertices. Each side has a
/// number of smaller squares of two triangles each.
pub(crate) fn surface(
    squares: u32,
    size: Real,
    height: impl Fn(Real, Real) -> Real,
) -> ColliderBuilder {
    let at = |i: u32, j: u32| i * (squares + 1) + j;
    let middle = 0.5 * size * squares as Real;
    let vertex = |i: u32, j: u32| {
        let [x, z] = [i, j].map(|n| size * n as Real - middle);
        Vector::new(x, height(x, z), z)
    };
    let corners = (0..=squares).flat_map(|i| (0..=squares).map(move |j| (i, j)));
    let vertices = corners.map(|(i, j)| vertex(i, j)).collect();
    let square = |i: u32, j: u32| {
        let [a, b, c, d] = [at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)];
        [[a, b, c], [a, c, d]]
    };
    let places = (0..squares).flat_map(|i| (0..squares).map(move |j| (i, j)));
    let triangles = places.flat_map(|(i, j)| square(i, j)).collect();
    ColliderBuilder::trimesh(vertices, triangles).expect("there are squares")
}

/// Adds a fixed body as a suspension point: a small cube that touches nothing.
pub(crate) fn add_post(world: &mut PhysicsWorld, place: Vector) -> RigidBodyHandle {
    add_fixed(world, place, cube(0.15).collision_groups(InteractionGroups::none()))
}

/// Returns a rotation by an angle (rad) in the plane of the picture.
pub(crate) fn turn(angle: Real) -> AngVector {
    Vector::Z * angle
}

/// Returns the point in the plane of the picture with these coordinates.
pub(crate) fn flat(x: Real, y: Real) -> Vector {
    Vector::new(x, y, 0.0)
}

/// Returns the vector of this length towards the eye (away from it if negative).
pub(crate) fn near(z: Real) -> Vector {
    Vector::Z * z
}

/// Returns a box with these half extents.
pub(crate) fn brick(x: Real, y: Real, z: Real) -> SharedShape {
    SharedShape::cuboid(x, y, z)
}

/// Returns a hinge about the axis out of the picture.
pub(crate) fn hinge() -> RevoluteJointBuilder {
    RevoluteJointBuilder::new(Vector::Z)
}

/// Adds four walls around a square, `half_extent` from the y axis.
pub(crate) fn add_walls(world: &mut PhysicsWorld, half_extent: Real, height: Real) {
    let (half_height, thickness) = (0.5 * height, 0.25);
    let offset = half_extent + thickness;
    for side in [-offset, offset] {
        let across = ColliderBuilder::cuboid(thickness, half_height, offset + thickness);
        add_fixed(world, Vector::new(side, half_height, 0.0), across);
        let along = ColliderBuilder::cuboid(offset + thickness, half_height, thickness);
        add_fixed(world, Vector::new(0.0, half_height, side), along);
    }
}

/// Returns a cube with this half extent.
pub(crate) fn cube(half_extent: Real) -> ColliderBuilder {
    ColliderBuilder::cuboid(half_extent, half_extent, half_extent)
}

/// Returns the corners of an irregular rock: random points on a sphere.
pub(crate) fn rock(dice: &mut Dice, radius: Real, corners: usize) -> Vec<Vector> {
    (0..corners)
        .map(|_| {
            let mut number = || dice.between(-1.0, 1.0);
            Vector::new(number(), number(), number()).normalize_or(Vector::Y) * radius
        })
        .collect()
}

/// Adds a pyramid of cubes, one cube thick: `base` cubes at the bottom, centred at `foot`.
pub(crate) fn add_pyramid(
    world: &mut PhysicsWorld,
    foot: Vector,
    base: usize,
    cube_of: &ColliderBuilder,
    half: Real,
) {
    for row in 0..base {
        let count = base - row;
        for column in 0..count {
            let x = (2 * column) as Real - (count - 1) as Real;
            let y = (2 * row + 1) as Real;
            add(world, foot + Vector::new(x, y, 0.0) * half, cube_of.clone());
        }
    }
}
