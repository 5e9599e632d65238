//! Rigid bodies.

mod handle;

pub use handle::RigidBodyHandle;
