//! Mechanics of contacts: laws of physics on whole worlds.
//!
//! Each test states a formula and a tolerance for each length of a step. It runs at 30, 60 and 240 steps per
//! second, and prints the figures (`cargo test -p rapier3d --test suite -- --nocapture`).

pub mod stage;
pub mod table;

mod bounce;
mod carriers;
mod changing_steps;
mod determinism;
mod fall;
mod friction;
mod impact_energy;
mod impact_rules;
mod impacts;
mod large_floors;
mod load;
mod lost_support;
mod massless;
mod momentum;
mod pushes;
mod sleeping;
mod stacks;
mod tipping;
mod welded;
