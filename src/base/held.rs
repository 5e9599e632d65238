//! Panics of the user's code that are resumed after the cleanup.

use core::any::Any;
use core::mem::forget;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};

/// The first panic of some calls.
#[derive(Default)]
#[must_use = "a panic that is held must go on"]
pub(crate) struct HeldPanic(Option<Box<dyn Any + Send>>);

impl HeldPanic {
    /// Calls code that may panic, and continues afterwards. Returns nothing if it panicked.
    pub fn hold<R>(&mut self, work: impl FnOnce() -> R) -> Option<R> {
        match catch_unwind(AssertUnwindSafe(work)) {
            Ok(result) => Some(result),
            Err(panic) => {
                self.join(Self(Some(panic)));
                None
            }
        }
    }

    /// Adds the panic of another one.
    pub fn join(&mut self, other: Self) {
        match self.0 {
            None => self.0 = other.0,
            // To drop it might panic again.
            Some(_) => forget(other),
        }
    }

    /// Resumes the panic, if there was one.
    pub fn release(self) {
        if let Some(panic) = self.0 {
            resume_unwind(panic);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::HeldPanic;
    use std::panic::{AssertUnwindSafe, catch_unwind};

    #[test]
    fn the_first_panic_goes_on_when_all_is_done() {
        let mut done = Vec::new();
        let calls = AssertUnwindSafe(|| {
            let mut held = HeldPanic::default();
            for k in 0..4 {
                let result = held.hold(|| {
                    assert!(k % 2 == 0, "call {k}");
                    k
                });
                done.push(result);
            }
            held.release();
        });
        let panic = catch_unwind(calls).unwrap_err();
        assert_eq!(panic.downcast_ref::<String>().map(String::as_str), Some("call 1"));
        assert_eq!(done, [Some(0), None, Some(2), None]);
    }

    #[test]
    fn release_does_nothing_without_a_panic() {
        let mut held = HeldPanic::default();
        assert_eq!(held.hold(|| 7), Some(7));
        held.release();
    }
}
