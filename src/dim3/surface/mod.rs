//! Methods with a parameter per axis of 3D space.

mod body;
mod collider;
pub mod joint;
