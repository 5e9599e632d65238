//! Mechanics of multibodies.
//!
//! As in `physics` and `joints`, the tests check formulas at several lengths of a step, and print the
//! figures.

pub mod stage;

mod bounces;
mod contacts;
mod drives;
mod early;
mod edits;
mod energy;
mod excluded;
mod extremes;
mod free;
mod gears;
mod inverse;
mod laws;
mod locked_inertia;
mod loops;
mod momentum;
mod nonsense;
mod pendulum;
mod repeat;
