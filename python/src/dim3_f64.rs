//! 3D in double precision.

use rapier3d_f64 as rapier;

#[path = "binding/mod.rs"]
pub mod binding;
#[path = "space/solid.rs"]
mod space;
