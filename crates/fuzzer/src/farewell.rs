//! Panics on purpose: what a hook or an event handler of the user does at its worst.
//!
//! They unwind like any panic, but are not announced, so that what is printed, and what a fuzzer counts as a crash,
//! is what nobody meant.

use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};

/// The payload of such a panic.
struct Farewell;

/// Unwinds.
pub fn leave() -> ! {
    resume_unwind(Box::new(Farewell))
}

/// Does something that may [`leave`]: did it come to its end? Other panics go on.
pub fn comes_to_its_end(work: impl FnOnce()) -> bool {
    match catch_unwind(AssertUnwindSafe(work)) {
        Ok(()) => true,
        Err(panic) if panic.is::<Farewell>() => false,
        Err(panic) => resume_unwind(panic),
    }
}

#[cfg(test)]
mod tests {
    use super::{comes_to_its_end, leave};

    #[test]
    fn only_panics_on_purpose_are_caught() {
        assert!(comes_to_its_end(|| {}));
        assert!(!comes_to_its_end(|| leave()));
        let other = std::panic::catch_unwind(|| {
            comes_to_its_end(|| std::panic::resume_unwind(Box::new(1)))
        });
        assert!(other.is_err());
    }
}
