//! Methods whose signature has something for each axis of the plane.

mod body;
mod collider;
pub mod joint;
