//! Do multibodies move as mechanics says?
//!
//! Like `physics` and `joints`: formulas, at several lengths of a step, with the figures printed.

pub mod stage;

mod free;
mod laws;
mod pendulum;
