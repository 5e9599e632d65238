//! Scrap in a yard, stirred by a blade: polygons in motion, with new contacts in every step.

use crate::common::{Dice, Law, Scene, SceneInfo};
use crate::kit::{add, add_walls, square, stone, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "junkyard",
    description: "A blade stirs a yard with 8,000 pieces of scrap.",
    category: Category::Stress,
    steps: 240,
    law: Law { overlap_max: 0.5, height_min: 0.0, reach_max: 54.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Number of pieces per row, and their distance.
const COLUMNS: usize = 100;
const SPACING: Real = 0.95;

/// Builds the scene.
pub fn build() -> Scene {
    build_sized(8000)
}

/// Builds a yard with this many pieces of scrap.
pub fn build_sized(pieces: usize) -> Scene {
    let mut world = world_with_floor(200.0);
    let width = COLUMNS as Real * SPACING;
    add_walls(&mut world, 0.5 * width + 1.0, 100.0);
    let mut dice = Dice::new(17);
    let kinds = scrap(&mut dice);
    for i in 0..pieces {
        let [column, row] = [i % COLUMNS, i / COLUMNS].map(|n| n as Real);
        let place = Vector::new((column + 0.5) * SPACING - 0.5 * width, 0.6 + 0.9 * row);
        let kind = dice.below(kinds.len());
        add(&mut world, place, kinds[kind].clone());
    }
    let height = pieces as Real / COLUMNS as Real;
    let blade = RigidBodyBuilder::kinematic_velocity_based()
        .translation(Vector::Y * (0.4 * height + 1.0))
        .angvel(0.7);
    world.insert(blade, ColliderBuilder::cuboid(0.4 * height, 0.1));
    Scene::new(world, View::flat())
}

/// Returns shapes of stones, beams, plates and balls.
fn scrap(dice: &mut Dice) -> Vec<ColliderBuilder> {
    let stones: Vec<_> =
        (0..8).filter_map(|_| ColliderBuilder::convex_hull(&stone(dice, 0.42, 7))).collect();
    let mut kinds = vec![
        ColliderBuilder::cuboid(0.42, 0.12),
        square(0.3),
        ColliderBuilder::capsule_x(0.25, 0.15),
        ColliderBuilder::ball(0.35),
    ];
    kinds.extend(stones);
    kinds
}
