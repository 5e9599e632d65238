//! Mechanics of multibodies.
//!
//! Like `physics` and `joints`: formulas, at several lengths of a step, with the figures printed.

pub mod stage;

mod bounces;
mod contacts;
mod drives;
mod edits;
mod energy;
mod extremes;
mod free;
mod gears;
mod inverse;
mod laws;
mod loops;
mod nonsense;
mod pendulum;
mod repeat;
mod whole;
