//! Closed room: thick walls, a ceiling, and a floor of any kind.

use super::rapier::parry::shape::Cuboid;
use super::rapier::prelude::*;
use super::thin::lay_floor;
use crate::choices::Choices;

/// Half the width of the room, and its height (m). The floor is 400 times as wide as the thinnest body is
/// thick. The guide excludes bodies a thousand times smaller than their ground.
pub const SIZE: Real = 4.0;
/// Half the thickness of the walls (m).
const WALL: Real = 1.0;

/// Returns a box with these half extents, in both dimensions.
pub fn block(half: Vector) -> ColliderBuilder {
    ColliderBuilder::new(SharedShape::new(Cuboid::new(half)))
}

/// Builds the room, with the floor at y = 0 and fixed walls.
pub fn build(world: &mut PhysicsWorld, choices: &mut Choices<'_>) {
    lay_floor(world, SIZE + 2.0 * WALL, choices);
    let center = Vector::Y * SIZE;
    for axis in Vector::AXES {
        for side in [1.0, -1.0] {
            if axis == Vector::Y && side < 0.0 {
                continue;
            }
            let half = Vector::splat(SIZE + 2.0 * WALL) * (Vector::ONE - axis) + axis * WALL;
            let wall = block(half).translation(center + axis * (side * (SIZE + WALL)));
            world.insert_collider(wall.restitution(0.5), None);
        }
    }
}

/// Returns whether a point is farther outside the room than the largest penetration of its walls.
pub fn is_outside(at: Vector, depth_max: Real) -> bool {
    let from_center = (at - Vector::Y * SIZE).abs();
    at.y < -depth_max || from_center.max_element() > SIZE + WALL
}
