//! Hundreds of ragdolls fall on hills.

use super::ragdolls::add_ragdoll;
use crate::common::{Dice, Law, Scene, SceneInfo};
use crate::kit::{HALF_TURN, hills, surface};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "ragdoll_rain",
    description: "390 ragdolls of 11 bodies each fall on a mesh of 20,000 triangles.",
    category: Category::Stress,
    steps: 300,
    law: Law { overlap_max: 0.02, height_min: -2.0, reach_max: 25.0, gap_max: 0.02, ..Law::NONE },
    source: file!(),
    build,
};

/// Number of squares of two triangles along each side, and their length.
const SQUARES: u32 = 100;
const SIZE: Real = 0.8;
/// Number of ragdolls per row.
const ROW: usize = 14;

/// Builds the scene.
pub fn build() -> Scene {
    build_sized(390)
}

/// Builds the scene with this many ragdolls.
pub fn build_sized(people: usize) -> Scene {
    let mut world = PhysicsWorld::new();
    world.insert(RigidBodyBuilder::fixed(), surface(SQUARES, SIZE, height));
    let mut dice = Dice::new(11);
    for i in 0..people {
        let [x, z] = [i % ROW, i / ROW % ROW].map(|n| 2.2 * (n as Real - 0.5 * ROW as Real));
        let y = height(x, z) + 2.0 + 2.2 * (i / (ROW * ROW)) as Real;
        let axis = Vector::new(dice.between(-1.0, 1.0), 1.0, dice.between(-1.0, 1.0)).normalize();
        let turn = axis * dice.between(0.0, 2.0 * HALF_TURN);
        add_ragdoll(&mut world, Pose::new(Vector::new(x, y, z), turn), axis * 4.0);
    }
    Scene::new(world, View::orbit(28.0, 40.0))
}

/// Returns the height of the ground.
fn height(x: Real, z: Real) -> Real {
    hills(1.2, x, z)
}
