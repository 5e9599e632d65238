//! 3D in single precision.

use rapier3d as rapier;

#[path = "binding/mod.rs"]
pub mod binding;
#[path = "space/solid.rs"]
mod space;
