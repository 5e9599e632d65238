//! Ghost contacts: flat ground of any pieces has no edges.
//!
//! Bodies must not catch on the seams between the triangles, cells, parts, colliders or bodies that make up a
//! surface, and must feel the edges, steps and gaps that are really there.

mod corners;
mod edges;
pub mod lay;
mod rolling;
mod sliding;
mod valleys;
