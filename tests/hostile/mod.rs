//! # Hostile users
//!
//! The tests misuse the public API in every possible way. No call may panic, except `Index` on a missing
//! handle, and all numbers in the world stay finite. Rejected input is named in an error or in the log.
//! Unrelated bodies are unaffected: they end bit for bit at the same place.
//!
//! Here the misuse is systematic. `crates/fuzzer` adds random misuse, with the same [`world::check`].

use crate::rapier;

pub mod listener;
mod random;
mod scene;
pub mod values;
/// The fuzzer's event checker.
#[allow(dead_code, reason = "here all events are heard")]
#[path = "../../crates/fuzzer/src/both/event_checker.rs"]
mod event_checker;
mod world;

mod bodies;
mod builders;
mod bursts;
mod colliders;
mod bounds;
mod crowds;
mod edits;
mod exchanged;
mod extremes;
mod handles;
mod hooks;
mod parameters;
mod quarantine;
mod replaced;
mod shapes;
mod weightless;
