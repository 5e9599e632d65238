//! Times and counts of a step.

pub use engine::pipeline::{
    CCDCounters, CollisionDetectionCounters, Counters, SolverCounters, StagesCounters, Timer,
};
