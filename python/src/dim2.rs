//! 2D in single precision.

use rapier2d as rapier;

#[path = "binding/mod.rs"]
pub mod binding;
#[path = "space/flat.rs"]
mod space;
