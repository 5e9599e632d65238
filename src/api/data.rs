//! What handles are made of.

pub use crate::base::arena::Index;
