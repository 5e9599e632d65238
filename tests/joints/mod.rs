//! Do joints hold, swing, drive, stop and break as mechanics says?
//!
//! Like `physics`: formulas, at several lengths of a step, with the figures printed.

pub mod stage;

mod chains;
pub mod pendulum;
