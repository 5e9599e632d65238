//! The first parts of most scenes.

use crate::common::Dice;
pub(crate) use crate::common::{add, add_fixed};
use crate::rapier::prelude::*;
use std::f64::consts::PI;

/// Half a turn (rad).
pub(crate) const HALF_TURN: Real = PI as Real;

/// Returns a world with a level floor: a box with its top at y = 0, `half_extent` to each side, and deep
/// enough for pictures.
pub(crate) fn world_with_floor(half_extent: Real) -> PhysicsWorld {
    let mut world = PhysicsWorld::new();
    let floor = ColliderBuilder::cuboid(half_extent, half_extent);
    world.insert(RigidBodyBuilder::fixed().translation(-Vector::Y * half_extent), floor);
    world
}

/// Adds a fixed body as a suspension point: a small square that touches nothing.
pub(crate) fn add_post(world: &mut PhysicsWorld, place: Vector) -> RigidBodyHandle {
    add_fixed(world, place, square(0.15).collision_groups(InteractionGroups::none()))
}

/// Returns the point with these coordinates.
pub(crate) fn flat(x: Real, y: Real) -> Vector {
    Vector::new(x, y)
}

/// Returns zero: a 2D world has no depth.
pub(crate) fn near(_: Real) -> Vector {
    Vector::ZERO
}

/// Returns a rectangle with these half extents. The third one is unused in 2D.
pub(crate) fn brick(x: Real, y: Real, _: Real) -> SharedShape {
    SharedShape::cuboid(x, y)
}

/// Returns a hinge.
pub(crate) fn hinge() -> RevoluteJointBuilder {
    RevoluteJointBuilder::new()
}

/// Adds a wall on either side, `half_extent` from the y axis.
pub(crate) fn add_walls(world: &mut PhysicsWorld, half_extent: Real, height: Real) {
    let (half_height, thickness) = (0.5 * height, 0.25);
    for side in [-half_extent - thickness, half_extent + thickness] {
        let wall = ColliderBuilder::cuboid(thickness, half_height);
        add_fixed(world, Vector::new(side, half_height), wall);
    }
}

/// Returns evenly distributed directions over the circle, each as an angle (rad) and a unit vector.
pub(crate) fn directions(count: usize) -> impl Iterator<Item = (Real, Vector)> {
    (0..count).map(move |i| {
        let angle = 2.0 * HALF_TURN * i as Real / count as Real;
        (angle, Vector::new(angle.cos(), angle.sin()))
    })
}

/// Returns blocks in a circle, with this inner radius and this half thickness.
pub(crate) fn ring(
    radius: Real,
    pieces: usize,
    half_thickness: Real,
) -> impl Iterator<Item = ColliderBuilder> {
    let half_width = radius * (HALF_TURN / pieces as Real).tan();
    directions(pieces).map(move |(angle, outward)| {
        ColliderBuilder::cuboid(half_thickness, half_width + 0.1)
            .translation(outward * (radius + half_thickness))
            .rotation(angle)
    })
}

/// Returns a square with this half extent.
pub(crate) fn square(half_extent: Real) -> ColliderBuilder {
    ColliderBuilder::cuboid(half_extent, half_extent)
}

/// Returns the corners of an irregular stone: random points on a circle, no two of them close together.
pub(crate) fn stone(dice: &mut Dice, radius: Real, corners: usize) -> Vec<Vector> {
    let turn = 2.0 * HALF_TURN / corners as Real;
    (0..corners)
        .map(|i| {
            let angle = turn * (i as Real + dice.between(-0.35, 0.35));
            Vector::new(angle.cos(), angle.sin()) * radius
        })
        .collect()
}

/// Adds a pyramid of squares: `base` of them at the bottom, centred at `foot`.
pub(crate) fn add_pyramid(
    world: &mut PhysicsWorld,
    foot: Vector,
    base: usize,
    square_of: &ColliderBuilder,
    half: Real,
) {
    for row in 0..base {
        let count = base - row;
        for column in 0..count {
            let x = (2 * column) as Real - (count - 1) as Real;
            let y = (2 * row + 1) as Real;
            add(world, foot + Vector::new(x, y) * half, square_of.clone());
        }
    }
}
