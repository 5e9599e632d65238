//! Thin shapes, thin floors and rotations in 2D.

use super::both::values::within;
use super::rapier::parry::math::IVector;
use super::rapier::prelude::*;
use crate::choices::Choices;

/// Half the width of the shapes along their narrowest axis, and of the floors (m).
const HALF_THICKNESS: Real = 0.01;
/// Half the length of a tile and a voxel of a floor (m).
const TILE: Real = 1.0;
const CELL: Real = 0.2;

/// Returns an angle or angular velocity of up to `size`.
pub fn turn(choices: &mut Choices<'_>, size: f64) -> AngVector {
    within(choices, -size, size)
}

/// Returns a shape that is thin along one axis, and about equally wide along all others.
pub fn thin_shape(choices: &mut Choices<'_>) -> ColliderBuilder {
    let wide = within(choices, 0.1, 1.0);
    let board = SharedShape::cuboid(wide, HALF_THICKNESS);
    match choices.below(5) {
        0 => ColliderBuilder::cuboid(wide, HALF_THICKNESS),
        1 => plate(Vector::new(wide, HALF_THICKNESS), turn(choices, 1.5)),
        2 => ColliderBuilder::round_cuboid(wide, 0.5 * HALF_THICKNESS, 0.5 * HALF_THICKNESS),
        3 => {
            let upright = Pose::from_parts(Vector::Y * wide, Rotation::new(turn(choices, 1.5)));
            ColliderBuilder::compound(vec![(Pose::IDENTITY, board.clone()), (upright, board)])
        }
        _ => ColliderBuilder::capsule_y(wide, 2.0 * HALF_THICKNESS),
    }
}

/// Returns a hull that is oblique in its own frame.
fn plate(half: Vector, angle: AngVector) -> ColliderBuilder {
    let turn = Rotation::new(angle);
    let signs = [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]];
    let corners = signs.map(|signs| turn * (half * Vector::from_array(signs)));
    ColliderBuilder::convex_hull(&corners).unwrap_or(ColliderBuilder::cuboid(half.x, half.y))
}

/// Adds a floor with its top at y = 0, from -`half` to `half`.
pub fn lay_floor(world: &mut PhysicsWorld, half: Real, choices: &mut Choices<'_>) {
    let size = Vector::new(2.0 * half, 1.0);
    let floor = match choices.below(8) {
        0 => board(half),
        1 => ColliderBuilder::segment(Vector::X * -half, Vector::X * half),
        2 => polyline(half, 12),
        3 => ColliderBuilder::heightfield(vec![0.0; 13], size),
        4 => ColliderBuilder::halfspace(Vector::Y),
        5 => tiles(half),
        6 => plate(Vector::new(half, HALF_THICKNESS), 0.0).translation(Vector::Y * -HALF_THICKNESS),
        _ => cells(half),
    };
    choices.print(|| format!("a floor: {:?}", floor.shape.shape_type()));
    world.insert_collider(floor, None);
}

fn board(half: Real) -> ColliderBuilder {
    ColliderBuilder::cuboid(half, HALF_THICKNESS).translation(Vector::Y * -HALF_THICKNESS)
}

fn polyline(half: Real, count: u32) -> ColliderBuilder {
    let place = |k: u32| half * (2.0 * k as Real / count as Real - 1.0);
    let vertices = (0..=count).map(|k| Vector::X * place(k)).collect();
    ColliderBuilder::polyline(vertices, None)
}

fn tiles(half: Real) -> ColliderBuilder {
    let tile = SharedShape::cuboid(TILE, HALF_THICKNESS);
    let count = (half / TILE) as i32;
    let place = |k: i32| Vector::new(TILE * (2 * k + 1 - count) as Real, -HALF_THICKNESS);
    let tiles = (0..count).map(|k| (Pose::from_translation(place(k)), tile.clone()));
    ColliderBuilder::compound(tiles.collect())
}

fn cells(half: Real) -> ColliderBuilder {
    let count = (half / CELL) as Int;
    let cells: Vec<_> = (-count..count).map(|k| IVector::new(k, -1)).collect();
    ColliderBuilder::voxels(Vector::new(CELL, 2.0 * HALF_THICKNESS), &cells)
}
