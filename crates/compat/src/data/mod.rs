//! Data structures.

pub use engine::data::*;

/// Arenas.
pub mod arena {
    pub use engine::data::Index;
}
