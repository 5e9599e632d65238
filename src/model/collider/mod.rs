//! Colliders.

mod handle;

pub use handle::ColliderHandle;
