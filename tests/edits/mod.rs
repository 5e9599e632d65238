//! # Edits
//!
//! Setters and set operations, family by family: conservation of velocities, causes of waking, edits that
//! change nothing, and locked axes. Each test goes through a table of edits and prints its outcome.

mod locks;
mod mass;
mod motions;
mod same;
mod stage;
mod waking;
