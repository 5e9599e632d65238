//! Families: worlds of one kind, and the law that each of them obeys.
//!
//! The acts of [`super::play`] combine everything with everything, so little can be said about the outcome. A family has a generator, which reads a scene
//! from the bytes, and an invariant, which is checked after each step. It stays within what the guide promises. A string of bytes is
//! a sequence of scenes.

mod closed;
mod crowds;
mod driven;
mod room;
mod thrown;
mod trees;

use super::rapier;
use super::{colliders, dim, thin, values, world};
use crate::choices::Choices;
use crate::{FAMILIES, Tally};

/// Builds one scene from the bytes, runs it, and checks the invariant. Returns the number of steps.
///
/// # Panics
/// If the invariant is violated.
type Family = fn(&mut Choices<'_>) -> Tally;

/// In the order of their names.
const RUNS: [Family; FAMILIES.len()] =
    [closed::run, thrown::run, driven::run, trees::run, crowds::run];

/// More scenes than this take longer than a string of acts.
const SCENES_MAX: usize = 2;

/// Runs scenes of one family until the bytes are used up, but no more than a few.
pub fn run(family: usize, mut choices: Choices<'_>) -> Tally {
    let mut tally = Tally::default();
    for _ in 0..SCENES_MAX {
        if choices.is_over() {
            break;
        }
        choices.tell(|| format!("a scene of the family `{}`", FAMILIES[family]));
        tally.add(RUNS[family](&mut choices));
    }
    tally
}
