//! Felled trees roll down hills of ever finer triangles.

use crate::common::{Dice, Law, Scene, SceneInfo};
use crate::kit::{HALF_TURN, hills, surface};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const TREES100: SceneInfo =
    info("trees100", "51 felled trees on a mesh with squares of 1 m.", || build(1.0));
/// Entry in the list.
pub const TREES50: SceneInfo =
    info("trees50", "51 felled trees on a mesh with squares of 0.5 m.", || build(0.5));
/// Entry in the list.
pub const TREES25: SceneInfo =
    info("trees25", "51 felled trees on a mesh with squares of 0.25 m.", || build(0.25));

/// Length of the ground, and number of trees.
const GROUND: Real = 80.0;
const TREES: usize = 51;

/// Law of all three scenes.
const LAW: Law = Law { overlap_max: 0.02, height_min: -1.0, reach_max: 38.0, ..Law::NONE };

const fn info(name: &'static str, description: &'static str, build: fn() -> Scene) -> SceneInfo {
    let (category, source) = (Category::Stress, file!());
    SceneInfo { name, description, category, steps: 300, law: LAW, source, build }
}

/// Builds the scene with squares of two triangles of this size.
fn build(size: Real) -> Scene {
    let mut world = PhysicsWorld::new();
    let squares = (GROUND / size) as u32;
    world.insert(RigidBodyBuilder::fixed(), surface(squares, size, height));
    let mut dice = Dice::new(5);
    for i in 0..TREES {
        let [x, z] = [i % 8, i / 8].map(|n| 7.0 * (n as Real - 3.5));
        let place = Vector::new(x, height(x, z) + 3.0, z);
        let turn = Vector::new(0.5 * HALF_TURN, 0.0, dice.between(-HALF_TURN, HALF_TURN));
        add_tree(&mut world, Pose::new(place, turn));
    }
    Scene::new(world, View::orbit(28.0, 80.0))
}

/// Adds a trunk with four branches.
fn add_tree(world: &mut PhysicsWorld, at: Pose) {
    let tree = world.insert_body(RigidBodyBuilder::dynamic().pose(at));
    world.insert_collider(ColliderBuilder::capsule_y(2.5, 0.25), Some(tree));
    for k in 0..4 {
        let angle = 0.5 * HALF_TURN * k as Real;
        let start = Vector::Y * (0.5 + 0.5 * k as Real);
        let end = start + Vector::new(angle.cos(), 0.8, angle.sin());
        let branch = ColliderBuilder::capsule_from_endpoints(start, end, 0.12);
        world.insert_collider(branch, Some(tree));
    }
}

/// Returns the height of the ground.
fn height(x: Real, z: Real) -> Real {
    hills(0.8, x, z)
}
