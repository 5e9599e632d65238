//! Steps, queries, events and hooks.

mod collision;
#[cfg(feature = "debug-render")]
mod debug;
mod events;
mod filter_flags;
mod hooks;
mod physics;
mod queries;

pub use collision::CollisionPipeline;
#[cfg(feature = "debug-render")]
pub use debug::{DebugRenderMode, DebugRenderPipeline};
pub use engine::pipeline::{ActiveEvents, ActiveHooks};
#[cfg(feature = "debug-render")]
pub use engine::pipeline::{DebugColor, DebugRenderBackend, DebugRenderObject, DebugRenderStyle};
pub use events::{ChannelEventCollector, EventHandler};
pub use filter_flags::QueryFilterFlags;
pub use hooks::{ContactModificationContext, PairFilterContext, PhysicsHooks};
pub use physics::PhysicsPipeline;
pub use queries::{QueryFilter, QueryPipeline, QueryPipelineMut};
