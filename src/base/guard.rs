//! Catches panics of parry, whose assertions cannot be predicted.

use std::panic::{AssertUnwindSafe, catch_unwind};

/// Runs `work`; `None` if it panicked.
///
/// Only for geometry algorithms of parry with assertions about rounding, which no check of the input can
/// predict. These are the convex hull in 3D and its users, and queries between two shapes. Data that `work`
/// changes must not be used after a panic, or must be valid at any time.
///
/// If panics abort the process, there is no protection.
pub(crate) fn guarded<T>(work: impl FnOnce() -> T) -> Option<T> {
    catch_unwind(AssertUnwindSafe(work)).ok()
}
