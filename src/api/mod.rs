//! # API: public module paths and facades
//!
//! The documented module paths (`dynamics`, `geometry`, `pipeline`, `control`, `math`, `prelude`) re-export
//! public names from their modules. The facades [`pipeline::PhysicsPipeline`],
//! [`pipeline::CollisionPipeline`] and [`pipeline::PhysicsWorld`] unpack the documented parameter lists once.
//! `snapshot/` saves and loads worlds, and `recording/` records their steps.

mod collision_pipeline;
mod physics_pipeline;
#[cfg(feature = "serde-serialize")]
mod recording;
#[cfg(feature = "serde-serialize")]
mod snapshot;
mod world;
mod world_queries;

pub mod control;
pub mod data;
pub mod dynamics;
pub mod geometry;
pub mod math;
pub mod pipeline;
pub mod prelude;

#[cfg(test)]
mod tests;
