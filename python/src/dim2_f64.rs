//! 2D in double precision.

use rapier2d_f64 as rapier;

#[path = "binding/mod.rs"]
pub mod binding;
#[path = "space/flat.rs"]
mod space;
