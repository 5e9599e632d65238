//! 3D in single precision.

use rapier3d as rapier;
use scene3d as scene;

#[path = "binding/mod.rs"]
pub mod binding;
#[path = "space/solid.rs"]
mod space;
