//! 2D in single precision.

use rapier2d as rapier;
use scene2d as scene;

#[path = "binding/mod.rs"]
pub mod binding;
#[path = "space/flat.rs"]
mod space;
