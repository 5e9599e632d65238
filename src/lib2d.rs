//! 2D rigid-body physics.

#[cfg(feature = "parry2d-f64")]
pub extern crate parry2d_f64 as parry;
#[cfg(not(feature = "parry2d-f64"))]
pub use ::parry;

mod dim2;
use dim2 as dim; // the one line that decides the dimension

mod base;
mod model;
mod step;
#[cfg(feature = "debug-render")]
mod debug_render;
mod api;

pub use api::{data, dynamics, geometry, math, pipeline, prelude};
