//! Steps, queries, events and hooks.

mod collision;
mod events;
mod hooks;
mod physics;
mod queries;

pub use collision::CollisionPipeline;
pub use engine::pipeline::{ActiveEvents, ActiveHooks, QueryFilterFlags};
#[cfg(feature = "debug-render")]
pub use engine::pipeline::{
    DebugColor, DebugRenderBackend, DebugRenderMode, DebugRenderObject, DebugRenderPipeline,
    DebugRenderStyle,
};
pub use events::{ChannelEventCollector, EventHandler};
pub use hooks::{ContactModificationContext, PairFilterContext, PhysicsHooks};
pub use physics::PhysicsPipeline;
pub use queries::{QueryFilter, QueryPipeline, QueryPipelineMut};
