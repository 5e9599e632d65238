//! # Recordings: all inputs of a run in one file
//!
//! A recording begins with a snapshot. For every step it contains the edits of the user before it and the
//! hashes of the world after it. Edits are found by comparison: the world is saved after each step and before
//! the next one, and the difference is stored. Every edit is recorded, by any function, and programs change
//! only the call that steps. A list of calls would be shorter but would miss unlisted calls.
//!
//! * `frame.rs`: the data of a step, and the format of the file.
//! * `recorder.rs`: writes the file of a run.
//! * `replay.rs`: repeats the steps of a file, and compares every hash.
//! * `compare.rs`: finds the first difference of two recordings.

mod compare;
mod error;
mod frame;
mod recorder;
mod replay;

pub use compare::{Difference, compare_recordings};
pub use error::{Divergence, RecordingError, ReplayError};
pub use recorder::Recorder;
pub use replay::{Replay, Replayed};
