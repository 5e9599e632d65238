//! 3D in double precision.

use rapier3d_f64 as rapier;
use scene3d_f64 as scene;

#[path = "binding/mod.rs"]
pub mod binding;
#[path = "space/solid.rs"]
mod space;
