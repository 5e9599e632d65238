//! The step, and its user interfaces.

pub use super::collision_pipeline::CollisionPipeline;
pub use super::physics_pipeline::PhysicsPipeline;
#[cfg(feature = "serde-serialize")]
pub use super::recording::{
    Difference, Divergence, Recorder, RecordingError, Replay, ReplayError, Replayed,
    compare_recordings,
};
#[cfg(feature = "serde-serialize")]
pub use super::snapshot::{SnapshotError, apply_snapshot_delta, snapshot_delta};
pub use super::world::PhysicsWorld;
pub use crate::base::tasks::{Threads, ThreadsError};
pub use crate::base::timer::Timer;
pub use crate::controllers::QueryPipelineMut;
#[cfg(feature = "debug-render")]
pub use crate::debug_render::{
    DebugColor, DebugRenderBackend, DebugRenderMode, DebugRenderObject, DebugRenderPipeline,
    DebugRenderStyle,
};
pub use crate::model::collider::{ActiveEvents, ActiveHooks};
pub use crate::model::counters::{
    CCDCounters, CollisionDetectionCounters, Counters, SolverCounters, StagesCounters,
};
pub use crate::model::event::{
    ChannelEventCollector, DefaultEventHandler, EventHandler, JointBreakEvent, QuarantineEvent,
};
pub use crate::model::hooks::{
    ContactModificationContext, DefaultHooks, PairFilterContext, PhysicsHooks,
};
pub use crate::query::{
    QueryFilter, QueryFilterFlags, QueryPipeline, QueryPredicate, QueryView, cast_ray_on_shape,
};
pub use crate::step::StepStage;
