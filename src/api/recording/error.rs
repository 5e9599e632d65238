//! Errors of a recording, and of its replay.

use crate::api::snapshot::SnapshotError;
use crate::model::body::RigidBodyHandle;
use crate::step::StepStage;

/// Error of writing or reading a recording.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum RecordingError {
    /// The first bytes are not those of a recording.
    #[error("the data does not begin as a recording does")]
    NotARecording,
    /// Another version of the format wrote the recording.
    #[error("the recording has format {found}; this version of the engine reads format {expected}")]
    Format {
        /// The recording's format.
        found: u16,
        /// The format of this version.
        expected: u16,
    },
    /// The data before the steps is damaged.
    #[error("the opening of the recording: {reason}")]
    Opening {
        /// The defect, with the value.
        reason: String,
    },
    /// A snapshot in the recording cannot be made or restored.
    #[error(transparent)]
    Snapshot(#[from] SnapshotError),
    /// The data of a step is damaged. A truncated file ends with this error; the steps before it can be
    /// replayed.
    #[error("step {step}: {reason}")]
    Damaged {
        /// The step, counted from 0.
        step: usize,
        /// The error, with the value.
        reason: String,
    },
}

/// The step at which a replay left the recorded run.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Divergence {
    /// The step, counted from 0.
    pub step: usize,
    /// The first stage after which the hashes differ, if the recording has [those of
    /// stages](super::Recorder::with_stage_hashes).
    pub stage: Option<StepStage>,
    /// The first body, in the order of handles, whose hash differs. `None` if the difference is in a joint, a
    /// pair or a collider alone.
    pub body: Option<RigidBodyHandle>,
    /// The recorded hash of the world.
    pub expected: u64,
    /// The hash of the replayed world.
    pub found: u64,
}

impl core::fmt::Display for Divergence {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let Self { step, stage, body, expected, found } = self;
        write!(f, "step {step} has the hash {found:016x} instead of {expected:016x}")?;
        if let Some(stage) = stage {
            write!(f, "; the first stage that differs is {stage:?}")?;
        }
        match body {
            Some(body) => write!(f, "; the first body that differs is {body:?}"),
            None => write!(f, "; no body differs, but a joint, a pair or a collider does"),
        }
    }
}

/// The reason why a replay ended.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ReplayError {
    /// The recording is damaged.
    #[error(transparent)]
    Recording(#[from] RecordingError),
    /// The replayed world differs from the recorded one.
    #[error("{0}")]
    Diverged(Divergence),
}

impl From<SnapshotError> for ReplayError {
    fn from(error: SnapshotError) -> Self {
        Self::Recording(error.into())
    }
}
