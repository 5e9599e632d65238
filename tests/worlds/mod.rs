//! # Whole worlds
//!
//! Operations on whole sets of a world: they are replaced by those of other worlds, saved, loaded, and loaded
//! from damaged data. Nothing here depends on the dimension.

// The fuzzer compiles `sets` as well, under another parent.
#[cfg(feature = "serde-serialize")]
use crate::rapier;

mod records;
mod rollback;
mod scene;
mod twins;
// Saving is a feature.
#[cfg(feature = "serde-serialize")]
mod damage;
#[cfg(feature = "serde-serialize")]
mod damaged;
#[cfg(feature = "serde-serialize")]
mod forged;
#[cfg(feature = "serde-serialize")]
mod own_shape;
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
