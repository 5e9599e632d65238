//! 2D in double precision.

use rapier2d_f64 as rapier;
use scene2d_f64 as scene;

#[path = "binding/mod.rs"]
pub mod binding;
#[path = "space/flat.rs"]
mod space;
