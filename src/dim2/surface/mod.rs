//! Methods with a parameter per axis of the plane.

mod body;
mod collider;
pub mod joint;
