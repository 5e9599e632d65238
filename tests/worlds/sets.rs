//! Sets of a world, saved and loaded one by one. The fuzzer does the same.

use super::rapier::prelude::*;
use super::tree::{Tree, load, save};

/// Saved sets of a world.
pub type Saved = [Tree; 7];

/// Saves all sets.
pub fn save_all(world: &PhysicsWorld) -> Saved {
    [
        save(&world.bodies),
        save(&world.colliders),
        save(&world.islands),
        save(&world.broad_phase),
        save(&world.narrow_phase),
        save(&world.impulse_joints),
        save(&world.multibody_joints),
    ]
}

/// Loads one set into a world.
pub fn load_into(world: &mut PhysicsWorld, set: usize, tree: &Tree) -> Result<(), String> {
    let refused = |refusal: super::tree::Refusal| refusal.to_string();
    match set {
        0 => load(tree).map(|it| world.bodies = it),
        1 => load(tree).map(|it| world.colliders = it),
        2 => load(tree).map(|it| world.islands = it),
        3 => load(tree).map(|it| world.broad_phase = it),
        4 => load(tree).map(|it| world.narrow_phase = it),
        5 => load(tree).map(|it| world.impulse_joints = it),
        _ => load(tree).map(|it| world.multibody_joints = it),
    }
    .map_err(refused)
}

/// Loads a world, or returns the reason why a set is rejected.
pub fn load_all(saved: &Saved) -> Result<PhysicsWorld, String> {
    let mut world = PhysicsWorld::new();
    for (set, tree) in saved.iter().enumerate() {
        load_into(&mut world, set, tree)?;
    }
    Ok(world)
}
