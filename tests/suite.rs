//! The integration tests, shared by all crates.
//!
//! A crate's root (`crates/*/tests/suite.rs`) links the crate under the name `rapier` and selects the
//! definitions `dim` of its dimension. Each test is therefore written once and runs four times: in 2D and 3D,
//! in single and double precision.

mod allocations;
mod determinism;
mod api;
pub mod ghosts;
pub mod characters;
mod complaints;
mod ccd;
mod edits;
pub mod hostile;
pub mod joints;
pub mod multibody;
pub mod physics;
mod queries;
pub mod shapes;
mod worlds;
