//! Steps, queries, events and hooks.

mod collision;
#[cfg(feature = "debug-render")]
mod debug;
#[cfg(feature = "debug-render")]
mod debug_backend;
#[cfg(all(feature = "debug-render", rapier036))]
mod debug_style;
mod events;
mod filter_flags;
mod hooks;
#[cfg_attr(rapier036, path = "modification036.rs")]
mod modification;
mod one_way;
mod physics;
#[cfg(rapier036)]
mod physics036;
mod queries;
#[cfg(rapier036)]
mod world;
#[cfg(rapier036)]
mod world_queries;

pub use collision::CollisionPipeline;
#[cfg(feature = "debug-render")]
pub use debug::{DebugRenderMode, DebugRenderPipeline};
#[cfg(feature = "debug-render")]
pub use debug_backend::{DebugColor, DebugRenderBackend, DebugRenderObject};
#[cfg(all(feature = "debug-render", rapier036))]
pub use debug_style::DebugRenderStyle;
#[cfg(all(feature = "debug-render", not(rapier036)))]
pub use engine::pipeline::DebugRenderStyle;
pub use engine::pipeline::{ActiveEvents, ActiveHooks};
pub use events::{ChannelEventCollector, EventHandler};
pub use filter_flags::QueryFilterFlags;
pub use hooks::{PairFilterContext, PhysicsHooks};
pub use modification::*;
pub use physics::PhysicsPipeline;
#[cfg(rapier036)]
pub use physics036::Quarantine;
pub use queries::{QueryFilter, QueryPipeline, QueryPipelineMut};
#[cfg(rapier036)]
pub use world::PhysicsWorld;
