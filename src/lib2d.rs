//! 2D rigid-body physics.

#[cfg(feature = "parry2d-f64")]
extern crate parry2d_f64 as parry;

mod dim2;
use dim2 as dim; // the one line that decides the dimension

mod base;
mod model;
mod step;
#[cfg(feature = "debug-render")]
mod debug_render;
mod api;
