//! # Guarantees of the public API
//!
//! Events, hooks, groups, reading of contacts, edits between steps, collision detection alone, and worlds
//! that are saved and restored.

pub mod stage;

mod contacts;
pub mod detection;
mod edits;
mod events;
mod filters;
mod forces;
mod hooks;
mod late;
mod names;
mod sensors;
mod worlds;
