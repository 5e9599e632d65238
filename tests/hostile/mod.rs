//! # Hostile users
//!
//! Everything here tries to break the engine through its public API. Whatever is done, nothing may
//! panic (but `Index` on a handle that a set does not hold), no number in the world may stop being
//! finite, what is refused is named in an error or in the log, and bodies that have nothing to do with
//! it must not notice: they end bit for bit where they would have ended.
//!
//! These users are invented. One without sense is in `crates/fuzzer`, with the same [`world::check`].

use crate::rapier;

pub mod listener;
mod random;
mod scene;
pub mod values;
/// The fuzzer's own.
#[allow(dead_code, reason = "here all events are heard")]
#[path = "../../crates/fuzzer/src/both/witness.rs"]
mod witness;
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
