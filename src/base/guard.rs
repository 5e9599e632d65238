//! A fence around foreign code whose assertions cannot be foreseen.

use std::panic::{AssertUnwindSafe, catch_unwind};

/// Runs `work`; `None` if it panicked.
///
/// Only for geometry algorithms of parry that contain assertions about how a computation was rounded,
/// so that no check of the input tells beforehand whether they hold (the convex hull in 3D, what is built
/// on it, and queries between two shapes). What `work` changes must not be used after a panic, or be in
/// order whatever happened.
///
/// Where panics abort the process there is no fence.
pub(crate) fn guarded<T>(work: impl FnOnce() -> T) -> Option<T> {
    catch_unwind(AssertUnwindSafe(work)).ok()
}
