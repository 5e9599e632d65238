//! Ghost contacts: flat ground of any pieces has no edges.
//!
//! Bodies must not catch on internal edges between triangles, cells, parts, colliders or bodies of one
//! surface. Real edges, steps and gaps must have their effect.

mod corners;
mod edges;
pub mod lay;
mod rolling;
mod sliding;
mod valleys;
