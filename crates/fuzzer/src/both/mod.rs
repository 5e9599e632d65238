//! Code that is compiled for all four crates.

use super::dim;
use super::drive;
use super::rapier;
use super::thin;

mod acts;
mod bodies;
mod colliders;
mod event_checker;
mod families;
pub mod groups;
mod isolated_bodies;
mod joints;
mod loading;
mod multibodies;
pub mod play;
mod queries;
mod sets;
mod steps;
pub mod values;
mod walkers;
mod world_copy;
// The tests of hostile users define the invariants of every world.
#[path = "../../../../tests/hostile/world.rs"]
mod world;
#[path = "../../../../tests/worlds/damage.rs"]
mod damage;
#[path = "../../../../tests/worlds/forged.rs"]
pub mod forged;
#[path = "../../../../tests/worlds/sets.rs"]
mod saved;
#[path = "../../../../tests/worlds/tree.rs"]
mod tree;

use crate::choices::Choices;
use crate::{KINDS, Tally, family_of};

/// Runs the operations of the bytes on a world.
///
/// # Panics
/// If an invariant is violated.
pub fn run(bytes: &[u8]) -> Tally {
    let mut choices = Choices::new(bytes);
    match family_of(choices.below(KINDS)) {
        Some(family) => families::run(family, choices),
        None => acts::run(choices),
    }
}
