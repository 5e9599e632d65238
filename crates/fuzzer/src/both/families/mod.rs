//! Families: worlds of one kind, each with an invariant.
//!
//! The operations of [`super::acts`] combine all features, so few statements about the outcome are possible.
//! A family has a generator, which reads a scene from the bytes, and an invariant, which is checked after
//! each step. The scenes stay within the limits of the guide. A string of bytes is a sequence of scenes.

mod closed;
mod crowds;
mod driven;
mod room;
mod thrown;
mod trees;

use super::rapier;
use super::{dim, groups, thin, values, world};
use crate::choices::Choices;
use crate::{FAMILIES, Tally};

/// Builds one scene from the bytes, runs it, and checks the invariant. Returns the number of steps.
///
/// # Panics
/// If the invariant is violated.
type Family = fn(&mut Choices<'_>) -> Tally;

/// Functions in the order of the families' names.
const RUNS: [Family; FAMILIES.len()] =
    [closed::run, thrown::run, driven::run, trees::run, crowds::run];

/// Largest number of scenes per string. More scenes take longer than a string of operations.
const SCENES_MAX: usize = 2;

/// Runs scenes of one family until the bytes are used up, up to a limit.
pub fn run(family: usize, mut choices: Choices<'_>) -> Tally {
    let mut tally = Tally::default();
    for _ in 0..SCENES_MAX {
        if choices.is_over() {
            break;
        }
        choices.print(|| format!("a scene of the family `{}`", FAMILIES[family]));
        tally.add(RUNS[family](&mut choices));
    }
    tally
}
