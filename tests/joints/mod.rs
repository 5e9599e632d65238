//! Mechanics of joints: locked axes, motion, motors, limits and breaking.
//!
//! As in `physics`, the tests check formulas at several lengths of a step, and print the figures.

pub mod stage;

mod agreement;
mod breaking;
mod chains;
mod determinism;
mod edits;
mod impacts;
mod limits;
pub mod momentum;
mod motors;
mod nets;
mod nonsense;
pub mod pendulum;
mod sliding;
mod springs;
mod stiff;
mod transmissions;
mod wrecking_ball;
mod turning;
mod twice;
