//! A pile of 1,000 boxes in a basin, whose steps are timed.

use super::super::dim::{PILE, cuboid, enclose, vec};
use super::super::rapier::prelude::*;
use crate::Step;

/// Builds the pile above the ground, and returns a function that advances it by one step. No box sleeps.
pub fn pile() -> Step {
    let mut world = PhysicsWorld::new();
    let [width, height, depth] = PILE;
    let half = 0.65 * width as Real + 1.0;
    world.insert_collider(cuboid(half, 0.5, half), None);
    for side in [-1.0, 1.0] {
        world.insert_collider(cuboid(0.3, 4.0, half).translation(vec(half * side, 4.0, 0.0)), None);
    }
    enclose(&mut world, half);
    for k in 0..width * height * depth {
        let (column, row, file) = (k % width, k / width % height, k / (width * height));
        // Every other row is shifted, so that boxes rest on edges of others and topple.
        let shift = 0.3 * (row % 2) as Real;
        let place = |k: usize, count: usize| 1.3 * (k as Real - 0.5 * (count - 1) as Real) + shift;
        let at = vec(place(column, width), 1.2 + 1.3 * row as Real, place(file, depth));
        let body = RigidBodyBuilder::dynamic().translation(at).can_sleep(false);
        world.insert(body, cuboid(0.5, 0.5, 0.5));
    }
    Box::new(move || world.step())
}
