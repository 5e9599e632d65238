//! Data structures for programs: lists whose elements have generational indices, and graphs.

pub mod arena;
mod coarena;
pub mod graph;
mod modified_objects;
pub mod pubsub;

pub use arena::{Arena, Index};
pub use coarena::Coarena;
pub use modified_objects::{HasModifiedFlag, ModifiedObjects};
