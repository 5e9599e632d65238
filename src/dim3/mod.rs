//! The vocabulary of three dimensions.
//!
//! Files with the same name have the same role in `dim2/`. `gyroscopic.rs` and `collide/cuboid_faces.rs`
//! exist here only, so the difference of the two folders is the difference between the two engines.

pub mod collide;
pub mod axes;
pub mod decomposition;
pub mod facets;
pub mod field;
pub mod flat_hull;
pub mod hull;
pub(crate) mod joint_angle;
pub mod joint_axes;
pub mod names;
pub mod repair;
pub mod mask;
pub mod mass;
pub mod math;
#[cfg(feature = "serde-serialize")]
pub mod saved;
pub mod shapes;
#[allow(dead_code, reason = "the same words in both dimensions; not each is needed in both")]
pub mod spatial;
// Vehicles drive in 3D only, so this dimension declares the module.
#[path = "../controllers/vehicle/mod.rs"]
pub mod vehicle;
#[allow(dead_code, reason = "the same words in both dimensions; not each is needed in both")]
pub mod wide;
pub mod surface;
pub mod width;

pub(crate) mod contact;
pub(crate) mod joint;
pub(crate) mod state;
pub(crate) mod motion;
mod gyroscopic;
pub(crate) mod rotation_vector;
#[cfg(feature = "debug-render")]
pub(crate) mod outline;
