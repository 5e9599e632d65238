//! Elements of handles.

pub use crate::base::arena::Index;
