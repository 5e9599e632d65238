//! # The API of Rapier over this engine
//!
//! Most programs for Rapier 0.32 and 0.36 compile against the crates of these versions without edits. The
//! table in `docs/guide/migration.md` lists the differences. The crates are facades: they store no simulation
//! state of their own, and they forward to the engine.
//!
//! Types with equal signatures are the engine's own types. Types with other signatures are transparent
//! wrappers that dereference to the engine's type. A contact pair is converted to upstream's representation
//! when it is read. The same holds when it is passed to an event handler or a hook of the program. The
//! handlers `()` and [`ChannelEventCollector`](pipeline::ChannelEventCollector) read no pair, so they convert
//! none.

pub extern crate nalgebra as na;
pub use engine::parry;
pub use parry::glamx;
#[cfg(feature = "parallel")]
pub use rayon;

/// The version of Rapier whose API the crate has.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");

mod components;
mod wrapper;

pub mod control;
pub mod counters;
pub mod data;
pub mod dynamics;
pub mod geometry;
pub mod math;
pub mod pipeline;
pub mod utils;

/// The names that most programs use.
pub mod prelude {
    pub use crate::dynamics::*;
    pub use crate::geometry::*;
    pub use crate::math::*;
    pub use crate::pipeline::*;
    pub use na::{point, vector};
    pub extern crate nalgebra;
}
