//! Thin shapes, thin floors and rotations in 3D.

use super::both::values::within;
use super::rapier::parry::math::IVector;
use super::rapier::parry::utils::Array2;
use super::rapier::prelude::*;
use crate::choices::Choices;

/// Half the width of the shapes along their narrowest axis, and of the floors (m).
const HALF_THICKNESS: Real = 0.01;
/// Half the length of a tile and a voxel of a floor (m).
const TILE: Real = 1.0;
const CELL: Real = 0.2;

/// Returns a rotation vector or angular velocity with components of up to `size`.
pub fn turn(choices: &mut Choices<'_>, size: f64) -> AngVector {
    AngVector::from_array([(); 3].map(|()| within(choices, -size, size)))
}

/// Returns a shape that is thin along at least one axis.
pub fn thin_shape(choices: &mut Choices<'_>) -> ColliderBuilder {
    let (wide, long) = (within(choices, 0.1, 1.0), within(choices, 0.05, 1.0));
    let disc = SharedShape::cylinder(HALF_THICKNESS, wide);
    match choices.below(8) {
        0 => ColliderBuilder::cuboid(wide, HALF_THICKNESS, long),
        1 => ColliderBuilder::cylinder(HALF_THICKNESS, wide),
        2 => ColliderBuilder::cone(2.0 * HALF_THICKNESS, wide),
        3 => plate([wide, HALF_THICKNESS, long].into(), turn(choices, 1.5)),
        4 => ColliderBuilder::round_cylinder(0.5 * HALF_THICKNESS, wide, 0.5 * HALF_THICKNESS),
        5 => ColliderBuilder::round_cuboid(wide, 0.5 * HALF_THICKNESS, long, 0.5 * HALF_THICKNESS),
        6 => {
            let upright = Rotation::from_scaled_axis(turn(choices, 1.5));
            let upright = Pose::from_parts(Vector::Y * wide, upright);
            ColliderBuilder::compound(vec![(Pose::IDENTITY, disc.clone()), (upright, disc)])
        }
        _ => ColliderBuilder::capsule_y(wide, 2.0 * HALF_THICKNESS),
    }
}

/// Returns a hull that is oblique in its own frame.
fn plate(half: Vector, angle: AngVector) -> ColliderBuilder {
    let (turn, signs) = (Rotation::from_scaled_axis(angle), [-1.0, 1.0]);
    let corner = |x: Real, y: Real, z: Real| turn * (half * Vector::new(x, y, z));
    let corners = signs.map(|x| signs.map(|y| signs.map(|z| corner(x, y, z))));
    ColliderBuilder::convex_hull(&corners.concat().concat())
        .unwrap_or(ColliderBuilder::cuboid(half.x, half.y, half.z))
}

/// Adds a floor with its top at y = 0, from -`half` to `half`.
pub fn lay_floor(world: &mut PhysicsWorld, half: Real, choices: &mut Choices<'_>) {
    let size = Vector::new(2.0 * half, 1.0, 2.0 * half);
    let floor = match choices.below(8) {
        0 => board(half),
        1 => sheet(half, 1),
        2 => sheet(half, 12),
        3 => ColliderBuilder::heightfield(Array2::new(13, 13, vec![0.0; 13 * 13]), size),
        4 => ColliderBuilder::halfspace(Vector::Y),
        5 => tiles(half),
        6 => plate(Vector::new(half, HALF_THICKNESS, half), Vector::ZERO)
            .translation(Vector::Y * -HALF_THICKNESS),
        _ => cells(half),
    };
    choices.print(|| format!("a floor: {:?}", floor.shape.shape_type()));
    world.insert_collider(floor, None);
}

fn board(half: Real) -> ColliderBuilder {
    ColliderBuilder::cuboid(half, HALF_THICKNESS, half).translation(Vector::Y * -HALF_THICKNESS)
}

/// A flat mesh of `count` × `count` squares.
fn sheet(half: Real, count: u32) -> ColliderBuilder {
    let place = |k: u32| half * (2.0 * k as Real / count as Real - 1.0);
    let vertices = (0..=count)
        .flat_map(|i| (0..=count).map(move |k| Vector::new(place(i), 0.0, place(k))))
        .collect();
    let squares = (0..count).flat_map(|i| (0..count).map(move |k| i * (count + 1) + k));
    let next = count + 1;
    let triangles = squares.flat_map(|a| [[a, a + 1, a + next + 1], [a, a + next + 1, a + next]]);
    ColliderBuilder::trimesh(vertices, triangles.collect()).unwrap_or_else(|_| board(half))
}

fn tiles(half: Real) -> ColliderBuilder {
    let tile = SharedShape::cuboid(TILE, HALF_THICKNESS, TILE);
    let count = (half / TILE) as i32;
    let place = move |k: i32| TILE * (2 * k + 1 - count) as Real;
    let places = (0..count)
        .flat_map(|i| (0..count).map(move |k| Vector::new(place(i), -HALF_THICKNESS, place(k))));
    let tiles = places.map(|at| (Pose::from_translation(at), tile.clone()));
    ColliderBuilder::compound(tiles.collect())
}

fn cells(half: Real) -> ColliderBuilder {
    let count = (half / CELL) as Int;
    let cells = (-count..count).flat_map(|i| (-count..count).map(move |k| IVector::new(i, -1, k)));
    let size = Vector::new(CELL, 2.0 * HALF_THICKNESS, CELL);
    ColliderBuilder::voxels(size, &cells.collect::<Vec<_>>())
}
