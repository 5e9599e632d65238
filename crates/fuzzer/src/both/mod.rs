//! What is done in all four crates in the same words.

use super::dim;
use super::rapier;

mod bodies;
mod bystanders;
mod closed;
pub mod colliders;
mod joints;
mod loading;
mod multibodies;
pub mod play;
mod questions;
mod sets;
mod steps;
pub mod values;
mod walkers;
mod witness;
// What must hold in every world: the tests of hostile users say it once for all.
#[path = "../../../../tests/hostile/world.rs"]
mod world;
#[path = "../../../../tests/worlds/damage.rs"]
mod damage;
#[path = "../../../../tests/worlds/sets.rs"]
mod saved;
#[path = "../../../../tests/worlds/tree.rs"]
mod tree;

use crate::Tally;
use crate::choices::Choices;

/// Does to a world what the bytes say.
///
/// # Panics
/// If anything is not in order.
pub fn run(bytes: &[u8]) -> Tally {
    let mut choices = Choices::new(bytes);
    if choices.below(8) == 7 {
        return closed::run(choices);
    }
    play::run(choices)
}
