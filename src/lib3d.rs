//! 3D rigid-body physics.

#[cfg(feature = "parry3d-f64")]
pub extern crate parry3d_f64 as parry;
#[cfg(not(feature = "parry3d-f64"))]
pub use ::parry;

mod dim3;
use dim3 as dim; // the one line that decides the dimension

mod base;
mod model;
mod step;
#[cfg(feature = "debug-render")]
mod debug_render;
mod api;

pub use api::{data, dynamics, geometry, math, pipeline, prelude};
