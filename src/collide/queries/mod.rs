//! # Queries of two shapes, and of a ray and a shape
//!
//! Intersection, distance, contact, closest points and casts of any two shapes, and rays. The queries of the
//! world, sensors and controllers use [`Dispatcher`], which has a result for each pair of shapes.
//!
//! | file | content |
//! |---|---|
//! | `dispatcher.rs` | parry's interface, with a result for every pair |
//! | `pair_query.rs` | reduction of composite shapes to pairs of *plain* parts (convex shapes and half-spaces) |
//! | `surroundings.rs` | lower bounds for boxes around parts |
//! | `inside.rs` | surfaces with a solid inside |
//! | `nearest.rs` | the nearest point of a shape |
//! | `plain.rs` | pairs of plain parts |
//! | `balls.rs`, `cuboid.rs`, `hull.rs`, `rounded.rs` | formulas for casts of balls: a moving point against a shape with a layer around it |
//! | `convex_cast.rs` | casts of other convex shapes |
//! | `entry.rs` | the first touch of two convex shapes on a line |
//! | `turning.rs` | casts of rotating shapes |
//! | `rays.rs` | rays |

mod balls;
mod convex_cast;
mod cuboid;
mod dispatcher;
mod entry;
mod hull;
mod inside;
mod layer;
mod nearest;
mod pair_query;
mod plain;
mod rays;
mod rounded;
mod surroundings;
#[cfg(test)]
mod tests;
mod turning;

pub(crate) use dispatcher::{Dispatcher, shapes_intersect};
pub(crate) use nearest::nearest_point;
pub(super) use plain::distance;
pub(crate) use rays::{intersection, time_of_impact};
