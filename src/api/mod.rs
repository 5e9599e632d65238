//! # API — the public face
//!
//! The documented module paths (`dynamics`, `geometry`, `pipeline`, `math`, `prelude`) gather public
//! names from the rooms where they live.

pub mod data;
pub mod dynamics;
pub mod geometry;
pub mod math;
pub mod pipeline;
pub mod prelude;
