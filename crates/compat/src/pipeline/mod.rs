//! Steps, queries, events and hooks.

mod collision;
mod events;
mod hooks;
mod physics;
mod queries;

pub use collision::CollisionPipeline;
#[cfg(feature = "debug-render")]
pub use engine::pipeline::{
    DebugColor, DebugRenderBackend, DebugRenderMode, DebugRenderObject, DebugRenderPipeline,
    DebugRenderStyle,
};
pub use engine::pipeline::{ActiveEvents, ActiveHooks, QueryFilterFlags};
pub use events::{ChannelEventCollector, EventHandler};
pub use hooks::{ContactModificationContext, PairFilterContext, PhysicsHooks};
pub use physics::PhysicsPipeline;
pub use queries::{QueryFilter, QueryPipeline, QueryPipelineMut};
