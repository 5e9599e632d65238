//! # Base: tools without physics
//!
//! The lowest level: no import of another room.

pub mod arena;
pub mod axis;
pub(crate) mod blocks;
pub mod bvh;
pub mod closest;
pub mod disjoint;
pub(crate) mod facing;
pub(crate) mod farthest;
pub(crate) mod fault;
pub(crate) mod feature;
pub(crate) mod guard;
pub(crate) mod hash;
pub(crate) mod held;
pub(crate) mod id_set;
pub(crate) mod in_place;
pub(crate) mod late;
pub(crate) mod loading;
pub(crate) mod marks;
pub(crate) mod measure;
pub mod nearest;
pub(crate) mod planar_hull;
pub(crate) mod planar_width;
pub mod segments;
pub mod square;
pub(crate) mod symmetric;
pub mod tasks;
pub mod timer;
pub mod trig;
pub(crate) mod turning;
pub(crate) mod unique;
pub mod walk;
pub mod wide;
#[cfg(test)]
pub mod random;
#[cfg(feature = "debug-render")]
pub(crate) mod outline;
#[cfg_attr(feature = "parry026", path = "parry026.rs")]
#[cfg_attr(not(feature = "parry026"), path = "parry031.rs")]
pub(crate) mod parry_version;
pub(crate) mod pool;
#[cfg(feature = "serde-serialize")]
pub(crate) mod plain_shape;
