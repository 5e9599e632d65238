//! # Whole worlds
//!
//! Operations on whole sets of a world: exchange with other worlds, saving, loading, and loading from damaged
//! data. The tests are independent of the dimension.

// The fuzzer compiles `sets` as well, under another parent.
#[cfg(feature = "serde-serialize")]
use crate::rapier;

pub mod own_shape;
mod records;
mod rollback;
mod scene;
mod twins;
// Saving is an optional feature.
#[cfg(feature = "serde-serialize")]
mod damage;
#[cfg(feature = "serde-serialize")]
mod damaged;
#[cfg(feature = "serde-serialize")]
mod forged;
#[cfg(feature = "serde-serialize")]
mod recordings;
#[cfg(feature = "serde-serialize")]
mod samples;
#[cfg(feature = "serde-serialize")]
mod saved;
#[cfg(feature = "serde-serialize")]
mod snapshots;
#[cfg(feature = "serde-serialize")]
mod sets;
#[cfg(feature = "serde-serialize")]
mod tree;
