//! Scrap in a yard, moved by a blade: hulls in motion, with new contacts in every step.

use crate::common::{Dice, Law, Scene, SceneInfo};
use crate::kit::{add, add_walls, rock, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "junkyard",
    description: "A blade sweeps through a yard with 4,000 pieces of scrap.",
    category: Category::Stress,
    steps: 240,
    law: Law { overlap_max: 0.5, height_min: 0.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Distance of the yard's walls from its middle.
const YARD: Real = 16.0;

/// Builds the scene.
pub fn build() -> Scene {
    build_sized(4000)
}

/// Builds a yard with this many pieces of scrap.
pub fn build_sized(pieces: usize) -> Scene {
    let mut world = world_with_floor(100.0);
    add_walls(&mut world, YARD, 4.0);
    let mut dice = Dice::new(17);
    let kinds = scrap(&mut dice);
    let (side, spacing) = (23, 1.3);
    for i in 0..pieces {
        let center = (side - 1) as Real / 2.0;
        let [x, y, z] = [i % side, i / (side * side), i / side % side].map(|n| n as Real);
        let place = Vector::new(spacing * (x - center), 3.2 + 1.1 * y, spacing * (z - center));
        let kind = dice.below(kinds.len());
        add(&mut world, place, kinds[kind].clone());
    }
    let blade = RigidBodyBuilder::kinematic_velocity_based()
        .translation(Vector::Y * 1.2)
        .angvel(Vector::Y * 0.7);
    world.insert(blade, ColliderBuilder::cuboid(YARD - 1.0, 1.1, 0.4));
    Scene::new(world, View::orbit(30.0, 40.0))
}

/// Returns shapes of rocks, beams and plates.
fn scrap(dice: &mut Dice) -> Vec<ColliderBuilder> {
    let rocks: Vec<_> =
        (0..8).filter_map(|_| ColliderBuilder::convex_hull(&rock(dice, 0.55, 10))).collect();
    let mut kinds = vec![
        ColliderBuilder::cuboid(0.55, 0.15, 0.2),
        ColliderBuilder::cuboid(0.5, 0.1, 0.45),
        ColliderBuilder::cylinder(0.4, 0.3),
    ];
    kinds.extend(rocks);
    kinds
}
