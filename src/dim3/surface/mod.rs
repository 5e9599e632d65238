//! Methods whose signature has something for each axis of 3D space.

mod body;
mod collider;
pub mod joint;
