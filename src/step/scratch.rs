//! Buffers of the stages, and settings of a pipeline.

use super::notes::StepNotes;
use super::trace::{StageTrace, StepStage};
use super::{broad_phase, ccd, finalize_bodies, islands, narrow_phase, quarantine, solver};
use crate::base::tasks::Threads;
use crate::base::wide::Simd;

/// Buffers that are reused from step to step, and settings of steps. They contain no state of the world.
#[derive(Default)]
pub(crate) struct StepScratch {
    pub(super) notes: StepNotes,
    pub(super) broad_phase: broad_phase::BroadPhaseScratch,
    pub(super) narrow_phase: narrow_phase::NarrowPhaseScratch,
    pub(super) solver: solver::SolverScratch,
    pub(super) quarantine: quarantine::Quarantine,
    pub(super) ccd: ccd::CcdScratch,
    pub(super) finalize: finalize_bodies::FinalizeScratch,
    pub(super) sleep: islands::SleepScratch,
    pub(super) trace: StageTrace,
    pub(super) simd: Simd,
    pub(super) threads: Threads,
}

impl StepScratch {
    /// Runs steps on these threads.
    pub fn set_threads(&mut self, threads: Threads) {
        self.threads = threads;
    }

    /// Enables or disables the hashes of the world after each stage.
    pub fn trace_stages(&mut self, enabled: bool) {
        self.trace.enable(enabled);
    }

    /// The hashes of the last step.
    pub fn stage_hashes(&self) -> &[(StepStage, u64)] {
        self.trace.hashes()
    }

    /// Selects the widest instructions of the machine for the solver, or the baseline of its architecture.
    pub fn set_wide_instructions(&mut self, wide: bool) {
        self.simd = if wide { Simd::detect() } else { Simd::baseline() };
    }
}
